#pragma once
// The walls that keep balls in or out for good, and whether a ball is where they cannot let it be.

#include <array>
#include <cstdint>
#include <vector>

#include "carom/observe/subject.hpp"
#include "carom/scene/scene.hpp"

namespace carom {

/// Those walls of a scene whose two sides no path connects: the faces of the box, planes (not in a periodic space, where
/// they have no outside), circles and spheres, polygons, and segments that close up, each end of one being an end of
/// another as the numbers are written. What a ball does beside a wall that it can walk round says nothing.
class Enclosures {
 public:
  /// `balls`: the subject's balls at the start.
  Enclosures(const Scene& scene, const Subject& subject, const std::vector<Triple>& balls);

  /// Whether the centre of a ball at `position` (wrapped, in a periodic space) is on another side of any of these walls
  /// than where the scene puts it at the start, `elapsed` after it. The exact run never has one there.
  [[nodiscard]] bool escaped(std::uint32_t ball, const Triple& position, double elapsed) const;

 private:
  struct HalfSpace {
    Triple point, normal, velocity;
  };
  struct Round {
    Triple centre, velocity;
    double radius;
    bool inside;
  };
  /// A closed curve about a centre: an ellipse, or r(theta).
  struct Bent {
    WallSpec wall;
    Triple centre, velocity;
  };
  struct Edge {
    Triple from, to;
  };
  /// A closed line in the plane, of one piece or more, and the balls that start inside.
  struct Ring {
    std::vector<Edge> edges;
    Triple velocity{};
    std::vector<bool> holds;
  };

  void add_wall(const WallSpec& wall);
  void add_closed_segments(const Scene& scene);
  [[nodiscard]] bool outside(const Round& round, const Triple& x) const;
  [[nodiscard]] static bool outside(const Bent& bent, const Triple& x);
  [[nodiscard]] bool inside(const Ring& ring, const Triple& x, double elapsed) const;
  /// Calls f(image) for the places of a point in the cell and in all cells around it; only the point itself elsewhere.
  template <class F>
  [[nodiscard]] bool any_image(const Triple& x, F&& f) const;

  std::size_t dimension_;
  bool periodic_;
  std::array<double, 3> edge_;
  std::vector<HalfSpace> half_spaces_;
  std::vector<Round> rounds_;
  std::vector<Bent> bents_;
  std::vector<Ring> rings_;
};

}  // namespace carom
