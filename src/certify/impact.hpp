#pragma once
// Impacts in enclosures [papers/certify/README.md, section 4].

#include <map>
#include <vector>

#include "contact.hpp"
#include "gaps.hpp"
#include "jump.hpp"

namespace carom::certify {

/// The share c = (1 + e) m_other / (m_own + m_other) that a body takes of the change of the normal velocity, and 1 - c, both
/// from exact rationals.
struct Share {
  Enclosure takes, keeps;
};

class Impacts {
 public:
  Impacts(const System& system, const Gaps<Enclosure>& gaps);

  /// The states at the contact's base of the motions after the impact of balls i and j: `a`, `b` are those before it. In
  /// one dimension j is on the right.
  void pair(std::uint32_t i, State<Enclosure>& a, std::uint32_t j, State<Enclosure>& b, const std::array<std::int64_t, 3>& period,
            const Contact& contact) const;
  /// Of ball i and a piece of a wall; `side`: of an edge.
  void wall(std::uint32_t i, State<Enclosure>& a, std::size_t piece, int side, const Contact& contact) const;

  [[nodiscard]] bool plastic_pair(std::uint32_t i, std::uint32_t j) const;
  [[nodiscard]] bool plastic_wall(std::uint32_t i, std::size_t piece) const;

 private:
  using Matrix = Jump::Matrix;

  void apply(const Jump& jump, const Enclosure& takes, const State<Enclosure>& middle, const State<Enclosure>& own,
             const State<Enclosure>& other, bool turned, State<Enclosure>& to) const;
  void pair_on_a_line(std::uint32_t i, State<Enclosure>& a, std::uint32_t j, State<Enclosure>& b, const Relative<Enclosure>& r,
                      std::int64_t period, const Enclosure& s) const;
  void flat_wall(std::uint32_t i, State<Enclosure>& a, std::size_t piece, int side, const Contact& contact) const;
  [[nodiscard]] Matrix along(const Triple<Enclosure>& n, const Enclosure& length_squared) const;
  [[nodiscard]] const Share& share(std::uint32_t own, std::uint32_t other) const;

  const System& system_;
  const Gaps<Enclosure>& gaps_;
  std::size_t d_;
  std::vector<std::uint32_t> kind_;              // by ball: of equal mass and material
  std::vector<std::vector<Share>> shares_;       // by kind and kind
  std::vector<std::vector<Share>> wall_shares_;  // by material and wall
};

}  // namespace carom::certify
