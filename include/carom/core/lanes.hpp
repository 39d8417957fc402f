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

/// |n| < 2^51 as a double: in [2^52, 2^53) the bits of a double are those of an integer.
CAROM_INLINE Lanes to_double(const LaneMask& n) {
  const LaneMask magic = LaneMask{0, 0, 0, 0} + std::bit_cast<long long>(0x1.8p52);
  return std::bit_cast<Lanes>(n + magic) - 0x1.8p52;
}

CAROM_INLINE Lanes least(const Lanes& a, const Lanes& b) { return a < b ? a : b; }

/// The least of four, in every lane.
CAROM_INLINE Lanes least_of(const Lanes& x) {
  const Lanes halves = least(x, __builtin_shufflevector(x, x, 2, 3, 0, 1));
  return least(halves, __builtin_shufflevector(halves, halves, 1, 0, 3, 2));
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
