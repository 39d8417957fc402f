#pragma once
// RapidCheck with a fixed seed, reported through GoogleTest.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <sstream>

namespace carom::testing {

/// Tries `property` on `cases` random inputs, the same in every run of the program.
template <class Property>
void expect_property(Property&& property, int cases, std::uint64_t seed) {
  rc::detail::TestMetadata metadata;
  const ::testing::TestInfo* const info = ::testing::UnitTest::GetInstance()->current_test_info();
  metadata.id = std::string(info->test_suite_name()) + "." + info->name();
  rc::detail::TestParams params;
  params.seed = seed;
  params.maxSuccess = cases;
  params.maxDiscardRatio = 20;
  const rc::detail::TestResult result = rc::detail::checkTestable(std::forward<Property>(property), metadata, params);
  if (result.is<rc::detail::SuccessResult>()) return;
  std::ostringstream text;
  rc::detail::printResultMessage(result, text);
  ADD_FAILURE() << text.str();
}

}  // namespace carom::testing
