#pragma once
// A bounded increasing calendar: which balls are due next, in constant time whatever their number.
//
// Time is cut into fine buckets of equal width [Paul2007]; 64 of them make an outer bucket, a ring of outer buckets covers
// the near future, and what is later waits in one list. Nothing is sorted before its fine bucket comes. Only numbers of
// balls are kept: when a ball is due is asked again when its bucket comes, so an entry that has become stale is recognised
// by its time and dropped there. The bucket of a time is a monotone function of it, so buckets never mix up the order.

#include <cstdint>

#include "carom/core/clock.hpp"
#include "carom/core/pages.hpp"

namespace carom {

class Calendar {
 public:
  static constexpr int fine_bits = 6;
  static constexpr std::uint32_t fine = 1U << fine_bits;  ///< fine buckets in an outer one
  static constexpr std::uint32_t most_balls = 1U << (32 - fine_bits);

  /// Empties it; the first bucket is still to come. `width` [L] is that of a fine bucket, `outer` (a power of two) the number of outer buckets in the ring.
  void reset(const Time<double>& now, double width, std::uint32_t outer);

  [[nodiscard]] double width() const noexcept { return 1 / per_width_; }

  /// The fine bucket of a moment not before the last reset; what is too far to have a bucket of its own is in `last`.
  CAROM_INLINE std::int64_t bucket(const Time<double>& t) const {
    const double since = (static_cast<double>(t.epoch - start_.epoch) + (t.offset - start_.offset)) * per_width_;
    return since < 0x1p52 ? static_cast<std::int64_t>(since) : last;
  }
  [[nodiscard]] CAROM_INLINE std::int64_t current() const { return now_; }

  /// How far into its bucket a moment of the current one is, in widths: a monotone function of it.
  CAROM_INLINE double share(const Time<double>& t) const {
    return (static_cast<double>(t.epoch - start_.epoch) + (t.offset - start_.offset)) * per_width_ - static_cast<double>(now_);
  }

  /// Ball i is due in bucket b > current().
  CAROM_INLINE void push(std::uint32_t i, std::int64_t b) {
    const std::int64_t ahead = (b >> fine_bits) - (now_ >> fine_bits);
    if (ahead == 0) {
      append(near_[b & (fine - 1)], i);
    } else if (ahead < ring_size_) {
      append(ring_[static_cast<std::size_t>((b >> fine_bits) & (ring_size_ - 1))],
             i | static_cast<std::uint32_t>(b & (fine - 1)) << (32 - fine_bits));
      ++in_ring_;
    } else {
      append(far_, i);
    }
  }

  /// Goes on to the next fine bucket and hands its entries to f(ball). `bucket_of(ball)` is asked of those that wait beyond
  /// the ring. False if nothing waits anywhere, or too far off for the width of the buckets.
  template <class F, class BucketOf>
  CAROM_INLINE bool next(F&& f, BucketOf&& bucket_of) {
    while (true) {
      ++now_;
      if ((now_ & (fine - 1)) == 0 && !enter_outer(bucket_of)) return false;
      std::uint32_t& head = near_[now_ & (fine - 1)];
      if (head == none) continue;
      take(head, f);
      return true;
    }
  }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static constexpr std::int64_t last = std::int64_t{1} << 60;
  static constexpr std::uint32_t in_chunk = 30;
  static constexpr std::uint32_t ball_mask = most_balls - 1;

  struct Chunk {
    std::uint32_t next, count;
    std::uint32_t entries[in_chunk];
  };

  CAROM_INLINE void append(std::uint32_t& head, std::uint32_t entry) {
    if (head == none || chunks_[head].count == in_chunk) {
      const std::uint32_t c = new_chunk();
      chunks_[c].next = head;
      chunks_[c].count = 0;
      head = c;
    }
    Chunk& chunk = chunks_[head];
    chunk.entries[chunk.count++] = entry;
  }
  CAROM_INLINE std::uint32_t new_chunk() {
    if (free_ != none) {
      const std::uint32_t c = free_;
      free_ = chunks_[c].next;
      return c;
    }
    chunks_.resize(chunks_.size() + 1);
    return static_cast<std::uint32_t>(chunks_.size() - 1);
  }
  /// Hands on the entries of a list and frees it.
  template <class F>
  CAROM_INLINE void take(std::uint32_t& head, F&& f) {
    std::uint32_t c = head;
    head = none;
    while (c != none) {
      for (std::uint32_t k = 0; k < chunks_[c].count; ++k) f(chunks_[c].entries[k]);
      const std::uint32_t next = chunks_[c].next;
      chunks_[c].next = free_;
      free_ = c;
      c = next;
    }
  }
  template <class BucketOf>
  CAROM_INLINE bool enter_outer(BucketOf&& bucket_of) {
    std::int64_t outer = now_ >> fine_bits;
    if (in_ring_ == 0) {  // nothing near: go where the first of the far ones is
      if (far_ == none) return false;
      std::int64_t first = last;
      for (std::uint32_t c = far_; c != none; c = chunks_[c].next)
        for (std::uint32_t k = 0; k < chunks_[c].count; ++k) {
          const std::int64_t b = bucket_of(chunks_[c].entries[k]);
          if (b >= now_ && b < first) first = b;
        }
      if (first == last) return false;
      outer = first >> fine_bits;
      now_ = outer << fine_bits;
      spread_far(bucket_of);
    } else if ((outer & (ring_size_ / 2 - 1)) == 0) {
      spread_far(bucket_of);
    }
    std::uint32_t c = ring_[static_cast<std::size_t>(outer & (ring_size_ - 1))];
    ring_[static_cast<std::size_t>(outer & (ring_size_ - 1))] = none;
    take(c, [this](std::uint32_t entry) {
      --in_ring_;
      append(near_[entry >> (32 - fine_bits)], entry & ball_mask);
    });
    return true;
  }
  /// Those in the far list that the ring has reached go there.
  template <class BucketOf>
  CAROM_INLINE void spread_far(BucketOf&& bucket_of) {
    std::uint32_t list = far_;
    far_ = none;
    take(list, [&](std::uint32_t ball) {
      const std::int64_t b = bucket_of(ball);
      if (b < now_) return;  // stale: due earlier, and entered there
      if (b == now_) {
        append(near_[b & (fine - 1)], ball);
      } else {
        push(ball, b);
      }
    });
  }

  Time<double> start_;
  double per_width_ = 1;
  std::int64_t now_ = -1;  // the fine bucket that is being emptied
  std::int64_t ring_size_ = 0, in_ring_ = 0;
  std::uint32_t near_[fine] = {};  // lists of the fine buckets of the current outer one
  std::uint32_t far_ = none, free_ = none;
  PageArray<std::uint32_t> ring_;
  PageArray<Chunk> chunks_;
};

}  // namespace carom
