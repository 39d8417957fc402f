// First falls of smooth functions from a bound of their second derivative: nothing is stepped over, however narrow.

#include "carom/solve/bracket.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace carom {
namespace {

constexpr double pi = std::numbers::pi;

Overlap<double> shifted_sine(double t, double height) { return {height + std::sin(t), std::cos(t)}; }

TEST(Bracket, finds_the_first_of_many_roots) {
  for (const double height : {-0.9, 0.0, 0.5, 0.99}) {
    const auto f = [&](double t) { return shifted_sine(t, height); };
    const double falls = pi + std::asin(height);
    EXPECT_NEAR(bracketed_fall(f, height < 0 ? 1.5 : 0.1, 100.0, 1.0), falls, 4e-15 / std::sqrt(1 - height * height)) << height;
  }
}

TEST(Bracket, does_not_step_over_two_roots_that_are_close) {
  // The sine dips below zero by 1e-12, for 2.8e-6 of time.
  const auto f = [](double t) { return shifted_sine(t, 1 - 1e-12); };
  EXPECT_NEAR(bracketed_fall(f, 0.0, 100.0, 1.0), 1.5 * pi - std::sqrt(2e-12), 1e-9);
  const auto misses = [](double t) { return shifted_sine(t, 1 + 1e-12); };
  EXPECT_EQ(bracketed_fall(misses, 0.0, 100.0, 1.0), never<double>());
}

TEST(Bracket, a_loose_bound_costs_steps_only) {
  int near = 0, loose = 0;
  const auto f = [](int& calls) { return [&calls](double t) { ++calls; return shifted_sine(t, 0.5); }; };
  const double exact = 7 * pi / 6;
  EXPECT_NEAR(bracketed_fall(f(near), 0.0, 100.0, 1.0), exact, 2e-15);
  EXPECT_NEAR(bracketed_fall(f(loose), 0.0, 100.0, 1e4), exact, 2e-15);
  EXPECT_LT(near, 20);
  EXPECT_GT(loose, near);
}

TEST(Bracket, straight_lines_are_exact) {
  const auto f = [](double t) { return Overlap<double>{3 - 2 * t, -2}; };
  EXPECT_EQ(bracketed_fall(f, 0.0, never<double>(), 0.0), 1.5);
  const auto rises = [](double t) { return Overlap<double>{3 + t, 1}; };
  EXPECT_EQ(bracketed_fall(rises, 0.0, never<double>(), 0.0), never<double>());
}

TEST(Bracket, an_overlap_that_rises_waits_for_where_it_turns) {
  // -1.5 + sin: never above 0, turns to fall at pi / 2. The sine's own flatness there leaves it to the square root of a rounding.
  const auto f = [](double t) { return shifted_sine(t, -1.5); };
  EXPECT_NEAR(bracketed_fall(f, 0.0, 100.0, 1.0), pi / 2, 1e-7);
  EXPECT_EQ(bracketed_fall(f, 2.0, 100.0, 1.0), 2.0) << "falling: now";
}

TEST(Bracket, waits_are_taken_and_the_end_is_kept) {
  int calls = 0;
  const auto f = [&](double t) {
    ++calls;
    return shifted_sine(t, 0.5);
  };
  const auto wait = [](double t) { return t < 3.5 ? 3.5 - t : 0.0; };
  EXPECT_NEAR(bracketed_fall(f, wait, 0.0, 100.0, 1.0), 7 * pi / 6, 2e-15);
  EXPECT_LT(calls, 8);
  EXPECT_EQ(bracketed_fall(f, 0.0, 3.6, 1.0), never<double>());
  EXPECT_EQ(bracketed_fall(f, [](double) { return never<double>(); }, 0.0, 100.0, 1.0), never<double>());
}

}  // namespace
}  // namespace carom
