#pragma once
// Intervals of any precision (MPFI): every operation encloses the exact result.

#include <compare>
#include <string>
#include <utility>

#include <mpfi.h>

#include "carom/certify/outward.hpp"
#include "carom/core/rational.hpp"

namespace carom::certify {

/// Bits that decimal digits need, with eight to spare.
[[nodiscard]] int bits_of_digits(int digits);

/// All reals between two binary floating-point numbers of the precision that the `Bits` of this thread give.
class Enclosure {
 public:
  Enclosure() : Enclosure(0.0) {}
  Enclosure(double x) {  // NOLINT(google-explicit-constructor): a double is one, exactly
    mpfi_init2(x_, bits_);
    mpfi_set_d(x_, x);
  }
  Enclosure(const Enclosure& other) {
    mpfi_init2(x_, mpfi_get_prec(other.x_));
    mpfi_set(x_, other.x_);
  }
  Enclosure(Enclosure&& other) noexcept : Enclosure(Raw{}) { mpfi_swap(x_, other.x_); }
  Enclosure& operator=(Enclosure other) noexcept {
    mpfi_swap(x_, other.x_);
    return *this;
  }
  ~Enclosure() { mpfi_clear(x_); }

  /// Of an exact rational.
  [[nodiscard]] static Enclosure of(const Rational& r);
  /// The number of the precision that is nearest to a decimal: a point.
  [[nodiscard]] static Enclosure near(const std::string& decimal);
  /// What surely lies between two decimals: the ends are rounded inwards. Empty (lower end above the upper) if nothing does.
  [[nodiscard]] static Enclosure within(const std::string& lower, const std::string& upper);

  [[nodiscard]] friend Enclosure operator-(const Enclosure& x) { return apply(mpfi_neg, x); }
  [[nodiscard]] friend Enclosure operator+(const Enclosure& x, const Enclosure& y) { return apply(mpfi_add, x, y); }
  [[nodiscard]] friend Enclosure operator-(const Enclosure& x, const Enclosure& y) { return apply(mpfi_sub, x, y); }
  [[nodiscard]] friend Enclosure operator*(const Enclosure& x, const Enclosure& y) { return apply(mpfi_mul, x, y); }
  [[nodiscard]] friend Enclosure operator/(const Enclosure& x, const Enclosure& y) { return apply(mpfi_div, x, y); }
  [[nodiscard]] friend Enclosure square(const Enclosure& x) { return apply(mpfi_sqr, x); }
  [[nodiscard]] friend Enclosure sqrt(const Enclosure& x) { return apply(mpfi_sqrt, x); }
  [[nodiscard]] friend Enclosure half(const Enclosure& x) {
    Enclosure h(x);
    mpfi_div_2ui(h.x_, x.x_, 1);
    return h;
  }

  [[nodiscard]] friend bool is_positive(const Enclosure& x) { return mpfr_sgn(&x.x_->left) > 0; }
  [[nodiscard]] friend bool is_negative(const Enclosure& x) { return mpfr_sgn(&x.x_->right) < 0; }
  [[nodiscard]] friend bool is_before(const Enclosure& x, const Enclosure& y) {
    return mpfr_less_p(&x.x_->right, &y.x_->left) != 0;
  }
  [[nodiscard]] bool is_zero() const { return mpfr_zero_p(&x_->left) != 0 && mpfr_zero_p(&x_->right) != 0; }
  [[nodiscard]] bool is_point() const { return mpfr_equal_p(&x_->left, &x_->right) != 0; }
  /// Every element is a finite number.
  [[nodiscard]] bool is_bounded() const { return mpfr_number_p(&x_->left) != 0 && mpfr_number_p(&x_->right) != 0; }
  /// Lies within `other`, which may be empty.
  [[nodiscard]] bool is_inside(const Enclosure& other) const;
  [[nodiscard]] bool meets(const Enclosure& other) const { return !is_before(*this, other) && !is_before(other, *this); }

  [[nodiscard]] Enclosure lower() const;   ///< the lower end, a point
  [[nodiscard]] Enclosure upper() const;   ///< the upper end, a point
  [[nodiscard]] Enclosure middle() const;  ///< a point inside
  [[nodiscard]] Enclosure width() const;   ///< upper - lower, a point, rounded up
  [[nodiscard]] Enclosure size() const;    ///< the largest magnitude, a point
  [[nodiscard]] Enclosure around() const;  ///< from -size() to size()
  [[nodiscard]] Enclosure with_zero() const;  ///< from the lower end or 0 to the upper end or 0

  /// The same in doubles, rounded outwards.
  [[nodiscard]] Outward outward() const;
  [[nodiscard]] double nearest() const;  ///< the double nearest to the middle
  /// log10 of the largest magnitude; -infinity for 0.
  [[nodiscard]] double log10_size() const;

  /// The ends as decimals of so many significant digits, rounded outwards.
  [[nodiscard]] std::string lower_text(int digits) const;
  [[nodiscard]] std::string upper_text(int digits) const;

 private:
  friend class Bits;
  struct Raw {};
  explicit Enclosure(Raw) { mpfi_init2(x_, bits_); }

  template <class Operation>
  [[nodiscard]] static Enclosure apply(Operation&& operation, const Enclosure& x) {
    Enclosure z(Raw{});
    operation(z.x_, x.x_);
    return z;
  }
  template <class Operation>
  [[nodiscard]] static Enclosure apply(Operation&& operation, const Enclosure& x, const Enclosure& y) {
    Enclosure z(Raw{});
    operation(z.x_, x.x_, y.x_);
    return z;
  }

  mpfi_t x_;
  static thread_local mpfr_prec_t bits_;
};

/// The point that is later on the line.
[[nodiscard]] inline const Enclosure& later(const Enclosure& a, const Enclosure& b) { return is_before(a, b) ? b : a; }

template <>
[[nodiscard]] inline Enclosure ratio<Enclosure>(int p, int q) {
  return Enclosure(p) / Enclosure(q);
}

/// While it lives, new enclosures of this thread have so many bits.
class Bits {
 public:
  explicit Bits(int bits) : before_(Enclosure::bits_) { Enclosure::bits_ = bits; }
  ~Bits() { Enclosure::bits_ = before_; }
  Bits(const Bits&) = delete;
  Bits& operator=(const Bits&) = delete;

 private:
  mpfr_prec_t before_;
};

}  // namespace carom::certify
