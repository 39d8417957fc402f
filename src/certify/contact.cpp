#include "contact.hpp"

namespace carom::certify {

namespace {

constexpr int most_steps = 12;  // Newton doubles the digits of a guess; a log gives all of them

/// The offset is as good as the coefficients allow: it is not much larger than it is wide.
bool is_settled(const Enclosure& offset) {
  return offset.is_zero() || offset.log10_size() < offset.width().log10_size() + 1.0;
}

}  // namespace

Enclosure value(const Polynomial<Enclosure>& p, const Enclosure& t) {
  Enclosure sum = p.back();
  for (std::size_t k = p.size() - 1; k-- > 0;) sum = sum * t + p[k];
  return sum;
}

Enclosure slope(const Polynomial<Enclosure>& p, const Enclosure& t) {
  Enclosure sum = Enclosure(static_cast<double>(p.size() - 1)) * p.back();
  for (std::size_t k = p.size() - 1; k-- > 1;) sum = sum * t + Enclosure(static_cast<double>(k)) * p[k];
  return sum;
}

Contact find_contact(const std::function<Polynomial<Enclosure>(const Enclosure& base)>& gap_at, const Enclosure& guess,
                     const Enclosure& reach) {
  Contact found;
  found.base = guess;
  bool enclosed = false;
  for (int step = 0; step < most_steps; ++step) {
    const Polynomial<Enclosure> gap = gap_at(found.base);
    if (step == 0) {
      const Enclosure near = value(gap, reach.around());
      if (is_positive(near) || is_negative(near)) {
        found.proof = Proof::no;
        found.what = "they do not touch at that time";
        return found;
      }
    }
    if (!is_negative(gap[1])) {
      found.proof = is_positive(gap[1]) ? Proof::no : Proof::unknown;
      found.what = is_positive(gap[1]) ? "they do not close at that time" : "a grazing contact cannot be told from none";
      found.offset = gap[0];
      return found;
    }
    const Enclosure newton = -(gap[0] / gap[1]);
    const Enclosure trial = (newton + newton).around();
    const Enclosure fall = slope(gap, trial);
    if (is_negative(fall)) {
      const Enclosure next = -(gap[0] / fall);
      if (next.is_inside(trial)) {
        enclosed = true;
        found.offset = next;
        if (is_settled(next) || step + 1 == most_steps) break;
      }
    }
    if (!newton.is_bounded()) break;
    if (step + 1 < most_steps) found.base = (found.base + newton.middle()).middle();
  }
  found.proof = enclosed ? Proof::yes : Proof::unknown;
  if (!enclosed) found.what = "the time of contact cannot be enclosed";
  return found;
}

}  // namespace carom::certify
