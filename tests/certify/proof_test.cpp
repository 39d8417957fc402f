// Proofs of scenes whose truth is known: from closed forms, and from runs in many more digits.

#include <sstream>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "carom/core/error.hpp"
#include "carom/core/multi.hpp"
#include "carom/core/rational.hpp"
#include "certify/scenes.hpp"

namespace carom {
namespace {

using namespace testing;
using certify::Bounds;
using certify::Report;
using certify::Verdict;
using ::testing::HasSubstr;

Rational number(const std::string& text) { return exact(parse_number(text)); }
bool holds(const Bounds& b, const Rational& x) { return number(b.lower) <= x && x <= number(b.upper); }

Report proven(const Scene& scene, int digits = 50) {
  const Report r = certify::prove(scene, {digits, 12'800});
  EXPECT_EQ(r.verdict, Verdict::proven) << "event " << r.at_event << ": " << r.what;
  return r;
}

/// The places at the end, in ten times the digits, lie within the bounds.
void expect_bounds_to_hold(const Scene& scene, const Report& report) {
  Simulation simulation(scene, Precision::decimal(10 * report.digits));
  simulation.run();
  EXPECT_EQ(simulation.counts().collisions(), report.events);
  ASSERT_EQ(report.final.size(), simulation.balls().size());
  for (const certify::BallBounds& b : report.final) {
    const BallState ball = simulation.ball(b.index);
    for (std::size_t k = 0; k < b.position.size(); ++k) {
      EXPECT_TRUE(holds(b.position[k], exact(ball.unwrapped_position[k]))) << "ball " << b.index;
      EXPECT_TRUE(holds(b.velocity[k], exact(ball.velocity[k]))) << "ball " << b.index;
    }
  }
}

// The distance from the origin at t = 10 is 0.995262919443354160890311809426721621029466922734154349803...
TEST(Prove, photon_of_the_hundred_digit_challenge) {
  const Report r = proven(scene_of(photon), 130);
  EXPECT_EQ(r.events, 14);
  EXPECT_EQ(r.tries, 1);
  EXPECT_GE(r.state_digits, 100.0);
  ASSERT_EQ(r.final.size(), 2u);
  const auto square = [&](const std::string Bounds::*end) {
    Rational sum = 0;
    for (const Bounds& b : r.final[0].position) sum += number(b.*end) * number(b.*end);
    return sum;
  };
  // Both coordinates are negative, so the lower ends are farther from the origin.
  const Rational below = number("0.99526291944335416089031180942672162102946692273415434980"), ulp = number("1e-56");
  EXPECT_LT(square(&Bounds::upper), (below + ulp) * (below + ulp));
  EXPECT_GT(square(&Bounds::lower), below * below);
}

// At a mass ratio of 100^n there are floor(10^n pi) collisions, and the last velocities are
//   u = -cos 2 k theta,   |v| = 10^n |sin 2 k theta|,   theta = arctan 10^-n,   k = ceil(count / 2)   [Galperin2003].
TEST(Prove, galperin_counts_the_digits_of_pi) {
  const PrecisionScope<Multi> scope(80);
  const auto holds_real = [](const Bounds& b, const Multi& x) { return Multi(b.lower) <= x && x <= Multi(b.upper); };
  for (const auto& [ratio, n, count] : {std::tuple("100", 1, 31), {"1e6", 3, 3141}, {"1e8", 4, 31415}}) {
    const Report r = proven(scene_of(galperin(ratio)));
    EXPECT_EQ(r.events, count);
    EXPECT_EQ(r.stopped_by, "no_events_left");
    EXPECT_GE(r.state_digits, 40.0) << "on a line the impact is linear: nothing is lost but rounding";
    const Multi root = pow(Multi(10), n), angle = 2 * ((count + 1) / 2) * atan(1 / root);
    EXPECT_TRUE(holds_real(r.final[1].velocity[0], -cos(angle))) << ratio;
    EXPECT_TRUE(holds_real(r.final[0].velocity[0], root * abs(sin(angle)))) << ratio;
  }
}

TEST(Prove, bounds_hold_the_truth) {
  const std::string disks = "dimension = 2\n[space]\nkind = \"box\"\nlower = [0, 0]\nupper = [6, 5]\n[[gas]]\ncount = 5\npacking_fraction = 0.3\n[run]\nevents = 60\n";
  const std::string spheres = "dimension = 3\n[space]\nkind = \"periodic\"\nlower = [0, 0, 0]\nupper = [2, 3, 2.5]\n[[gas]]\ncount = 6\nradius = 0.3\n[run]\nevents = 40\n";
  const std::string circle = "[[wall]]\nkind = \"circle\"\ncentre = [0, 0]\nradius = 1\n[[ball]]\nposition = [0.2, -0.1]\nvelocity = [0.8, 0.6]\nradius = 0.1\n"
                             "[[ball]]\nposition = [-0.3, 0.4]\nvelocity = [0.1, 0.6]\nradius = 0.2\nmass = 3\n[run]\nevents = 30\n";
  const std::string ring = "dimension = 1\n[space]\nkind = \"periodic\"\nlower = [-1]\nupper = [4]\n[[ball]]\nposition = [0]\nvelocity = [0.3]\nradius = 0.1\nmass = 3\n"
                           "[[ball]]\nposition = [5.5]\nvelocity = [-0.41]\nradius = 0.2\n[run]\nevents = 40\n";
  for (const std::string& text : {disks, spheres, circle, ring, std::string(everything), std::string(photon)}) {
    const Scene scene = scene_of(text);
    const Report report = proven(scene);
    EXPECT_GT(report.events, 10);
    expect_bounds_to_hold(scene, report);
  }
}

// Off centre, a plastic impact leaves the balls sliding off each other: the gap has a double zero.
TEST(Prove, plastic_impact_in_the_plane) {
  const Report r = proven(scene_of("[collision]\nrestitution = 0\n[[ball]]\nposition = [-5, 1]\nvelocity = [1, 0]\nradius = 1\n[[ball]]\nposition = [0, 0]\nradius = 1\n[run]\nuntil = 9\n"));
  EXPECT_EQ(r.events, 1);
}

// Two pairs that meet at the same moment, and one fixed ball that is hit from both sides: no order is needed.
TEST(Prove, simultaneous_events_that_share_no_moving_ball) {
  const Report r = proven(scene_of("[[ball]]\nposition = [-3, 0]\nvelocity = [1, 0]\n[[ball]]\nposition = [0, 0.55]\n"
                                   "[[ball]]\nposition = [-3, 10]\nvelocity = [1, 0]\n[[ball]]\nposition = [0, 10.55]\n"
                                   "[[ball]]\nposition = [0, 20]\nfixed = true\n[[ball]]\nposition = [-2.5, 20.2]\nvelocity = [1, 0]\n"
                                   "[[ball]]\nposition = [2.5, 20.2]\nvelocity = [-1, 0]\n[run]\nuntil = 10\n"));
  EXPECT_EQ(r.events, 4);
}

// One ball meets two at one moment, by symmetry: no number of digits will tell which comes first.
TEST(Prove, recognises_a_true_tie) {
  const Report pair = certify::prove(scene_of("[[ball]]\nposition = [-3, 0]\nvelocity = [1, 0]\n[[ball]]\nposition = [0, 0.55]\n"
                                              "[[ball]]\nposition = [0, -0.55]\n[run]\nuntil = 10\n"), {});
  EXPECT_EQ(pair.verdict, Verdict::undecided);
  EXPECT_TRUE(pair.tie);
  EXPECT_EQ(pair.tries, 1);
  EXPECT_EQ(pair.events, 0);
  // A ball runs into a corner: the two polynomials differ, their roots are both 1.
  const Report corner = certify::prove(scene_of("[space]\nkind = \"box\"\nlower = [0, 0]\nupper = [4, 4]\n[[ball]]\nposition = [1.5, 2.5]\nvelocity = [-1, -2]\n"
                                                "[run]\nuntil = 10\n"), {});
  EXPECT_TRUE(corner.tie);
  EXPECT_THAT(corner.what, HasSubstr("wall"));
}

// A disk passes another one at a distance of exactly 0: neither a contact nor none can be proven.
TEST(Prove, leaves_a_graze_undecided) {
  const Report r = certify::prove(scene_of("[[ball]]\nposition = [-3, 1]\nvelocity = [1, 0]\n[[ball]]\nposition = [0, 0]\n[run]\nuntil = 10\n"), {50, 100});
  EXPECT_EQ(r.verdict, Verdict::undecided);
  EXPECT_EQ(r.digits, 100);
  EXPECT_FALSE(r.tie);
  // By 1e-60 it misses, or does not: 100 digits tell.
  for (const char* y : {"1.000000000000000000000000000000000000000000000000000000000001", "0.999999999999999999999999999999999999999999999999999999999999"}) {
    const Report near = certify::prove(scene_of("[[ball]]\nposition = [-3, " + std::string(y) + "]\nvelocity = [1, 0]\n[[ball]]\nposition = [0, 0]\n[run]\nuntil = 10\n"), {50, 400});
    EXPECT_EQ(near.verdict, Verdict::proven) << near.what;
    EXPECT_EQ(near.events, y[0] == '1' ? 0 : 1);
    EXPECT_GE(near.digits, 100);
  }
}

// More digits are taken until they suffice, and not more than allowed.
TEST(Prove, doubles_its_digits) {
  Scene scene = scene_of("[space]\nkind = \"periodic\"\nlower = [0, 0]\nupper = [1, 1]\n[[ball]]\nposition = [0.1, 0.05]\nvelocity = [0.6, 0.8]\nradius = 0\n"
                         "[[ball]]\nposition = [0.5, 0.5]\nradius = 0.35\nfixed = true\n[run]\nevents = 60\n");
  const Report enough = proven(scene, 20);
  EXPECT_EQ(enough.digits, 80);
  EXPECT_EQ(enough.tries, 3);
  std::ostringstream certificate;
  const Report stopped = certify::prove(scene, {20, 40}, {[&]() -> std::ostream& { certificate.str(""); return certificate; }, {}, nullptr});
  EXPECT_EQ(stopped.verdict, Verdict::undecided);
  EXPECT_GT(stopped.events, 5);
  EXPECT_LT(stopped.events, 60);
  // What is proven until then is a certificate of its own.
  std::istringstream file(certificate.str());
  const Report verified = certify::verify(file, {});
  EXPECT_EQ(verified.verdict, Verdict::proven) << verified.what;
  EXPECT_EQ(verified.events, stopped.events);
}

TEST(Prove, refuses_by_name) {
  const auto refusal = [](const std::string& toml) -> std::string {
    try {
      static_cast<void>(certify::prove(scene_of(toml), {}));
    } catch (const InputError& error) {
      return error.problems().front().text();
    }
    return "";
  };
  const std::string balls = "[[ball]]\nposition = [0, 0]\n[[ball]]\nposition = [3, 0]\n[run]\nuntil = 1\n";
  EXPECT_THAT(refusal("[collision]\nlaw = \"stick\"\n" + balls), HasSubstr("joins balls"));
  EXPECT_THAT(refusal("[collision]\ncontact_time = 0.1\n" + balls), HasSubstr("contact_time"));
  EXPECT_THAT(refusal("[motion]\nacceleration = [0, -1]\n[collision]\nregularise = \"rest\"\n" + balls), HasSubstr("regularise"));
  EXPECT_THAT(refusal("dimension = 1\n[collision]\nrestitution = 0\n[[ball]]\nposition = [0]\n[[ball]]\nposition = [3]\n[run]\nuntil = 1\n"), HasSubstr("restitution 0 on a line"));
  EXPECT_THAT(refusal("[[wall]]\nkind = \"plane\"\npoint = [0, -5]\nnormal = [0, 1]\nrestitution = 0\n" + balls), HasSubstr("restitution 0 at wall 0"));
  EXPECT_THAT(refusal("[[wall]]\nkind = \"ellipse\"\ncentre = [0, 0]\naxes = [50, 40]\n" + balls), HasSubstr("curved"));
  EXPECT_THAT(refusal("[[ball]]\nposition = [1, 0]\n" + balls), HasSubstr("ball 0 and ball 1 start in contact"));
  EXPECT_THAT(refusal("[[wall]]\nkind = \"plane\"\npoint = [0, -0.5]\nnormal = [0, 1]\n" + balls), HasSubstr("ball 0 starts in contact with wall 0"));
}

}  // namespace
}  // namespace carom
