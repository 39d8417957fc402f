// A log or a certificate that is wrong in any one place is rejected, and the place is named.

#include <sstream>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "carom/core/error.hpp"
#include "certify/log.hpp"
#include "certify/replay.hpp"
#include "certify/scenes.hpp"
#include "write/text_file.hpp"

namespace carom {
namespace {

using namespace testing;
using certify::Claim;
using certify::Finding;
using certify::Proof;
using certify::Report;
using certify::Verdict;

constexpr int digits = 100;

/// Five disks in a box until time 4: some 40 events.
Scene disks() {
  Scene scene = scene_of("[space]\nkind = \"box\"\nlower = [0, 0]\nupper = [6, 5]\n[[gas]]\ncount = 5\npacking_fraction = 0.3\n[run]\nuntil = 6\n");
  return scene;
}

std::vector<Claim> log_of(const Scene& scene, const certify::System& system) {
  std::vector<Claim> log;
  Simulation simulation(scene, Precision::decimal(digits));
  simulation.run([&](const Collision& c) {
    double reach = nearest_double(system.balls[c.ball.number].radius);
    if (c.kind == EventKind::ball_ball) reach += nearest_double(system.balls[c.partner.number].radius);
    log.push_back(certify::claim_of(c, reach, simulation.periods()));
  });
  return log;
}

Finding replayed(const Scene& scene, const certify::System& system, const std::vector<Claim>& log) {
  const certify::Bits bits(certify::bits_of_digits(digits));
  certify::Replay replay(system, digits);
  for (const Claim& c : log)
    if (Finding f = replay.take(c); f.proof != Proof::yes) return f;
  return replay.finish(exact(*scene.run.until));
}

class TamperedLog : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    scene_ = scene_of(GetParam());
    system_ = certify::system_of(scene_);
    log_ = log_of(scene_, system_);
    ASSERT_GT(log_.size(), 10u);
  }
  [[nodiscard]] Finding replay(const std::vector<Claim>& log) const { return replayed(scene_, system_, log); }

  Scene scene_;
  certify::System system_;
  std::vector<Claim> log_;
};

TEST_P(TamperedLog, is_proven_as_it_was) { EXPECT_EQ(replay(log_).proof, Proof::yes) << replay(log_).what; }

// Rejected at the first of the two: it happens after an event that it stands before, or its balls are elsewhere.
TEST_P(TamperedLog, two_events_swapped) {
  for (std::size_t k = 0; k + 1 < log_.size(); ++k) {
    std::vector<Claim> log = log_;
    std::swap(log[k], log[k + 1]);
    const Finding f = replay(log);
    EXPECT_EQ(f.proof, Proof::no) << k;
    EXPECT_GE(f.event, static_cast<std::int64_t>(k + 1));
    EXPECT_LE(f.event, static_cast<std::int64_t>(k + 2));
  }
}

// Rejected where one of its balls is met again, or at the end: there it overlaps what it should have met.
TEST_P(TamperedLog, one_event_left_out) {
  for (std::size_t k = 0; k < log_.size(); ++k) {
    std::vector<Claim> log = log_;
    log.erase(log.begin() + static_cast<std::ptrdiff_t>(k));
    const Finding f = replay(log);
    EXPECT_EQ(f.proof, Proof::no) << k;
    EXPECT_GE(f.event, static_cast<std::int64_t>(k + 1));
  }
}

/// `decimal` + 10^-40, in as many digits.
std::string moved(const std::string& decimal) {
  const certify::Bits bits(certify::bits_of_digits(2 * digits));
  return (certify::Enclosure::near(decimal) + certify::Enclosure::near("1e-40")).lower_text(digits);
}

TEST_P(TamperedLog, one_time_moved) {
  for (std::size_t k = 0; k < log_.size(); ++k) {
    std::vector<Claim> log = log_;
    log[k].lower = log[k].upper = moved(log[k].lower);
    const Finding f = replay(log);
    EXPECT_EQ(f.proof, Proof::no) << k;
    EXPECT_EQ(f.event, static_cast<std::int64_t>(k + 1));
    EXPECT_THAT(f.what, ::testing::HasSubstr("wrong by 1e-40.0"));
  }
}

// The same event once more, and one of other balls in between.
TEST_P(TamperedLog, one_event_too_many) {
  for (std::size_t k = 0; k < log_.size(); ++k) {
    std::vector<Claim> log = log_;
    log.insert(log.begin() + static_cast<std::ptrdiff_t>(k), log_[k]);
    EXPECT_NE(replay(log).proof, Proof::yes) << k;
    EXPECT_EQ(replay(log).event, static_cast<std::int64_t>(k + 2));
    Claim other = log_[(k + 3) % log_.size()];
    other.lower = other.upper = log_[k].lower;
    log[k] = other;
    const Finding f = replay(log);
    EXPECT_NE(f.proof, Proof::yes) << k;
    EXPECT_GE(f.event, static_cast<std::int64_t>(k + 1));
    EXPECT_LE(f.event, static_cast<std::int64_t>(k + 2));
  }
}

