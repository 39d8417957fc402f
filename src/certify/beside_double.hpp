#pragma once
// Sets the run in double precision beside a proven log.

#include <array>
#include <cstdint>
#include <deque>
#include <tuple>
#include <vector>

#include "carom/certify/certify.hpp"
#include "carom/certify/claim.hpp"
#include "carom/certify/system.hpp"
#include "carom/sim/simulation.hpp"

namespace carom::certify {

/// The k-th collision of a ball in one run stands for its k-th in the other.
class BesideDouble {
 public:
  BesideDouble(const Scene& scene, const System& system);

  /// A proven event and where its balls are then; the double run goes on by one collision. False once the runs have parted.
  struct Place {
    double time = 0.0;
    std::array<double, 3> ball{}, partner{};  ///< [length] not wrapped
  };
  bool add(const Claim& claim, const Place& place);

  [[nodiscard]] const AgainstDouble& found() const { return found_; }

 private:
  struct Meeting {
    std::int64_t event = 0;
    double time = 0.0;
    std::tuple<MeetingKind, std::uint32_t, std::int32_t, std::array<std::int64_t, 3>> with;
    std::array<double, 3> x{}, v{};  ///< the velocity before it; of the double run
  };
  struct Waiting {
    std::deque<Meeting> proven, computed;
  };

  void step();
  void meet(std::uint32_t ball, Meeting meeting, bool proven);

  const Scene& scene_;
  Simulation simulation_;
  std::array<double, 3> periods_;
  std::vector<double> radii_;
  std::vector<Waiting> waiting_;
  std::int64_t event_ = 0;
  bool ended_ = false;
  AgainstDouble found_;
};

}  // namespace carom::certify
