#include "table_numbers.hpp"

#include <boost/math/constants/constants.hpp>

#include "carom/scene/tables.hpp"

namespace carom::scene_text {

namespace mp = boost::multiprecision;

Rational rational_of(const Decimal& x) {
  if (mp::abs(x) < Decimal("1e-95")) return 0;  // the rounding of a sine of whole half turns
  Number number;
  number.text = x.str(table_digits);
  return exact(number);
}

Decimal decimal_of(const Rational& r) { return Decimal(Decimal(numerator(r)) / Decimal(denominator(r))); }

Decimal half_turn() { return boost::math::constants::pi<Decimal>(); }

Number number_of(const Rational& r) {
  Number number(nearest_double(r));
  if (exact(number) == r) return number;
  number.text = r.str();
  if (number.text.size() > static_cast<std::size_t>(table_digits)) number.text = decimal_of(r).str(table_digits);
  return number;
}

TableFrame::TableFrame(const Coordinates& centre, const Number& angle, int dimension) : angle_(angle), dimension_(dimension) {
  for (std::size_t k = 0; k < centre.size() && k < 3; ++k) centre_[k] = exact(centre[k]);
  if (angle.value == 0) return;
  const Decimal a = decimal_of(exact(angle));
  cosine_ = rational_of(mp::cos(a));
  sine_ = rational_of(mp::sin(a));
}

Coordinates TableFrame::place(const TablePoint& p) const {
  Coordinates at{number_of(centre_[0] + cosine_ * p.x - sine_ * p.y)};
  if (dimension_ > 1) at.push_back(number_of(centre_[1] + sine_ * p.x + cosine_ * p.y));
  return at;
}

Number TableFrame::turned(const Decimal& angle) const {
  return number_of(rational_of(Decimal(angle + decimal_of(exact(angle_)))));
}

}  // namespace carom::scene_text
