#pragma once
// The curved walls of the plane beside circles.

#include "carom/shape/arc.hpp"
#include "carom/shape/ellipse.hpp"
#include "carom/shape/parabola.hpp"
#include "carom/shape/polar_curve.hpp"

namespace carom {

template <class Shape>
inline constexpr bool is_curved = false;
template <class Real>
inline constexpr bool is_curved<Arc<Real>> = true;
template <class Real>
inline constexpr bool is_curved<Ellipse<Real>> = true;
template <class Real>
inline constexpr bool is_curved<Parabola<Real>> = true;
template <class Real>
inline constexpr bool is_curved<PolarCurve<Real>> = true;

}  // namespace carom
