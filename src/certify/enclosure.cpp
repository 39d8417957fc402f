#include "enclosure.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace carom::certify {

thread_local mpfr_prec_t Enclosure::bits_ = 53;

int bits_of_digits(int digits) { return static_cast<int>(std::ceil(digits * 3.3219280948873623)) + 8; }

Enclosure Enclosure::of(const Rational& r) {
  Enclosure x(Raw{});
  mpq_t q;
  mpq_init(q);
  mpz_set_str(mpq_numref(q), numerator(r).str().c_str(), 10);
  mpz_set_str(mpq_denref(q), denominator(r).str().c_str(), 10);
  mpfi_set_q(x.x_, q);
  mpq_clear(q);
  return x;
}

Enclosure Enclosure::near(const std::string& decimal) {
  Enclosure x(Raw{});
  mpfr_set_str(&x.x_->left, decimal.c_str(), 10, MPFR_RNDN);
  mpfr_set(&x.x_->right, &x.x_->left, MPFR_RNDN);
  return x;
}

Enclosure Enclosure::within(const std::string& lower, const std::string& upper) {
  Enclosure x(Raw{});
  mpfr_set_str(&x.x_->left, lower.c_str(), 10, MPFR_RNDU);
  mpfr_set_str(&x.x_->right, upper.c_str(), 10, MPFR_RNDD);
  return x;
}

bool Enclosure::is_inside(const Enclosure& other) const {
  return mpfr_lessequal_p(&other.x_->left, &x_->left) != 0 && mpfr_lessequal_p(&x_->right, &other.x_->right) != 0;
}

Enclosure Enclosure::lower() const {
  Enclosure p(*this);
  mpfr_set(&p.x_->right, &x_->left, MPFR_RNDN);
  return p;
}
Enclosure Enclosure::upper() const {
  Enclosure p(*this);
  mpfr_set(&p.x_->left, &x_->right, MPFR_RNDN);
  return p;
}
Enclosure Enclosure::middle() const {
  Enclosure p(*this);
  mpfi_mid(&p.x_->left, x_);
  mpfr_set(&p.x_->right, &p.x_->left, MPFR_RNDN);
  return p;
}
Enclosure Enclosure::width() const {
  Enclosure w(Raw{});
  mpfr_sub(&w.x_->right, &x_->right, &x_->left, MPFR_RNDU);
  mpfr_set(&w.x_->left, &w.x_->right, MPFR_RNDN);
  return w;
}
Enclosure Enclosure::size() const {
  Enclosure s(*this);
  mpfi_mag(&s.x_->right, x_);
  mpfr_set(&s.x_->left, &s.x_->right, MPFR_RNDN);
  return s;
}
Enclosure Enclosure::around() const {
  Enclosure s = size();
  mpfr_neg(&s.x_->left, &s.x_->left, MPFR_RNDN);
  return s;
}

Enclosure Enclosure::with_zero() const {
  Enclosure x(*this);
  if (mpfr_sgn(&x.x_->left) > 0) mpfr_set_zero(&x.x_->left, 1);
  if (mpfr_sgn(&x.x_->right) < 0) mpfr_set_zero(&x.x_->right, 1);
  return x;
}

Outward Enclosure::outward() const { return {mpfr_get_d(&x_->left, MPFR_RNDD), mpfr_get_d(&x_->right, MPFR_RNDU)}; }
double Enclosure::nearest() const { return mpfi_get_d(x_); }

double Enclosure::log10_size() const {
  const Enclosure s = size();
  if (mpfr_zero_p(&s.x_->right) != 0) return -std::numeric_limits<double>::infinity();
  long exponent = 0;
  const double m = mpfr_get_d_2exp(&exponent, &s.x_->right, MPFR_RNDU);
  return std::log10(m) + static_cast<double>(exponent) * 0.30102999566398120;
}

namespace {
std::string text(const char* format, int digits, mpfr_srcptr x) {
  if (mpfr_zero_p(x) != 0) return "0";  // of either sign
  const int length = mpfr_snprintf(nullptr, 0, format, digits, x);
  std::vector<char> characters(static_cast<std::size_t>(length) + 1);
  mpfr_snprintf(characters.data(), characters.size(), format, digits, x);
  return {characters.data(), static_cast<std::size_t>(length)};
}
}  // namespace

std::string Enclosure::lower_text(int digits) const { return text("%.*RDg", digits, &x_->left); }
std::string Enclosure::upper_text(int digits) const { return text("%.*RUg", digits, &x_->right); }

}  // namespace carom::certify
