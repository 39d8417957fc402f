#pragma once
// The whole state of a run as bytes: what a checkpoint holds. One description serves writing and reading.
//
// Queue and search are not in it: they are functions of the stored states, so a run goes on bit for bit under another queue
// and search too.

#include <concepts>
#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "ball_record.hpp"
#include "bytes.hpp"
#include "carom/sim/books.hpp"
#include "carom/sim/collapse_watch.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// Visits every number of a thing, in one order: `archive(x)` writes x or reads it.
template <class Archive>
class StateVisitor {
 public:
  explicit StateVisitor(Archive& archive) : archive_(archive) {}

  // The things are constant when they are written.
  void world(auto& w) {
    balls(w);
    bodies(w);
  }
  /// A world is read into one of as many balls.
  void balls(auto& w) {
    using W = std::remove_cvref_t<decltype(w)>;
    count(w.balls.size());
    BallRecords<Archive, typename W::Real, W::dimension> records(archive_);
    for (std::size_t i = 0; i < w.balls.size(); ++i) {
      auto&& ball = w.balls[i];  // of a view: a value
      auto&& detail = w.details[i];
      records(ball, detail);
    }
  }
  /// Reads as many balls, and hands each to f(number, ball, detail).
  template <class Real, int D, class F>
  void read_balls(std::size_t size, F&& f) {
    count(size);
    BallRecords<Archive, Real, D> records(archive_);
    Ball<Real, D> ball;
    BallDetail<Real, D> detail;
    for (std::size_t i = 0; i < size; ++i) {
      records(ball, detail);
      f(static_cast<std::uint32_t>(i), ball, detail);
    }
  }
  void bodies(auto& w) {
    sized(w.bodies, [this](auto& b) { body(b); });
  }
  void counts(auto& c) { each(c.ball_ball, c.ball_wall, c.other, c.ties); }
  void exactness(auto& e) {
    each(e.max_gap_error, e.max_gap_error_relative, e.clamped, e.unresolved, e.singular, e.summed_bounces, e.repredicted);
  }
  void books(auto& b) {
    wide(b.dissipated);
    wide(b.injected);
    each(b.largest_injected, b.lowest_potential);
  }
  void watch(auto& w) {
    sized(w.streaks(), [this](auto& s) {
      for (auto& r : s.recent) each(r);
      each(s.count, s.falls, s.dissipates, s.driven, s.steady, s.factor, s.impulse, s.largest, s.before, s.strongest,
           s.peak);
      time(s.block_start);
      each(s.duration);
    });
  }
  void growth(auto& g) {
    wide(g.kinetic);
    wide(g.virial);
    wide(g.before);
    time(g.begun);
    each(g.movable, g.pressure);
  }
  void time(auto& t) { each(t.epoch, t.offset); }

 private:
  template <class... T>
  void each(T&... x) {
    (archive_(x), ...);
  }
  template <class V>
  void vector(V& v) {
    for (int k = 0; k < v.size(); ++k) archive_(v[k]);
  }
  template <class F>
  void sized(auto& v, F&& f) {
    archive_.size(v);
    for (auto& x : v) f(x);
  }
  void count(std::uint64_t size) {
    std::uint64_t there = size;
    archive_(there);
    if (there != size) throw std::out_of_range("another number of balls");
  }
  void wide(auto& x) {
    if constexpr (requires { x.lo; }) {
      each(x.hi, x.lo);
    } else {
      each(x);
    }
  }

  void body(auto& b) {
    each(b.mass);
    vector(b.position);
    for (auto& n : b.image) each(n);
    sized(b.members, [this](auto& m) { each(m); });
    sized(b.offsets, [this](auto& o) { vector(o); });
    sized(b.shifts, [this](auto& s) {
      for (auto& n : s) each(n);
    });
  }

  Archive& archive_;
};

/// A real other than double as text that reads back as the same bits.
template <class Real>
[[nodiscard]] inline std::string round_trip_text(const Real& x) {
  if constexpr (std::is_same_v<Real, long double>) {
    return fmt::format("{:a}", x);
  } else {
    return x.str(static_cast<std::streamsize>(x.precision()) + 4, std::ios_base::scientific);
  }
}
template <class Real>
[[nodiscard]] inline Real value_of_text(const std::string& text) {
  if constexpr (std::is_same_v<Real, long double>) {
    return std::stold(text);
  } else {
    return Real(text);
  }
}

struct WritingArchive {
  static constexpr bool reads = false;
  ByteWriter out;

  template <class T>
  void operator()(const T& x) {
    if constexpr (std::is_integral_v<T> || std::is_enum_v<T> || std::is_same_v<T, double>) {
      out.put(x);
    } else {
      out.put(std::string_view(round_trip_text(x)));
    }
  }
  /// An integer that is mostly small.
  void whole(std::integral auto n) { out.put_whole(static_cast<std::int64_t>(n)); }
  void size(const auto& v) {
    out.put(static_cast<std::uint64_t>(v.size()));
  }
};

struct ReadingArchive {
  static constexpr bool reads = true;
  ByteReader in;

  template <class T>
  void operator()(T& x) {
    if constexpr (std::is_integral_v<T> || std::is_enum_v<T> || std::is_same_v<T, double>) {
      in.get(x);
    } else {
      std::string text;
      in.get(text);
      try {
        x = value_of_text<T>(text);
      } catch (const std::exception&) {
        throw std::out_of_range("not a number");
      }
    }
  }
  template <std::integral T>
  void whole(T& n) {
    const std::int64_t value = in.get_whole();
    n = static_cast<T>(value);
    if (static_cast<std::int64_t>(n) != value) throw std::out_of_range("a number beyond its range");
  }
  template <class T>
  void size(std::vector<T>& v) {
    v.resize(in.count());
  }
};

}  // namespace carom
