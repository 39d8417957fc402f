#pragma once
// Many balls in free flight, stored for speed: what prediction reads of a ball is one cache line, what few need lies apart.

#include <array>
#include <cstdint>
#include <vector>

#include "carom/core/clock.hpp"
#include "carom/core/pages.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// What prediction reads: the state of a ball at its stored time. One cache line.
template <int D>
struct alignas(64) Flight {
  double x[D];  ///< [length unit] wrapped into the cell of a periodic space
  double v[D];  ///< [length unit / L]
  std::int64_t epoch;
  double offset;

  [[nodiscard]] CAROM_INLINE Time<double> time() const { return {epoch, offset}; }
};

/// What only collisions need of a ball.
struct Past {
  enum : std::uint8_t { hit = 1, in_contact = 2, last_was_wall = 4 };

  std::int32_t image[3];        ///< periods counted out of the stored position
  std::uint32_t number;         ///< of the ball
  std::uint16_t species;        ///< row of Swarm::species
  std::uint8_t flags;           ///< hit: it has collided; in_contact: with its last partner, at its stored time
  std::uint8_t contact_image;   ///< of the ball in contact, relative to the stored positions: see packed_image; of a wall its
                                ///< side + 1 (Contact::side)
  std::uint32_t last_partner;   ///< ball or wall number of its last collision
  std::int32_t last_feature;    ///< of the wall
  std::uint32_t partner_stamp;  ///< of that ball, after the impact
};
static_assert(sizeof(Past) == 32);

/// An image of one period at most along each axis, as a number.
template <int D>
[[nodiscard]] CAROM_INLINE std::uint8_t packed_image(const int (&image)[D]) {
  int sum = 0;
  for (int k = 0; k < D; ++k) sum = 3 * sum + image[k] + 1;
  return static_cast<std::uint8_t>(sum);
}
template <int D>
[[nodiscard]] inline Image<D> unpacked_image(std::uint8_t packed) {
  Image<D> image{};
  int sum = packed;
  for (int k = D - 1; k >= 0; --k) {
    image[k] = sum % 3 - 1;
    sum /= 3;
  }
  return image;
}

/// Balls alike in radius, mass and material.
struct Species {
  double radius;           ///< [length unit]
  double mass;             ///< [mass unit] infinity: keeps its velocity
  std::uint32_t material;  ///< row of the restitution table
  bool fixed;              ///< never moves
};

/// The balls of a world in free flight whose bodies are lone balls. Rows are in an order that keeps neighbours together.
template <int D>
struct Swarm {
  PageArray<Flight<D>> flights;
  PageArray<Past> past;
  PageArray<std::uint32_t> stamp;  ///< counts the changes of motion
  PageArray<std::uint32_t> row;    ///< by ball number
  std::vector<Species> species;
  PageArray<double> radius;        ///< [length unit] by row; empty where all balls are of one kind
  std::vector<double> reach;       ///< by row; only where impacts dissipate (BallDetail::reach)
  std::vector<std::string> names;  ///< by ball number; empty if no ball has one
  World<double, D> rest;           ///< all of the world but its balls
  Space<double, D> frame;          ///< what the shells' cells fill: see frame_of; set by sort_rows
  double lower[4] = {};            ///< [length unit] of the space; 0 beyond D
  double edge[4] = {};             ///< [length unit] of the space
  double per_edge[4] = {};         ///< 1 / edge

  [[nodiscard]] CAROM_INLINE std::uint32_t size() const { return static_cast<std::uint32_t>(flights.size()); }
  /// `equal`: all balls are of one kind, so that none is to be looked up.
  template <bool equal = false>
  [[nodiscard]] CAROM_INLINE const Species& kind(std::uint32_t i) const {
    return species[equal ? 0 : past[i].species];
  }
  template <bool equal>
  [[nodiscard]] CAROM_INLINE double radius_of(std::uint32_t i) const {
    return equal ? species[0].radius : radius[i];
  }
};

/// Ball `ball` (its number) as a world stores it.
template <int D>
[[nodiscard]] Ball<double, D> stored_ball(const Swarm<D>& swarm, std::uint32_t ball);
template <int D>
[[nodiscard]] BallDetail<double, D> stored_detail(const Swarm<D>& swarm, std::uint32_t ball);

/// What the ball in row i, which is in contact, touches.
template <int D>
[[nodiscard]] Contact<D> held_contact(const Swarm<D>& swarm, std::uint32_t i);

/// The world that the swarm was made of, as it is now.
template <int D>
[[nodiscard]] World<double, D> make_world(const Swarm<D>& swarm);

/// The space of a world, or the box about the walls of an open one; its edges are 0 where they bound nothing.
template <int D>
[[nodiscard]] Space<double, D> frame_of(const World<double, D>& world);

/// Puts the rows in the order of a Morton curve through the positions at time t.
template <int D>
void sort_rows(Swarm<D>& swarm, const Time<double>& t);

extern template Ball<double, 2> stored_ball(const Swarm<2>&, std::uint32_t);
extern template Ball<double, 3> stored_ball(const Swarm<3>&, std::uint32_t);
extern template BallDetail<double, 2> stored_detail(const Swarm<2>&, std::uint32_t);
extern template BallDetail<double, 3> stored_detail(const Swarm<3>&, std::uint32_t);
extern template Contact<2> held_contact(const Swarm<2>&, std::uint32_t);
extern template Contact<3> held_contact(const Swarm<3>&, std::uint32_t);
extern template World<double, 2> make_world(const Swarm<2>&);
extern template World<double, 3> make_world(const Swarm<3>&);
extern template Space<double, 2> frame_of(const World<double, 2>&);
extern template Space<double, 3> frame_of(const World<double, 3>&);
extern template void sort_rows(Swarm<2>&, const Time<double>&);
extern template void sort_rows(Swarm<3>&, const Time<double>&);

}  // namespace carom
