#include "carom/solve/pair_terms.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <boost/multiprecision/cpp_int.hpp>

#include "carom/core/check.hpp"

namespace carom {
namespace {

using Integer = boost::multiprecision::cpp_int;

Scaled scaled(double x, long exponent) {
  int e = 0;
  const double m = std::frexp(x, &e);
  return {m, m == 0.0 ? 0 : exponent + e};
}

double value(const Scaled& x, long shift) {
  const long e = x.exponent + shift;
  return std::ldexp(x.mantissa, int(std::clamp(e, -5000L, 5000L)));
}

Scaled root(const Scaled& x) {
  const long odd = x.exponent & 1;
  return {std::sqrt(odd ? 2.0 * x.mantissa : x.mantissa), (x.exponent - odd) / 2};
}

// x + y to one rounding; what is 2^2000 times smaller is nothing.
Scaled plus(const Scaled& x, const Scaled& y) {
  if (x.mantissa == 0.0) return y;
  if (y.mantissa == 0.0) return x;
  const long top = std::max(x.exponent, y.exponent);
  return scaled(value(x, -top) + value(y, -top), top);
}

Scaled minus(const Scaled& x) { return {-x.mantissa, x.exponent}; }

double quotient(const Scaled& x, const Scaled& y) { return value({x.mantissa / y.mantissa, x.exponent}, -y.exponent); }

// x = m 2^-k with an integer m, exactly, for k large enough.
Integer integer(double x, int k) {
  if (x == 0.0) return 0;
  int e = 0;
  const double m = std::frexp(x, &e);
  return Integer(std::int64_t(std::ldexp(m, 53))) << (e - 53 + k);
}

// The smallest k for which `integer` works.
int fraction_bits(const double* x, int n, double extra) {
  int k = -2000;
  const auto widen = [&k](double y) {
    int e = 0;
    if (y != 0.0) {
      std::frexp(y, &e);
      k = std::max(k, 53 - e);
    }
  };
  for (int i = 0; i < n; ++i) widen(x[i]);
  widen(extra);
  return k == -2000 ? 0 : k;
}

// n 2^-k to 64 bits, then to double: relative error below u (1 + 2^-10).
Scaled rounded(const Integer& n, long k) {
  if (n == 0) return {};
  const bool negative = n < 0;
  const Integer size = negative ? Integer(-n) : n;
  const long top = long(boost::multiprecision::msb(size));
  const long drop = std::max(0L, top - 63);
  const double m = double((Integer(size >> drop)).convert_to<std::uint64_t>());
  return scaled(negative ? -m : m, drop - k);
}

double largest(const double* x, int n) {
  double m = 0.0;
  for (int i = 0; i < n; ++i) m = std::max(m, std::fabs(x[i]));
  return m;
}

}  // namespace

PairTerms exact_pair_terms(const double* r, const double* v, double sigma, int dimension) {
  const int kr = fraction_bits(r, dimension, sigma);
  const int kv = fraction_bits(v, dimension, 0.0);
  const Integer s = integer(sigma, kr);
  Integer a = 0;
  Integer b = 0;
  Integer c = -s * s;
  for (int i = 0; i < dimension; ++i) {
    const Integer x = integer(r[i], kr);
    const Integer w = integer(v[i], kv);
    a += w * w;
    b += x * w;
    c += x * x;
  }
  const Integer d = b * b - a * c;
  return {rounded(a, 2L * kv), rounded(b, long(kr) + kv), rounded(c, 2L * kr), rounded(d, 2L * kr + 2L * kv)};
}

template <int D>
PairTerms pair_terms(const Vec<double, D>& r, const Vec<double, D>& v, double sigma) {
  const double length = std::max(largest(r.data(), D), sigma);
  const double speed = largest(v.data(), D);
  CAROM_EXPECT(std::isfinite(length) && std::isfinite(speed));
  int el = 0;
  int es = 0;
  std::frexp(length, &el);
  std::frexp(speed, &es);
  Vec<double, D> x;
  Vec<double, D> w;
  for (int i = 0; i < D; ++i) {
    x[i] = std::ldexp(r[i], -el);
    w[i] = std::ldexp(v[i], -es);
  }
  const double s = std::ldexp(sigma, -el);
  const DoubleDouble ss = two_prod(s, s);
  const DoubleDouble a = wide_dot<double, D>(w, w);
  const DoubleDouble b = wide_dot<double, D>(x, w);
  const DoubleDouble xx = wide_dot<double, D>(x, x);
  const DoubleDouble c = xx - ss;
  const DoubleDouble d = a * ss - detail::wide_cross_squared<D>(x, w);
  const double size = std::max(xx.hi, ss.hi);  // 1/4 .. 4
  const bool certain = std::fabs(b.hi) > detail::settled * std::sqrt(a.hi * size) && std::fabs(c.hi) > detail::settled * size &&
                       std::fabs(d.hi) > detail::settled * a.hi * size;
  if (!certain) return exact_pair_terms(r.data(), v.data(), sigma, D);
  return {scaled(a.hi, 2L * es), scaled(b.hi, long(el) + es), scaled(c.hi, 2L * el), scaled(d.hi, 2L * el + 2L * es)};
}

double smaller_root(const PairTerms& terms) { return quotient(terms.c, plus(minus(terms.b), root(terms.d))); }

double larger_root(const PairTerms& terms) {
  const Scaled s = root(terms.d);
  if (terms.b.mantissa > 0.0) return quotient(minus(terms.c), plus(terms.b, s));
  return quotient(plus(minus(terms.b), s), terms.a);
}

double closest_time(const PairTerms& terms) { return quotient(minus(terms.b), terms.a); }

template PairTerms pair_terms<2>(const Vec<double, 2>&, const Vec<double, 2>&, double);
template PairTerms pair_terms<3>(const Vec<double, 3>&, const Vec<double, 3>&, double);

}  // namespace carom
