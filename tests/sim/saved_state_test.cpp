// A saved state: few bytes a ball, handed on in pieces, and the run goes on from it bit for bit wherever it was cut.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "carom/core/error.hpp"
#include "carom/scene/read.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {
namespace {

Scene gas(const std::string& engine = "", int balls = 4000) {
  return read_scene("dimension=3\n" + engine + "[[gas]]\ncount=" + std::to_string(balls) +
                        "\npacking_fraction=0.49\nradius=0.5\n[run]\nevents=1000000\n",
                    "test");
}
const char* const plain = "[engine]\nsearch='cells'\nqueue='heap'\n";

std::vector<std::string> pieces_of(const Simulation& simulation) {
  std::vector<std::string> pieces;
  simulation.save([&pieces](std::string_view piece) { pieces.emplace_back(piece); });
  return pieces;
}

// 48 bytes are positions and velocities, 8 the offset of the time; the rest must be small.
TEST(SavedState, takes_few_bytes_a_ball) {
  Simulation simulation(gas());
  ASSERT_EQ(simulation.composition().search, "neighbour lists");
  simulation.advance(std::nullopt, 20000);
  const double bytes = static_cast<double>(simulation.state().size()) / 4000;
  EXPECT_GT(bytes, 56);
  EXPECT_LT(bytes, 90);
}

TEST(SavedState, is_handed_on_in_pieces) {
  Simulation simulation(gas("", 20000));
  simulation.advance(std::nullopt, 1000);
  std::string all;
  std::size_t largest = 0;
  for (const std::string& piece : pieces_of(simulation)) {
    all += piece;
    largest = std::max(largest, piece.size());
  }
  EXPECT_EQ(all, simulation.state());
  EXPECT_LT(4 * largest, all.size());
}

TEST(SavedState, is_read_in_pieces) {
  Simulation simulation(gas());
  simulation.advance(std::nullopt, 1000);
  const std::string state = simulation.state();
  Simulation other(gas());
  std::size_t largest = 0;
  other.restore(state.size(), [&](std::uint64_t at, std::span<char> to) {
    ASSERT_LE(at + to.size(), state.size());
    largest = std::max(largest, to.size());
    std::memcpy(to.data(), state.data() + at, to.size());
  });
  EXPECT_EQ(other.state(), state);
  EXPECT_LE(largest, std::size_t{1} << 18);
}

// The stored states are the same whoever computed them; only the work that it took differs (exactness.repredicted, 8 bytes).
// With dissipation, because without it the integrator for many keeps no `reach`, which only the watch for collapses asks for.
TEST(SavedState, is_that_of_the_run_and_not_of_the_engine) {
  const std::string dissipating = "[collision]\nrestitution=0.9\n";
  Simulation lists(gas(dissipating, 1000)), cells(gas(dissipating + plain, 1000));
  ASSERT_EQ(lists.composition().search, "neighbour lists");
  ASSERT_NE(cells.composition().search, "neighbour lists");
  lists.advance(std::nullopt, 3000);
  cells.advance(std::nullopt, 3000);
  const std::string a = lists.state(), b = cells.state();
  ASSERT_EQ(a.size(), b.size());
  std::size_t differing = 0;
  for (std::size_t i = 0; i + 8 < a.size(); ++i) differing += a[i] != b[i];  // the last 8 are the fingerprint
  EXPECT_LE(differing, 8u);
}

// Cut anywhere, again and again, each time to go on under another engine: the end is that of the run that was left alone.
TEST(SavedState, goes_on_from_any_moment_under_any_engine) {
  Simulation whole(gas());
  whole.advance(std::nullopt, 6000);
  std::string state;
  std::int64_t done = 0;
  std::uint64_t random = 12345;
  for (int k = 0; done < 6000; ++k) {
    random = random * 6364136223846793005u + 1442695040888963407u;
    const std::int64_t some = std::min<std::int64_t>(1 + static_cast<std::int64_t>(random >> 33) % 1500, 6000 - done);
    Simulation part(k % 3 == 1 ? gas(plain) : k % 3 == 2 ? gas("[engine]\nvectors=false\n") : gas());
    if (!state.empty()) part.restore(state);
    part.advance(std::nullopt, some);
    done += some;
    state = part.state();
  }
  Simulation end(gas());
  end.restore(state);
  EXPECT_EQ(end.time().value, whole.time().value);
  for (std::uint32_t i = 0; i < 4000; ++i) {
    const Glimpse a = whole.glimpse(i), b = end.glimpse(i);
    ASSERT_EQ(a.position, b.position) << i;
    ASSERT_EQ(a.velocity, b.velocity) << i;
  }
}

TEST(SavedState, that_ends_early_or_is_damaged_changes_nothing) {
  Simulation a(gas("", 1000)), b(gas("", 1000));
  a.advance(std::nullopt, 500);
  b.advance(std::nullopt, 700);
  const std::string state = a.state(), before = b.state();
  for (const std::size_t at : {std::size_t{3}, std::size_t{30}, state.size() / 3, state.size() - 9, state.size() - 1}) {
    std::string damaged = state;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    EXPECT_THROW(b.restore(damaged), InputError) << at;
  }
  EXPECT_THROW(b.restore(state.substr(0, state.size() / 2)), InputError);
  EXPECT_EQ(b.state(), before);
}

}  // namespace
}  // namespace carom
