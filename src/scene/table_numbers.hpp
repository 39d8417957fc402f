#pragma once
// The numbers of ready-made tables: exact quotients, and irrational ones in far more digits than any scene shows.

#include <boost/multiprecision/cpp_dec_float.hpp>

#include "carom/core/rational.hpp"
#include "carom/scene/scene.hpp"

namespace carom::scene_text {

/// Software decimals: the same on every machine.
using Decimal = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<110>>;

/// To `table_digits` digits; a number of the size of 1, or 0.
[[nodiscard]] Rational rational_of(const Decimal& x);
[[nodiscard]] Decimal decimal_of(const Rational& r);
[[nodiscard]] Decimal half_turn();  ///< pi

/// Text where the nearest double is not all of it.
[[nodiscard]] Number number_of(const Rational& r);

/// A point in the frame of a table.
struct TablePoint {
  Rational x, y;
};

/// From the frame of a table to the scene: turned about the centre, then moved. Not turned, every number stays exact.
class TableFrame {
 public:
  TableFrame(const Coordinates& centre, const Number& angle, int dimension);

  [[nodiscard]] Coordinates place(const TablePoint& p) const;
  [[nodiscard]] Number turned(const Decimal& angle) const;

 private:
  Rational centre_[3] = {0, 0, 0}, cosine_ = 1, sine_ = 0;
  Number angle_;
  int dimension_;
};

}  // namespace carom::scene_text
