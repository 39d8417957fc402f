#include "step_method_rules.hpp"

#include <cmath>
#include <string>
#include <type_traits>

#include <fmt/format.h>

namespace carom {

namespace {

class Judge {
 public:
  void operator()(const DiscreteOptions& m) { solver(m.solver); }
  void operator()(const SpeculativeOptions& m) { solver(m.solver); }
  void operator()(const SweptOptions& m) {
    require(m.limit >= 1 && m.limit <= 1000000, "limit", m.limit, "it is 1..1000000");
    speed(m.threshold);
  }
  void operator()(const PenaltyOptions& m) {
    if (m.contact_time)
      require(*m.contact_time > 0 && std::isfinite(*m.contact_time), "contact_time", *m.contact_time, "it is > 0");
    require(m.steps > 0 && std::isfinite(m.steps), "steps", m.steps, "they are > 0");
  }

  std::vector<Problem> problems;

 private:
  void solver(const SolverOptions& s) {
    require(s.iterations >= 1 && s.iterations <= 1000, "iterations", s.iterations, "they are 1..1000");
    require(s.fraction >= 0 && s.fraction <= 1, "fraction", s.fraction, "it is 0..1");
    require(s.slop >= 0 && std::isfinite(s.slop), "slop", s.slop, "it is >= 0");
    speed(s.threshold);
  }
  void speed(double threshold) {
    require(threshold >= 0 && std::isfinite(threshold), "threshold", threshold, "it is >= 0");
  }
  void require(bool good, const char* key, auto value, const char* why) {
    if (!good) problems.push_back({"", 0, fmt::format("{} = {}", key, value), why, ""});
  }
};

}  // namespace

std::vector<Problem> judge_step_method(const StepMethodOptions& method) {
  Judge judge;
  std::visit(judge, method);
  return judge.problems;
}

}  // namespace carom
