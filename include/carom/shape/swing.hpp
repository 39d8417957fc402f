#pragma once
// How a wall swings about its place: displaced by amplitude sin(omega t + phase).

#include <cmath>

#include "carom/core/clock.hpp"
#include "carom/core/vec.hpp"

namespace carom {

/// Sines are those of the machine's own library: they may differ in the last bit between machines.
template <class Real, int D>
struct Swing {
  Vec<Real, D> amplitude;  ///< [length unit]
  Real omega = Real(1);    ///< [rad / L], > 0
  Real phase = Real(0);    ///< [rad] at the time 0 of the clock

  /// omega t + phase less whole turns, within a rounding of its size while t < 2^50 / omega. The product is taken in wide
  /// arithmetic, so that a late time costs no precision.
  [[nodiscard]] Real angle(const Time<Real>& t) const {
    using std::floor;
    using W = Wide<Real>;
    constexpr std::int64_t low_bits = std::int64_t{1} << 31;
    const std::int64_t low = t.epoch % low_bits;
    const W turned = wide_product<Real>(omega, Real(t.epoch - low)) + wide_product<Real>(omega, Real(low)) +
                     wide_product<Real>(omega, t.offset) + W(phase);
    const W turn = whole_turn();
    const Real turns = floor(Real(narrow(turned) / narrow(turn)));
    return narrow(W(turned - turn * W(turns)));
  }
  [[nodiscard]] Vec<Real, D> displacement(const Time<Real>& t) const {
    using std::sin;
    return amplitude * Real(sin(angle(t)));
  }
  [[nodiscard]] Vec<Real, D> velocity(const Time<Real>& t) const {
    using std::cos;
    return amplitude * Real(omega * cos(angle(t)));
  }

 private:
  [[nodiscard]] static Wide<Real> whole_turn() {
    if constexpr (std::is_same_v<Real, double>) {
      return DoubleDouble(0x1.921fb54442d18p+2, 0x1.1a62633145c07p-52);
    } else {
      using std::atan;
      return Real(8 * atan(Real(1)));
    }
  }
};

}  // namespace carom
