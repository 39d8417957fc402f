// Memory from the operating system: what is there stays where arrays grow, and new bytes are 0.

#include "carom/core/pages.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "carom/core/page_vector.hpp"

namespace carom {
namespace {

// Through sizes of one small page, of many, and of several huge ones, so that every way of growing is taken.
TEST(PageArray, keeps_what_is_there_when_it_grows) {
  PageArray<std::uint32_t> array(1);
  std::size_t size = 1;
  for (const std::size_t larger : {2000u, 300'000u, 600'000u, 5'000'000u, 9'000'000u}) {
    for (std::size_t i = size / 2; i < size; ++i) array[i] = static_cast<std::uint32_t>(7 * i + 1);
    const std::size_t full = size;
    array.resize(larger);
    for (std::size_t i = full / 2; i < full; ++i) ASSERT_EQ(array[i], static_cast<std::uint32_t>(7 * i + 1)) << larger;
    for (std::size_t i = full; i < larger; i += 1009) ASSERT_EQ(array[i], 0u) << larger;
    size = larger;
  }
}

TEST(PageVector, is_a_vector_at_every_size) {
  PageVector<double> v;
  for (int i = 0; i < 400'000; ++i) v.push_back(i);
  const PageVector<double> copy = v;
  EXPECT_EQ(copy, v);
  EXPECT_EQ(v.front(), 0);
  EXPECT_EQ(v.back(), 399'999);
  give_back(v);
  EXPECT_EQ(v.capacity(), 0u);
  EXPECT_EQ(copy[123'456], 123'456);
}

}  // namespace
}  // namespace carom
