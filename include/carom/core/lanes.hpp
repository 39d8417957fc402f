#pragma once
// Four doubles at a time. Each lane is rounded as a lone double is, so results do not depend on the vector unit.

#include <bit>
#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

// Always inlined, so no vector is ever passed to a function.
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace carom {

#define CAROM_INLINE [[gnu::always_inline]] inline

/// Four doubles, four 64-bit integers: + - * / < == and ?: act lane by lane (vector extension of GCC and clang).
using Lanes = double __attribute__((vector_size(32)));
using LaneMask = long long __attribute__((vector_size(32)));

/// The same in memory, at any address that a double may have.
using StoredMask = long long __attribute__((vector_size(32), aligned(8), may_alias));
using StoredLanes = double __attribute__((vector_size(32), aligned(8), may_alias));

inline constexpr int lanes = 4;

/// Instruction sets that a kernel is compiled for; a tag that keeps the compiled versions apart by name.
struct Baseline {};
struct Avx2 {};

CAROM_INLINE Lanes spread(double x) { return Lanes{x, x, x, x}; }

CAROM_INLINE Lanes load(const double* from) { return *reinterpret_cast<const StoredLanes*>(from); }

CAROM_INLINE Lanes sqrt(const Lanes& x) {
#if defined(__AVX__)
  return static_cast<Lanes>(_mm256_sqrt_pd(static_cast<__m256d>(x)));
#else
  return Lanes{__builtin_sqrt(x[0]), __builtin_sqrt(x[1]), __builtin_sqrt(x[2]), __builtin_sqrt(x[3])};
#endif
}

/// The nearest integer, |x| < 2^51: what is added and taken away has a spacing of 1.
CAROM_INLINE Lanes nearest_integer(const Lanes& x) {
  constexpr double magic = 0x1.8p52;
  return (x + magic) - magic;
}
CAROM_INLINE double nearest_integer(double x) {
  constexpr double magic = 0x1.8p52;
  return (x + magic) - magic;
}

/// x, -2^51 < x < 2^51, to the integer below.
CAROM_INLINE Lanes floor(const Lanes& x) {
#if defined(__AVX__)
  return static_cast<Lanes>(_mm256_floor_pd(static_cast<__m256d>(x)));
#else
  return Lanes{__builtin_floor(x[0]), __builtin_floor(x[1]), __builtin_floor(x[2]), __builtin_floor(x[3])};
#endif
}

/// An integer |x| < 2^51 that is held in a double.
CAROM_INLINE LaneMask to_integer(const Lanes& x) {
  return std::bit_cast<LaneMask>(x + 0x1.8p52) - std::bit_cast<long long>(0x1.8p52);
}

/// Four integers below 2^31.
CAROM_INLINE Lanes to_double(const std::uint32_t (&n)[4]) {
#if defined(__AVX__)
  return static_cast<Lanes>(_mm256_cvtepi32_pd(_mm_loadu_si128(reinterpret_cast<const __m128i*>(n))));
#else
  return Lanes{static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2]), static_cast<double>(n[3])};
#endif
}

/// The first D components of a vector in memory that is followed by others; 0 beyond.
template <int D>
CAROM_INLINE Lanes load_vector(const double* from) {
  const Lanes x = load(from);
  return D == 3 ? Lanes(__builtin_shufflevector(x, Lanes{}, 0, 1, 2, 7)) : Lanes(__builtin_shufflevector(x, Lanes{}, 0, 1, 6, 7));
}

