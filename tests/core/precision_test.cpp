#include "carom/core/precision.hpp"

#include <gtest/gtest.h>

#include "carom/core/error.hpp"
#include "carom/core/multi.hpp"
#include "carom/core/real.hpp"

namespace carom {
namespace {

TEST(Precision, reads_back_what_it_says) {
  for (const char* text : {"double", "long-double", "17", "50", "100000"}) EXPECT_EQ(parse_precision(text).text(), text);
  EXPECT_EQ(parse_precision("60").digits, 60);
}

TEST(Precision, refuses_what_is_none) {
  for (const char* text : {"", "16", "100001", "fifty", "50.5", "50 ", "-50", "float", "99999999999999999999"})
    EXPECT_THROW(static_cast<void>(parse_precision(text)), InputError) << text;
}

// A scope sets the digits of what is made in it, and puts back what was there.
TEST(PrecisionScope, holds_where_it_is) {
  const unsigned before = Multi::default_precision();
  {
    const PrecisionScope<Multi> outer(40);
    EXPECT_EQ(Multi(1).precision(), 40u);
    {
      const PrecisionScope<Multi> inner(200);
      EXPECT_EQ(Multi(1).precision(), 200u);
      EXPECT_EQ(infinity<Multi>().precision(), 200u);
      // 1/3 to 200 digits is not 1/3 to 40.
      EXPECT_LT(abs(Multi(Multi(1) / 3 * 3 - 1)), Multi("1e-199"));
    }
    EXPECT_EQ(Multi(1).precision(), 40u);
  }
  EXPECT_EQ(Multi::default_precision(), before);
}

// At most as many bits as MPFR gives to that many digits, and not many fewer: u is an upper bound of a rounding.
TEST(SignificandBits, follow_the_digits) {
  for (const int digits : {17, 50, 100, 1000, 100'000}) {
    const PrecisionScope<Multi> scope(digits);
    const int bits = significand_bits<Multi>();
    EXPECT_LE(bits, mpfr_get_prec(Multi(1).backend().data()));
    EXPECT_GE(bits, static_cast<int>(digits * 3.3));
  }
  EXPECT_EQ(significand_bits<double>(), 53);
  EXPECT_EQ(significand_bits<long double>(), 64);
}

}  // namespace
}  // namespace carom