TEST_P(TamperedLog, parties_that_are_not_there) {
  for (const auto& change : {+[](Claim& c) { c.ball = 77; }, +[](Claim& c) { c.partner = 77; }, +[](Claim& c) { c.feature = 77; c.kind = certify::MeetingKind::ball_wall; },
                             +[](Claim& c) { c.lower = "soon"; }, +[](Claim& c) { c.period[0] += 1'000'000'000'000'000'000; }}) {
    std::vector<Claim> log = log_;
    change(log[4]);
    const Finding f = replay(log);
    EXPECT_EQ(f.proof, Proof::no);
    EXPECT_EQ(f.event, 5);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, TamperedLog,
    ::testing::Values("[space]\nkind = \"box\"\nlower = [0, 0]\nupper = [6, 5]\n[[gas]]\ncount = 5\npacking_fraction = 0.3\n[run]\nuntil = 4\n",
                      photon,
                      "dimension = 1\n[space]\nkind = \"periodic\"\nlower = [-1]\nupper = [4]\n[[ball]]\nposition = [0]\nvelocity = [0.3]\nradius = 0.1\nmass = 3\n"
                      "[[ball]]\nposition = [5.5]\nvelocity = [-0.41]\nradius = 0.2\n[[ball]]\nposition = [2]\nvelocity = [0.41]\nradius = 0.2\n[run]\nuntil = 50\n"));

// A certificate is checked from its text alone.
class TamperedCertificate : public ::testing::Test {
 protected:
  void SetUp() override {
    std::ostringstream file;
    const Report r = certify::prove(disks(), {}, {[&]() -> std::ostream& { file.str(""); return file; }, {}, nullptr});
    ASSERT_EQ(r.verdict, Verdict::proven) << r.what;
    lines_ = test::split(file.str(), '\n');
    while (lines_[first_].substr(0, 2) != "1,") ++first_;
  }
  [[nodiscard]] static Report verify(const std::vector<std::string>& lines, const Scene* scene = nullptr) {
    std::string text;
    for (std::size_t k = 0; k + 1 < lines.size(); ++k) text += lines[k] + "\n";
    std::istringstream file(text);
    return certify::verify(file, {}, {}, scene);
  }
  [[nodiscard]] std::vector<std::string> with(std::size_t row, std::size_t cell, const std::string& text) const {
    std::vector<std::string> lines = lines_, cells = test::split(lines_[first_ + row], ',');
    cells[cell] = text;
    std::string& line = lines[first_ + row];
    line = cells[0];
    for (std::size_t k = 1; k < cells.size(); ++k) line += "," + cells[k];
    return lines;
  }
  [[nodiscard]] std::string cell(std::size_t row, std::size_t column) const { return test::split(lines_[first_ + row], ',')[column]; }

  std::vector<std::string> lines_;
  std::size_t first_ = 0;
};

TEST_F(TamperedCertificate, holds_as_it_was_written) {
  const Scene scene = disks();
  const Report r = verify(lines_, &scene);
  EXPECT_EQ(r.verdict, Verdict::proven) << r.what;
  EXPECT_EQ(r.tries, 1);
}

TEST_F(TamperedCertificate, a_time_outside_its_enclosure) {
  for (const std::size_t row : {0u, 7u, 20u}) {
    const Report r = verify(with(row, 7, moved(cell(row, 8))));  // lower above the upper
    EXPECT_NE(r.verdict, Verdict::proven);
    std::vector<std::string> lines = with(row, 7, moved(cell(row, 7)));
    lines[first_ + row] = lines[first_ + row].substr(0, lines[first_ + row].rfind(',') + 1) + moved(cell(row, 8));
    const Report both = verify(lines);
    EXPECT_EQ(both.verdict, Verdict::refuted);
    EXPECT_EQ(both.at_event, static_cast<std::int64_t>(row + 1));
  }
}

TEST_F(TamperedCertificate, another_partner_or_an_end_too_late) {
  const Report partner = verify(with(5, 2, "4"));
  EXPECT_EQ(partner.verdict, Verdict::refuted);
  EXPECT_EQ(partner.at_event, 6);
  std::vector<std::string> lines = lines_;
  ASSERT_EQ(lines[lines.size() - 2], "# end 6");
  lines[lines.size() - 2] = "# end 9";
  EXPECT_EQ(verify(lines).verdict, Verdict::refuted) << "more happens until 9";
  lines[lines.size() - 2] = "# end 1";
  EXPECT_EQ(verify(lines).verdict, Verdict::refuted) << "the last events are after 1";
}

TEST_F(TamperedCertificate, what_is_no_certificate_is_refused) {
  EXPECT_THROW(verify({"time,epoch", "1,2", ""}), InputError);
  EXPECT_THROW(verify(std::vector<std::string>(lines_.begin(), lines_.end() - 2)), InputError) << "cut off";
  EXPECT_THROW(verify(with(3, 0, "5")), InputError) << "a row is missing";
  EXPECT_THROW(verify(with(3, 1, "ball")), InputError);
  std::vector<std::string> lines = lines_;
  for (std::string& line : lines)
    if (line.starts_with("# restitution")) line = "# restitution 1 2";
  EXPECT_THROW(verify(lines), InputError) << "e = 2";
  Scene other = disks();
  other.collision.restitution = 0.9;
  EXPECT_THROW(verify(lines_, &other), InputError) << "of another scene";
}

}  // namespace
}  // namespace carom
