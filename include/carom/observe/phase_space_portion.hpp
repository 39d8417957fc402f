#pragma once
// How much of the boundary map an orbit fills.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "carom/observe/boundary.hpp"
#include "carom/observe/observer.hpp"

namespace carom {

/// phase_space_portion [-]: the cells of the boundary map that balls have come to, over all bins x bins of them, equal in
/// arclength and in sine and so in the measure that the map keeps. A chaotic orbit fills its sea slowly: phase_space_portion
/// tends to the sea's share from below while the cells are larger than its islands' edges are rough; it has no error of its
/// own. phase_space_portion.before: what it was before the last power of two of collisions.
class PhaseSpacePortion {
 public:
  PhaseSpacePortion(std::shared_ptr<const Boundary> boundary, std::size_t bins)
      : boundary_(std::move(boundary)), bins_(bins), seen_(bins * bins, false) {}

  void collision(const Collision& c, double, const Subject& subject) {
    const std::optional<Bounce> b = boundary_->bounce(c, subject);
    if (!b) return;
    if ((bounces_ & (bounces_ - 1)) == 0) before_ = portion();
    ++bounces_;
    const std::size_t i = cell(b->arclength / boundary_->length()), j = cell((b->sine + 1) / 2);
    if (seen_[i * bins_ + j]) return;
    seen_[i * bins_ + j] = true;
    ++visited_;
  }
  void end(double) {}
  [[nodiscard]] Estimates estimates() const {
    return {{"phase_space_portion", portion()}, {"phase_space_portion.before", before_}};
  }

 private:
  [[nodiscard]] std::size_t cell(double x) const {
    return std::min(bins_ - 1, static_cast<std::size_t>(std::max(0.0, x) * static_cast<double>(bins_)));
  }
  [[nodiscard]] double portion() const { return static_cast<double>(visited_) / static_cast<double>(bins_ * bins_); }

  std::shared_ptr<const Boundary> boundary_;
  std::size_t bins_, visited_ = 0;
  std::vector<bool> seen_;
  std::uint64_t bounces_ = 0;
  double before_ = 0.0;
};

}  // namespace carom