/// (sum of a's lanes, sum of b's, the same of c's and d's): a0 + a1 + (a2 + a3), and so on.
CAROM_INLINE Lanes sums(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
  const Lanes ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

/// |n| < 2^51 as a double: in [2^52, 2^53) the bits of a double are those of an integer.
CAROM_INLINE Lanes to_double(const LaneMask& n) {
  const LaneMask magic = LaneMask{0, 0, 0, 0} + std::bit_cast<long long>(0x1.8p52);
  return std::bit_cast<Lanes>(n + magic) - 0x1.8p52;
}

/// The smaller and the larger of two, none of them a NaN.
#if defined(__AVX__)
CAROM_INLINE Lanes least(const Lanes& a, const Lanes& b) {
  return static_cast<Lanes>(_mm256_min_pd(static_cast<__m256d>(a), static_cast<__m256d>(b)));
}
CAROM_INLINE Lanes most(const Lanes& a, const Lanes& b) {
  return static_cast<Lanes>(_mm256_max_pd(static_cast<__m256d>(a), static_cast<__m256d>(b)));
}
#else
CAROM_INLINE Lanes least(const Lanes& a, const Lanes& b) { return a < b ? a : b; }
CAROM_INLINE Lanes most(const Lanes& a, const Lanes& b) { return a < b ? b : a; }
#endif

/// The least of four, in every lane.
CAROM_INLINE Lanes least_of(const Lanes& x) {
  const Lanes halves = least(x, __builtin_shufflevector(x, x, 2, 3, 0, 1));
  return least(halves, __builtin_shufflevector(halves, halves, 1, 0, 3, 2));
}

/// The lanes 0 .. 3 in the order of x, which are positive and finite; those that differ in their last two bits alone in any.
CAROM_INLINE LaneMask in_order(const Lanes& x) {
  // A positive double with another in its last two bits is a key that carries its lane.
  const Lanes key = std::bit_cast<Lanes>((std::bit_cast<LaneMask>(x) & ~3LL) | LaneMask{0, 1, 2, 3});
  const Lanes other = __builtin_shufflevector(key, key, 1, 0, 3, 2);
  const Lanes pairs = __builtin_shufflevector(least(key, other), most(key, other), 0, 5, 2, 7);
  const Lanes across = __builtin_shufflevector(pairs, pairs, 3, 2, 1, 0);
  const Lanes halves = __builtin_shufflevector(least(pairs, across), most(pairs, across), 0, 1, 6, 7);
  const Lanes beside = __builtin_shufflevector(halves, halves, 1, 0, 3, 2);
  return std::bit_cast<LaneMask>(__builtin_shufflevector(least(halves, beside), most(halves, beside), 0, 5, 2, 7)) & 3LL;
}

/// x[order[0 .. 4)].
template <class T>
CAROM_INLINE T permuted(const T& x, const LaneMask& order) {
#if defined(__AVX2__)
  const LaneMask low = order + order;
  return std::bit_cast<T>(
      _mm256_permutevar8x32_epi32(std::bit_cast<__m256i>(x), std::bit_cast<__m256i>(low | (low << 32) | (1LL << 32))));
#else
  return T{x[order[0]], x[order[1]], x[order[2]], x[order[3]]};
#endif
}

/// Bit k is set where the sign bit of lane k is.
CAROM_INLINE int sign_bits(const LaneMask& mask) {
#if defined(__AVX__)
  return _mm256_movemask_pd(std::bit_cast<__m256d>(mask));
#else
  return (mask[0] < 0 ? 1 : 0) | (mask[1] < 0 ? 2 : 0) | (mask[2] < 0 ? 4 : 0) | (mask[3] < 0 ? 8 : 0);
#endif
}

/// Eight 32-bit integers, eight floats.
using Ints8 = std::int32_t __attribute__((vector_size(32)));
using Floats8 = float __attribute__((vector_size(32)));
using StoredInts8 = std::int32_t __attribute__((vector_size(32), aligned(4), may_alias));

CAROM_INLINE Ints8 load8(const std::uint32_t* from) { return *reinterpret_cast<const StoredInts8*>(from); }

/// Each entry holds two 16-bit integers: the sum of their squares.
CAROM_INLINE Ints8 sums_of_squares(const Ints8& pairs) {
#if defined(__AVX2__)
  return std::bit_cast<Ints8>(_mm256_madd_epi16(std::bit_cast<__m256i>(pairs), std::bit_cast<__m256i>(pairs)));
#else
  const Ints8 low = (pairs << 16) >> 16, high = pairs >> 16;
  return low * low + high * high;
#endif
}
/// a - b of the 16-bit integers that each entry holds two of.
CAROM_INLINE Ints8 differences16(const Ints8& a, const Ints8& b) {
#if defined(__AVX2__)
  return std::bit_cast<Ints8>(_mm256_sub_epi16(std::bit_cast<__m256i>(a), std::bit_cast<__m256i>(b)));
#else
  return ((a - b) & 0xffff) | ((a & ~0xffff) - (b & ~0xffff));
#endif
}

/// Bit k is set where the sign bit of entry k is.
CAROM_INLINE unsigned sign_bits8(const Ints8& mask) {
#if defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_ps(std::bit_cast<__m256>(mask)));
#else
  unsigned bits = 0;
  for (int k = 0; k < 8; ++k) bits |= static_cast<unsigned>(mask[k] < 0) << k;
  return bits;
#endif
}

/// Writes those of eight numbers whose bit is set, in order; what follows them there, up to eight in all, is overwritten.
CAROM_INLINE void write_chosen(std::uint32_t* to, const std::uint32_t* from, unsigned bits) {
#if defined(__AVX2__) && defined(__BMI2__)
  const unsigned long long bytes = _pdep_u64(bits, 0x0101010101010101ULL) * 0xff;
  const unsigned long long places = _pext_u64(0x0706050403020100ULL, bytes);
  const __m256i chosen = _mm256_permutevar8x32_epi32(
      std::bit_cast<__m256i>(load8(from)), _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(places))));
  *reinterpret_cast<StoredInts8*>(to) = std::bit_cast<Ints8>(chosen);
#else
  for (; bits != 0; bits &= bits - 1) *to++ = from[__builtin_ctz(bits)];
#endif
}

/// The columns of four rows of four doubles in memory.
CAROM_INLINE void load_columns(const double* p, const double* q, const double* r, const double* s, Lanes& a, Lanes& b, Lanes& c,
                               Lanes& d) {
#if defined(__AVX__)
  const auto halves = [](const double* low, const double* high) {
    return static_cast<Lanes>(_mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(low)), _mm_loadu_pd(high), 1));
  };
  const Lanes pr = halves(p, r), qs = halves(q, s), pr2 = halves(p + 2, r + 2), qs2 = halves(q + 2, s + 2);
  a = __builtin_shufflevector(pr, qs, 0, 4, 2, 6);
  b = __builtin_shufflevector(pr, qs, 1, 5, 3, 7);
  c = __builtin_shufflevector(pr2, qs2, 0, 4, 2, 6);
  d = __builtin_shufflevector(pr2, qs2, 1, 5, 3, 7);
#else
  a = Lanes{p[0], q[0], r[0], s[0]};
  b = Lanes{p[1], q[1], r[1], s[1]};
  c = Lanes{p[2], q[2], r[2], s[2]};
  d = Lanes{p[3], q[3], r[3], s[3]};
#endif
}

/// The columns of four rows: a becomes all first components, and so on.
CAROM_INLINE void transpose(Lanes& a, Lanes& b, Lanes& c, Lanes& d) {
  const Lanes ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

}  // namespace carom
