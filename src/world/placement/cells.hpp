#pragma once
// Cells over a region, and a visit of those that a ball's neighbourhood reaches into, image by image.

#include <array>
#include <cmath>
#include <cstdint>

#include "crowd.hpp"

namespace carom {

/// How often each axis was wrapped to get from a stored position to the one meant: +-2 at most, as one number.
inline constexpr int image_reach = 2;

template <int D>
[[nodiscard]] constexpr int image_codes() {
  int n = 1;
  for (int k = 0; k < D; ++k) n *= 2 * image_reach + 1;
  return n;
}
/// The code of "no wrap" is the middle one.
template <int D>
inline constexpr int home_image = (image_codes<D>() - 1) / 2;

template <int D>
class Cells {
 public:
  using Vector = typename Crowd<D>::Vector;

  /// Cells no narrower than `width`, and no more than about four a ball.
  Cells(const Vector& edge, bool periodic, double width, std::size_t balls) : periodic_(periodic) {
    const double most = 4.0 * static_cast<double>(balls) + 64.0;
    double volume = 1.0;
    for (int k = 0; k < D; ++k) volume *= edge[k];
    if (!(width > 0.0)) width = volume > 0.0 ? edge[0] / most : 1.0;
    for (double total = most + 1.0; total > most; width *= 1.25) {
      total = 1.0;
      for (int k = 0; k < D; ++k) {
        const double n = edge[k] / width;
        count_[k] = n < 1.0 ? 1 : n < 1e9 ? static_cast<std::int64_t>(n) : std::int64_t{1000000000};
        total *= static_cast<double>(count_[k]);
      }
    }
    for (int k = 0; k < D; ++k) per_length_[k] = static_cast<double>(count_[k]) / edge[k];
  }

  [[nodiscard]] std::size_t size() const {
    std::size_t n = 1;
    for (int k = 0; k < D; ++k) n *= static_cast<std::size_t>(count_[k]);
    return n;
  }

  /// The cell of a position in 0 .. edge; of one beyond, the cell at the border.
  [[nodiscard]] std::size_t of(const Vector& x) const {
    std::size_t cell = 0;
    for (int k = D - 1; k >= 0; --k) {
      cell = cell * static_cast<std::size_t>(count_[k]) + static_cast<std::size_t>(clamped(x[k] * per_length_[k], k));
    }
    return cell;
  }

  /// Calls visit(first, last, image) for runs of cells first .. last - 1 that together, each in its image, hold all points
  /// nearer to x than `range`. Stops when visit returns false.
  template <typename Visit>
  bool around(const Vector& x, double range, Visit&& visit) const {
    std::array<std::int64_t, D> low{}, high{};
    for (int k = 0; k < D; ++k) {
      const double a = (x[k] - range) * per_length_[k] - 1e-9, b = (x[k] + range) * per_length_[k] + 1e-9;
      low[k] = periodic_ ? floor_of(a) : clamped(a, k);
      high[k] = periodic_ ? floor_of(b) : clamped(b, k);
    }
    return rows<D - 1>(low, high, 0, 0, visit);
  }

 private:
  static std::int64_t floor_of(double a) {
    const auto n = static_cast<std::int64_t>(a);
    return static_cast<double>(n) > a ? n - 1 : n;
  }
  [[nodiscard]] std::int64_t clamped(double a, int k) const {
    if (!(a > 0.0)) return 0;
    return a < static_cast<double>(count_[k]) ? static_cast<std::int64_t>(a) : count_[k] - 1;
  }

  template <int K, typename Visit>
  bool rows(const std::array<std::int64_t, D>& low, const std::array<std::int64_t, D>& high, std::size_t base, int code,
            Visit& visit) const {
    const std::int64_t n = count_[K];
    std::int64_t image = 0, c = low[K];
    while (c < 0) c += n, --image;
    while (c >= n) c -= n, ++image;
    for (std::int64_t left = high[K] - low[K] + 1; left > 0;) {
      const int next = code * (2 * image_reach + 1) + static_cast<int>(image) + image_reach;
      if constexpr (K == 0) {
        const std::int64_t run = left < n - c ? left : n - c;
        const std::size_t first = base * static_cast<std::size_t>(n) + static_cast<std::size_t>(c);
        if (!visit(first, first + static_cast<std::size_t>(run), next)) return false;
        left -= run;
        c += run;
      } else {
        if (!rows<K - 1>(low, high, base * static_cast<std::size_t>(n) + static_cast<std::size_t>(c), next, visit))
          return false;
        --left;
        ++c;
      }
      if (c == n) c = 0, ++image;
    }
    return true;
  }

  bool periodic_;
  std::array<std::int64_t, D> count_{};
  Vector per_length_{};
};

/// The displacement of each image code.
template <int D>
[[nodiscard]] std::array<typename Crowd<D>::Vector, image_codes<D>()> image_shifts(const typename Crowd<D>::Vector& edge) {
  std::array<typename Crowd<D>::Vector, image_codes<D>()> shift{};
  for (int code = 0; code < image_codes<D>(); ++code) {
    int rest = code;
    for (int k = 0; k < D; ++k) {
      shift[code][k] = (rest % (2 * image_reach + 1) - image_reach) * edge[k];
      rest /= 2 * image_reach + 1;
    }
  }
  return shift;
}

/// Balls in classes of size: class l holds diameters above largest / 2^(l + 1), up to largest / 2^l.
[[nodiscard]] inline int size_class(double radius, double largest) {
  int l = 0;
  for (double limit = 0.5 * largest; radius <= limit && l < 40; limit *= 0.5) ++l;
  return l;
}

}  // namespace carom
