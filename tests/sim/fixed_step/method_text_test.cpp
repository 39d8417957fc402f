// Methods as texts: read, printed back, and refused by name.

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "carom/core/error.hpp"
#include "sim/fixed_step/stepping.hpp"

namespace carom {
namespace {

using namespace testing;
using ::testing::HasSubstr;

std::string refusal(const auto& action) {
  try {
    action();
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}
std::string refusal_of(const std::string& method) {
  return refusal([&] { (void)parse_step_method(method); });
}

TEST(StepMethodText, defaults_need_no_options) {
  for (const std::string& name : step_method_names()) EXPECT_EQ(step_method_text(parse_step_method(name)), name);
  EXPECT_EQ(step_method_names(), (std::vector<std::string>{"discrete", "swept", "speculative", "penalty"}));
  EXPECT_EQ(step_method_text(parse_step_method("discrete:iterations=1:correction=full")), "discrete");
  EXPECT_EQ(step_method_text(StepMethodOptions{}), "discrete");
}

TEST(StepMethodText, options_are_printed_back_in_one_order) {
  for (const char* text :
       {"discrete:iterations=8:correction=baumgarte:fraction=0.3:slop=0", "discrete:correction=none:threshold=0.25",
        "swept:substeps", "swept:substeps:limit=7:threshold=1e-09", "speculative:iterations=3:correction=full",
        "penalty:contact_time=0.01", "penalty:steps=50"})
    EXPECT_EQ(step_method_text(parse_step_method(text)), text);
  EXPECT_EQ(step_method_text(parse_step_method("discrete:correction=baumgarte:iterations=8")),
            "discrete:iterations=8:correction=baumgarte");
  EXPECT_EQ(step_method_text(parse_step_method("penalty:contact_time=1/8")), "penalty:contact_time=0.125");
}

TEST(StepMethodText, options_reach_the_aggregate) {
  const auto d = std::get<DiscreteOptions>(parse_step_method("discrete:iterations=8:correction=baumgarte:slop=0.5"));
  EXPECT_EQ(d.solver.iterations, 8);
  EXPECT_EQ(d.solver.correction, PositionCorrection::baumgarte);
  EXPECT_EQ(d.solver.slop, 0.5);
  EXPECT_EQ(std::get<SweptOptions>(parse_step_method("swept:substeps")).sweep, Sweep::substeps);
  EXPECT_EQ(std::get<SpeculativeOptions>(parse_step_method("speculative")).solver.iterations, 8);
  EXPECT_EQ(std::get<PenaltyOptions>(parse_step_method("penalty:contact_time=0.01")).contact_time, 0.01);
}

TEST(StepMethodText, what_is_unknown_is_named_with_what_is_known) {
  EXPECT_THAT(refusal_of("verlet"), HasSubstr("\"verlet\""));
  EXPECT_THAT(refusal_of("verlet"), HasSubstr("discrete, swept, speculative, penalty"));
  EXPECT_THAT(refusal_of(""), HasSubstr("discrete, swept, speculative, penalty"));
  EXPECT_THAT(refusal_of("swept:iterations=3"), HasSubstr("\"iterations\""));
  EXPECT_THAT(refusal_of("swept:iterations=3"), HasSubstr("substeps, limit, threshold"));
  EXPECT_THAT(refusal_of("penalty:"), HasSubstr("contact_time, steps"));
}

TEST(StepMethodText, every_bad_value_is_listed) {
  const std::string all = refusal_of("discrete:iterations=0:correction=some:fraction=2:slop=x:threshold=-1:colour=red");
  for (const char* part : {"iterations", "full, baumgarte or none", "fraction", "slop", "threshold", "colour"})
    EXPECT_THAT(all, HasSubstr(part));
  for (const char* text : {"discrete:iterations", "discrete:iterations=", "discrete:iterations=2.5", "swept:substeps=2",
                           "swept:limit=0", "penalty:contact_time=0", "penalty:steps=-1", "penalty:contact_time=inf"})
    EXPECT_NE(refusal_of(text), "accepted") << text;
}

TEST(FixedStep, refuses_a_step_that_is_none) {
  const Scene scene = box({0.0}, {1.0});
  for (const double dt : {0.0, -1e-3, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THAT(refusal([&] { (void)stepper(scene, dt, "discrete"); }), HasSubstr("dt")) << dt;
}

TEST(FixedStep, refuses_options_and_laws_that_it_cannot_do) {
  Scene scene = box({0.0}, {1.0});
  EXPECT_THAT(refusal([&] { (void)stepper(scene, 0.1, "penalty:contact_time=0.2"); }), HasSubstr("2 time steps"));
  scene.collision.law = LawKind::stick;
  const FixedStepOptions wrong{-1.0, SweptOptions{Sweep::once, 0, -2.0}};
  const std::string all = refusal([&] { (void)make_stepper(scene, wrong); });
  for (const char* part : {"dt = -1", "limit = 0", "threshold = -2", "\"stick\"", "restitution only"})
    EXPECT_THAT(all, HasSubstr(part));
  scene.collision.law = LawKind::merge;
  EXPECT_THAT(refusal([&] { (void)stepper(scene, 0.1, "swept"); }), HasSubstr("\"merge\""));
}

}  // namespace
}  // namespace carom
