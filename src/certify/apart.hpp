#pragma once
// Proves that two bodies are apart over a span of time in which their motions do not change.

#include <span>

#include "gaps.hpp"

namespace carom::certify {

/// From and to are points in time that hold the span between them.
struct Span {
  Enclosure from, to;
};

/// A contact that is known: the overlap function is exactly 0 there, at its beginning or its end.
struct KnownContact {
  Enclosure time;
  bool at_end = false;
  int order = 1;                         ///< of the zero
  std::array<std::int64_t, 3> period{};  ///< of two balls
  int side = 1;                          ///< of an edge
};

class Apart {
 public:
  using Period = std::array<std::int64_t, 3>;

  /// In one dimension `right_of[i]` is whom ball i has on its right, and in which period.
  struct Neighbour {
    std::uint32_t ball = 0;
    std::int64_t period = 0;
  };

  Apart(const System& system, int bits);

  /// Balls i and j: all their images. In one dimension j is on the right of i.
  [[nodiscard]] Proof pair(std::uint32_t i, const Flight& a, std::uint32_t j, const Flight& b, const Span& span,
                           std::span<const KnownContact> known) const;
  /// Ball i and one piece of a wall.
  [[nodiscard]] Proof piece(std::uint32_t i, const Flight& a, std::size_t piece, const Span& span,
                            std::span<const KnownContact> known) const;

  [[nodiscard]] const Gaps<Enclosure>& gaps() const { return fine_; }
  [[nodiscard]] const std::optional<Neighbour>& right_of(std::uint32_t i) const { return right_of_[i]; }
  [[nodiscard]] const std::optional<Neighbour>& left_of(std::uint32_t i) const { return left_of_[i]; }

 private:
  template <class I>
  [[nodiscard]] Proof pair_at(const Gaps<I>& gaps, std::uint32_t i, const Flight& a, std::uint32_t j, const Flight& b,
                              const Period& period, const Span& span, std::span<const KnownContact> known) const;
  template <class I>
  [[nodiscard]] Proof piece_at(const Gaps<I>& gaps, std::uint32_t i, const Flight& a, std::size_t piece, const Span& span,
                               std::span<const KnownContact> known) const;
  template <class I>
  [[nodiscard]] std::vector<I> over(const Span& span, const Enclosure& base, Polynomial<I> gap,
                                    std::span<const KnownContact> known) const;
  template <class F>
  [[nodiscard]] Proof for_each_image(std::uint32_t i, const Flight& a, std::uint32_t j, const Flight& b, const Span& span, F&& f) const;
  void order_on_a_line();

  const System& system_;
  Gaps<Enclosure> fine_;
  Gaps<Outward> coarse_;
  int depth_;  // halvings of a span in enclosures
  std::vector<std::optional<Neighbour>> right_of_, left_of_;
};

}  // namespace carom::certify
