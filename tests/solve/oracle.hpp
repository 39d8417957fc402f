#pragma once
// The overlap rule in exact or 100-digit arithmetic, written differently from the code that it judges.

#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "carom/core/vec.hpp"

namespace carom::oracle {

using boost::multiprecision::cpp_bin_float;
using boost::multiprecision::digit_base_2;
using boost::multiprecision::et_off;

/// Exact for sums of products of four doubles whose sizes differ by less than 2^200.
using Exact = boost::multiprecision::number<cpp_bin_float<1100, digit_base_2>, et_off>;
using Digits100 = boost::multiprecision::number<cpp_bin_float<100>, et_off>;

template <int D>
struct Terms {
  Exact a = 0, b = 0, c = 0, d = 0;
};

template <int D>
Terms<D> terms(const Vec<double, D>& r, const Vec<double, D>& v, double sigma) {
  Terms<D> t;
  for (int i = 0; i < D; ++i) {
    t.a += Exact(v[i]) * Exact(v[i]);
    t.b += Exact(r[i]) * Exact(v[i]);
    t.c += Exact(r[i]) * Exact(r[i]);
  }
  t.c -= Exact(sigma) * Exact(sigma);
  t.d = t.b * t.b - t.a * t.c;
  return t;
}

/// First t >= 0 at which |r + v t| <= sigma and falling; nothing: never.
template <int D>
std::optional<Digits100> meet(const Vec<double, D>& r, const Vec<double, D>& v, double sigma) {
  const auto [a, b, c, d] = terms<D>(r, v, sigma);
  if (b >= 0) return {};
  if (c <= 0) return Digits100(0);
  if (d <= 0) return {};
  return Digits100(c) / (sqrt(Digits100(d)) - Digits100(b));
}

/// First t >= 0 at which rho - |r + v t| <= 0 and falling.
template <int D>
std::optional<Digits100> leave(const Vec<double, D>& r, const Vec<double, D>& v, double rho) {
  const auto [a, b, c, d] = terms<D>(r, v, rho);
  if (a == 0) return {};
  if (c >= 0 && b >= 0) return Digits100(0);
  if (d <= 0) return Digits100(Exact(-b / a));
  const Digits100 s = sqrt(Digits100(d));
  return b > 0 ? Digits100(-c) / (s + Digits100(b)) : (s - Digits100(b)) / Digits100(a);
}

/// |computed - true| / true in units of u = 2^-53; 0 for two zeros.
template <class Number>
double error_in_u(double computed, const Number& truth) {
  if (truth == 0) return computed == 0 ? 0.0 : INFINITY;
  return double(abs(Number(computed) - truth) / truth) * 0x1p53;
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }
  double log_uniform(double from, double to) { return std::exp(uniform(std::log(from), std::log(to))); }
  double sign() { return std::uniform_int_distribution<int>(0, 1)(engine_) == 1 ? 1.0 : -1.0; }
  int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(engine_); }
  template <int D>
  Vec<double, D> direction() {
    std::normal_distribution<double> normal;
    Vec<double, D> n;
    for (int i = 0; i < D; ++i) n[i] = normal(engine_);
    return n / std::sqrt(dot<double, D>(n, n));
  }
  /// A unit vector at a right angle to n, to rounding.
  template <int D>
  Vec<double, D> across(const Vec<double, D>& n) {
    Vec<double, D> m = direction<D>();
    m = m - n * dot<double, D>(m, n);
    return m / std::sqrt(dot<double, D>(m, m));
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace carom::oracle
