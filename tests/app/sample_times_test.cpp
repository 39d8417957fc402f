#include "sample_times.hpp"

#include <gtest/gtest.h>

#include "carom/core/rational.hpp"

namespace carom::app {
namespace {

RunSpec sampled(const char* start, const char* every) {
  RunSpec run;
  run.start = parse_number(start);
  run.sample_every = parse_number(every);
  return run;
}

TEST(SampleTimes, are_exact_multiples) {
  SampleTimes times(sampled("1", "0.1"));
  for (int k = 1; k <= 1000; ++k, times.advance()) {
    const auto next = times.next();
    ASSERT_TRUE(next);
    EXPECT_EQ(exact(*next), Rational(10 + k, 10));
    EXPECT_EQ(next->value, (10 + k) / 10.0);  // the double nearest to it
  }
}

TEST(SampleTimes, end_before_the_run_does) {
  RunSpec run = sampled("0", "1/3");
  run.until = parse_number("1");
  SampleTimes times(run);
  int count = 0;
  for (; times.next(); times.advance()) ++count;
  EXPECT_EQ(count, 2);  // 1/3 and 2/3: the end has a frame of its own
}

TEST(SampleTimes, skip_what_is_past) {
  SampleTimes times(sampled("1", "0.5"));
  times.skip_to(1.0);
  EXPECT_EQ(times.next()->value, 1.5);
  times.skip_to(2.25);
  EXPECT_EQ(times.next()->value, 2.5);
  times.skip_to(2.5);
  EXPECT_EQ(times.next()->value, 3.0);
}

TEST(SampleTimes, are_none_unless_asked_for) { EXPECT_FALSE(SampleTimes(RunSpec()).next()); }

}  // namespace
}  // namespace carom::app
