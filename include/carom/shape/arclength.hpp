#pragma once
// How long a traced curve is from its beginning to a place on it.

#include <array>
#include <utility>
#include <vector>

#include "carom/core/vec.hpp"

namespace carom {

/// The lengths from the beginning of a curve to the ends of equal parts of its parameter's range. Each part is summed by the
/// rule of Gauss and Legendre with 8 nodes [Abramowitz1964, table 25.4]: 1e-13 of the whole for curves that turn by less than
/// a radian a part.
template <class Real>
class Arclength {
 public:
  static constexpr int parts = 64;

  Arclength() = default;
  template <class Curve>
  explicit Arclength(const Curve& curve) {
    ends_.push_back(Real(0));
    for (int i = 0; i < parts; ++i) ends_.push_back(ends_.back() + part(curve, border(curve, i), border(curve, i + 1)));
  }

  template <class Curve>
  [[nodiscard]] Real to(const Curve& curve, const Real& u) const {
    int i = 0;
    while (i + 1 < parts && !(u < border(curve, i + 1))) ++i;
    return ends_[static_cast<std::size_t>(i)] + part(curve, border(curve, i), u);
  }

 private:
  template <class Curve>
  [[nodiscard]] static Real border(const Curve& curve, int i) {
    return curve.begin() + (curve.end() - curve.begin()) * Real(i) / Real(parts);
  }
  template <class Curve>
  [[nodiscard]] static Real part(const Curve& curve, const Real& from, const Real& to) {
    using std::sqrt;
    static constexpr std::array<std::pair<double, double>, 4> nodes{{{0.1834346424956498, 0.3626837833783620},
                                                                     {0.5255324099163290, 0.3137066458778873},
                                                                     {0.7966664774136267, 0.2223810344533745},
                                                                     {0.9602898564975363, 0.1012285362903763}}};
    const Real middle = (from + to) / 2, half = (to - from) / 2;
    Real sum(0);
    for (const auto& [place, weight] : nodes)
      for (const int sign : {-1, 1}) {
        const Vec<Real, 2> along = curve.along(Real(middle + half * Real(sign * place)));
        sum += Real(weight) * sqrt(dot<Real, 2>(along, along));
      }
    return half * sum;
  }

  std::vector<Real> ends_;
};

}  // namespace carom
