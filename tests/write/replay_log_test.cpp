// The log of a replay: read back as a page reads it, each flight must end where the next begins.

#include "carom/write/replay_log.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>

#include <gtest/gtest.h>

#include "carom/scene/read.hpp"
#include "write/scenes.hpp"

namespace carom {
namespace {

/// A chunk, column by column.
struct Chunk {
  std::uint32_t D, E, C, flags;
  std::vector<double> time, impulse, position, velocity, acceleration, radius, mass;
  std::vector<float> time_low, gap, energy, dissipated, balance, normal;
  std::vector<std::uint32_t> ball, partner, feature, changes_end, change_ball;
  std::vector<std::uint8_t> kind, tie;

  explicit Chunk(const std::string& bytes) : bytes_(bytes) {
    std::vector<std::uint32_t> head;
    take(head, 8);
    EXPECT_EQ(head[0], 0x4c505243U);
    D = head[1];
    E = head[2];
    C = head[3];
    flags = head[4];
    take(time, E);
    take(impulse, E);
    take(position, C * D);
    take(velocity, C * D);
    take(acceleration, flags & 1U ? C * D : 0);
    for (auto* column : {&radius, &mass}) take(*column, flags & 2U ? C : 0);
    for (auto* column : {&time_low, &gap, &energy, &dissipated, &balance}) take(*column, E);
    take(normal, E * D);
    for (auto* column : {&ball, &partner, &feature, &changes_end}) take(*column, E);
    take(change_ball, C);
    take(kind, E);
    take(tie, E);
    EXPECT_EQ(at_, bytes.size());
  }

