#pragma once
// The state of a ball: what prediction reads for every pair (hot), and what only a collision needs (cold).

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "carom/core/clock.hpp"
#include "carom/core/id.hpp"
#include "carom/core/vec.hpp"

namespace carom {

/// Hot state. Written only when the motion of the ball changes: all of it is the state at `time`.
template <class Real, int D>
struct Ball {
  Vec<Real, D> position;    ///< [length unit] at `time`; wrapped into the cell of a periodic space
  Vec<Real, D> velocity;    ///< [length unit / L] at `time`
  Time<Real> time;          ///< when the motion last changed
  Real radius = Real(0);    ///< [length unit]
  std::uint32_t stamp = 0;  ///< counts the changes of motion
  bool fixed = false;       ///< never moves
  bool in_contact = false;  ///< made contacts at `time`: see Contact
  bool alive = true;        ///< false once it has left (merged, pocketed)
  std::uint8_t held = 0;    ///< rests on this flat wall (see world/flat_walls.hpp); 0: flies
};

/// What touches: the other party of a contact.
enum class Party : std::uint8_t { ball, wall };

/// A contact that a ball made at its stored time. Both balls of a pair hold one; a wall's is held by the ball alone.
/// It is *spent* while neither party was hit again since (the stamps match); an unspent one acts at once if it closes.
template <int D>
struct Contact {
  Party party = Party::ball;
  std::uint32_t partner = 0;        ///< ball or wall number
  std::int32_t feature = 0;         ///< of the wall
  Image<D> image{};                 ///< of the partner, relative to the stored wrapped positions
  std::int8_t side = 0;             ///< of a two-sided wall: +1 where its normal points
  bool acted = false;               ///< the impact was resolved; false: in contact by start or by rounding
  std::uint32_t own_stamp = 0;      ///< after the impact
  std::uint32_t partner_stamp = 0;  ///< after the impact
  bool left = false;                ///< the ball has slid off the end of this wall: they do not meet again from here

  [[nodiscard]] bool with(Party p, std::uint32_t n, std::int32_t f, const Image<D>& i) const {
    return party == p && partner == n && feature == f && image == i;
  }
};

/// Cold state: read and written by collisions only.
template <class Real, int D>
struct BallDetail {
  Real mass = Real(1);         ///< [mass unit]; infinity: keeps its velocity
  std::uint32_t material = 0;  ///< row of the restitution table
  std::int64_t rank = 0;       ///< 1-D: place in the order along the line, which never changes
  std::array<std::int64_t, static_cast<std::size_t>(D)> image{};  ///< periods counted out of the stored position
  Real reach = Real(0);  ///< [length unit] largest coordinate at, or way between, its collisions: what rounding is relative to
  std::vector<Contact<D>> contacts;           ///< made at the stored time
  Time<Real> last_hit = Time<Real>::never();  ///< its previous collision
  Party last_party = Party::ball;             ///< with whom
  std::uint32_t last_partner = std::numeric_limits<std::uint32_t>::max();
  std::int32_t last_feature = 0;
  std::int32_t body = -1;  ///< row of World::bodies; -1: a body of its own
  std::string name;
};

}  // namespace carom
