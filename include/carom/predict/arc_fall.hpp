#pragma once
// When two parties on a circular relative path meet: by their gap, or by the contact that they hold.

#include "carom/predict/contact.hpp"
#include "carom/solve/harmonic.hpp"

namespace carom {

template <class Real>
[[nodiscard]] inline Real fall_on_arc(const ArcGap<Real>& gap, Touch touch) {
  if (touch == Touch::none) return first_fall(gap);
  if (touch == Touch::live && narrow(gap.c1) < 0) return Real(0);
  return return_to_contact(gap);
}

}  // namespace carom