 private:
  template <class T>
  void take(std::vector<T>& column, std::size_t length) {
    column.resize(length);
    ASSERT_LE(at_ + length * sizeof(T), bytes_.size());
    std::memcpy(column.data(), bytes_.data() + at_, length * sizeof(T));
    at_ += length * sizeof(T);
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

struct Flight {
  double hi = 0, lo = 0;
  std::vector<double> x, v, a;
};

struct Replayed {
  std::vector<Chunk> chunks;
  double worst = 0;  // distance in any coordinate between where a flight ends and the next begins, over the largest one
  std::size_t events = 0, others = 0, gone = 0;
  double largest_balance = 0;
  std::map<std::uint32_t, Flight> flights;
};

/// Replays the scene from its log alone. `leaps`: balls may leap, so `worst` is not looked at.
Replayed replay(const Scene& scene, bool leaps = false) {
  Replayed r;
  Simulation simulation(scene);
  const std::array<double, 3> periods = simulation.periods();
  double size = 1;
  for (const BallState& b : simulation.balls()) {
    Flight f;
    f.hi = simulation.time();
    for (std::size_t k = 0; k < b.position.size(); ++k) {
      f.x.push_back(b.position[k]);
      f.v.push_back(b.velocity[k]);
      f.a.push_back(k < scene.motion.acceleration.size() ? scene.motion.acceleration[k].value : 0.0);
      size = std::max(size, std::abs(f.x.back()));
    }
    r.flights[b.index] = f;
  }
  {
    std::vector<std::string> texts;
    ReplayLog log(scene, simulation, [&](std::string bytes) { texts.push_back(std::move(bytes)); });
    simulation.run([&](const Collision& c) { log.add(c); });
    log.flush();
    for (const std::string& text : texts) r.chunks.emplace_back(text);
    EXPECT_EQ(
        log.events(), static_cast<std::int64_t>(simulation.counts().collisions()) + [&] {
          std::int64_t n = 0;
          for (const Chunk& c : r.chunks) n += std::count(c.kind.begin(), c.kind.end(), 2);
          return n;
        }());
  }
  for (const Chunk& c : r.chunks) {
    std::uint32_t change = 0;
    for (std::uint32_t e = 0; e < c.E; ++e) {
      ++r.events;
      r.others += c.kind[e] == 2;
      if (!std::isnan(c.balance[e])) r.largest_balance = std::max<double>(r.largest_balance, std::abs(c.balance[e]));
      EXPECT_LE(std::abs(c.time_low[e]), std::abs(c.time[e]) * 0x1p-53 * 1.001);
      for (; change < c.changes_end[e]; ++change) {
        Flight& f = r.flights.at(c.change_ball[change]);
        const double s = (c.time[e] - f.hi) + (static_cast<double>(c.time_low[e]) - f.lo);
        EXPECT_GE(s, 0);
        for (std::size_t k = 0; k < c.D; ++k) {
          const std::size_t at = change * c.D + k;
          double apart = f.x[k] + s * (f.v[k] + s * f.a[k] / 2) - c.position[at];
          if (periods[k] > 0) apart -= periods[k] * std::round(apart / periods[k]);
          size = std::max(size, std::abs(f.v[k] * s));
          if (!leaps) r.worst = std::max(r.worst, std::abs(apart) / size);
          f.x[k] = c.position[at];
          f.v[k] = c.velocity[at];
          if (c.flags & 1U) f.a[k] = c.acceleration[at];
        }
        if (c.flags & 2U) r.gone += std::isnan(c.radius[change]);
        f.hi = c.time[e];
        f.lo = c.time_low[e];
      }
    }
    EXPECT_EQ(change, c.C);
  }
  return r;
}

Scene read(const std::string& text) { return read_scene(text, "a.toml"); }

// x + v s is rounded twice, and the stored position once.
constexpr double few_ulp = 8 * 0x1p-53;

TEST(ReplayLog, begins_every_flight_where_the_last_one_ended) {
  const Replayed box = replay(test::head_on(2));
  EXPECT_EQ(box.events, 3u);
  EXPECT_LE(box.worst, few_ulp);
  const Replayed gas =
      replay(read("dimension = 3\n[[gas]]\ncount = 64\npacking_fraction = 0.2\nradius = 0.5\n[run]\nevents = 3000\n"));
  EXPECT_EQ(gas.events, 3000u);
  EXPECT_LE(gas.worst, few_ulp);
  EXPECT_LE(gas.largest_balance, 96 * 100 * 0x1p-52) << "3 N / 2 kT, a hundred ulps";
  const Replayed falling =
      replay(read("[space]\nkind = \"box\"\nlower = [0, 0]\nupper = [10, 10]\n[motion]\nacceleration = [0, -9.81]\n"
                  "[[ball]]\nposition = [3, 5]\nvelocity = [1, 0]\n[[ball]]\nposition = [7, 5]\nvelocity = [-1, "
                  "1]\n[run]\nevents = 200\n"));
  EXPECT_EQ(falling.events, 200u);
  EXPECT_LE(falling.worst, 2 * few_ulp);
}

TEST(ReplayLog, splits_chunks_and_loses_nothing) {
  const Replayed long_run =
      replay(read("dimension = 1\n[space]\nkind = \"box\"\nlower = [0]\nupper = [10]\n[[ball]]\nposition = [5]\nvelocity = "
                  "[1]\n[run]\nevents = 70000\n"));
  EXPECT_EQ(long_run.chunks.size(), 2u);
  EXPECT_EQ(long_run.events, 70000u);
  EXPECT_LE(long_run.worst, few_ulp);
}

// At 2^40 the doubles are 2^-12 apart; time + time_low holds the moment to 2^-24 of that.
TEST(ReplayLog, keeps_late_moments) {
  const Replayed late =
      replay(read("dimension = 1\n[space]\nkind = \"box\"\nlower = [0]\nupper = [1]\n[[ball]]\nposition = [0.5]\nvelocity "
                  "= [0.7]\nradius = 0.1\n"
                  "[run]\nstart = 1099511627776.0\nevents = 50\n"));
  EXPECT_EQ(late.events, 50u);
  EXPECT_LE(late.worst, 0x1p-36) << "with doubles alone it would be 2^-13";
}

// A ball that rests on a ramp starts in contact, slides down with a = g sin(30 deg) along it, and leaves its end: none of
// that is a collision. Length 2 from rest under g/2 = 4.905: t = sqrt(4 / 4.905).
TEST(ReplayLog, holds_what_is_no_collision) {
  const Replayed ramp =
      replay(read("[motion]\nacceleration = [0, -9.81]\n[collision]\nrestitution = 0\nregularise = \"rest\"\n"
                  "[[wall]]\nkind = \"segment\"\nfrom = [0, 0]\nto = [1.7320508075688772, 1]\n"
                  "[[ball]]\nposition = [1.5, 1.6]\nradius = 0.1\n[run]\nuntil = 3\n"));
  EXPECT_GE(ramp.others, 1u);
  EXPECT_LE(ramp.worst, 1e-14);
  EXPECT_LE(ramp.largest_balance, 1e-14);
}

TEST(ReplayLog, moves_all_of_a_body_and_lets_merged_balls_go) {
  const std::string two =
      "[[ball]]\nposition = [-2, 0]\nvelocity = [1, 0]\n[[ball]]\nposition = [0, 0.25]\n[[ball]]\nposition = [3, "
      "0]\nvelocity = [-1, 0]\n"
      "[run]\nuntil = 10\n";
  const Replayed stick = replay(read("[collision]\nlaw = \"stick\"\n" + two));
  EXPECT_EQ(stick.events, 2u);
  EXPECT_EQ(stick.chunks.at(0).C, 5u) << "two balls, then all three";
  EXPECT_LE(stick.worst, few_ulp);
  const Replayed merge = replay(read("[collision]\nlaw = \"merge\"\n" + two), true);
  EXPECT_EQ(merge.events, 2u);
  EXPECT_EQ(merge.gone, 2u);
  EXPECT_DOUBLE_EQ(merge.chunks.at(0).mass.at(2), 3.0);
}

}  // namespace
}  // namespace carom
