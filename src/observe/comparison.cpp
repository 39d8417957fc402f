#include "carom/observe/comparison.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace carom {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double places_looked_at = 1e7;        // of balls, before the runs part
constexpr std::int64_t errors_reported = 1000;  // places in time

Triple triple(const std::vector<Number>& components) {
  Triple t{};
  std::copy_n(components.begin(), std::min<std::size_t>(3, components.size()), t.begin());
  return t;
}

double length(const Triple& t) { return std::sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]); }

Triple difference(const Triple& a, const Triple& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// Sums over the balls of finite mass.
struct Sums {
  double kinetic = 0.0, potential = 0.0, momentum_size = 0.0;
  Triple momentum{};

  void add(double mass, const Place& p, const Triple& acceleration) {
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      square += p.velocity[k] * p.velocity[k];
      momentum[k] += mass * p.velocity[k];
      potential -= mass * acceleration[k] * p.position[k];
    }
    kinetic += 0.5 * mass * square;
    momentum_size += mass * std::sqrt(square);
  }
  [[nodiscard]] double energy() const { return kinetic + potential; }
};

/// Both runs at one moment.
struct Look {
  double time = 0.0;
  Sums here, exact;
  double position_error = 0.0;  // [length]
  bool parted = false;
};

/// A mean over looks.
struct Mean {
  double sum = 0.0;
  std::int64_t count = 0;

  void add(double x) {
    sum += x;
    ++count;
  }
  [[nodiscard]] double value() const { return count > 0 ? sum / static_cast<double>(count) : nan; }
};

/// How far a quantity is off: at the last look, and on the average of the looks up to where the runs part.
class Balance {
 public:
  void note(double off, bool together) {
    last_ = off;
    if (together) together_.add(off);
  }
  [[nodiscard]] double error(bool at_the_end, double size) const {
    if (!at_the_end && together_.count < 2) return nan;  // the first look is at the start
    const double off = at_the_end ? last_ : together_.value();
    return off == 0 ? 0.0 : off / size;
  }

 private:
  double last_ = 0.0;
  Mean together_;
};

class Comparer {
 public:
  Comparer(const Course& course, const Enclosures& enclosures, Stepper& stepper, const ComparisonSettings& settings)
      : course_(course), enclosures_(enclosures), stepper_(stepper), settings_(settings), start_(stepper.time()) {
    const Subject& subject = course.subject();
    const double far = 0.01 * course.extent();
    for (std::uint32_t b = 0; b < course.balls(); ++b) {
      apart_.push_back(subject.radius[b] > 0 ? subject.radius[b] : far);
      obstacle_.push_back(!subject.moves_freely(b));
    }
    const double places =
        static_cast<double>(settings.steps) * static_cast<double>(std::max<std::uint32_t>(1, course.balls()));
    look_every_ = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(places / places_looked_at)));
    const std::int64_t apart = errors_reported * look_every_;
    report_every_ = look_every_ * ((settings.steps + apart - 1) / apart);
    result_.start = result_.averaged_from = start_;
  }

  Comparison operator()() {
    note(look());
    if (settings_.position_error) settings_.position_error(start_, 0.0);
    while (result_.steps < settings_.steps && !result_.interrupted) {
      step_to(std::min(settings_.steps, next_stop()));
      if (result_.interrupted) return std::move(result_);
      const Look now = look();
      note(now);
      report(now);
      if (settings_.slice) settings_.slice(static_cast<double>(result_.steps) / static_cast<double>(settings_.steps));
    }
    finish();
    return std::move(result_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] std::int64_t next_stop() const {
    const std::int64_t every = result_.diverged_at ? report_every_ : look_every_;
    return (result_.steps / every + 1) * every;
  }

  void step_to(std::int64_t stop) {
    const StepSink sink = [this](const StepContact& c) {
      result_.deepest_overlap = std::max(result_.deepest_overlap, c.overlap);
      if (c.impulse > 0) meetings_.push_back({c.time, c.kind, c.ball, c.partner, c.impulse});
    };
    const Clock::time_point begin = Clock::now();
    for (; result_.steps < stop; ++result_.steps) {
      if (settings_.interrupt != nullptr && settings_.interrupt->load(std::memory_order_relaxed)) {
        result_.interrupted = true;
        break;
      }
      stepper_.step(sink);
    }
    result_.seconds += std::chrono::duration<double>(Clock::now() - begin).count();
  }

  [[nodiscard]] Look look() {
    Look now;
    now.time = stepper_.time();
    states_ = stepper_.balls();
    const Subject& subject = course_.subject();
    for (const BallState& state : states_) {
      const Place here{triple(state.unwrapped_position), triple(state.velocity)};
      const Place exact = course_.at(state.index, now.time);
      const double distance = length(difference(here.position, exact.position));
      if (!(distance <= now.position_error)) now.position_error = std::isfinite(distance) ? distance : infinity;
      if (!(distance <= apart_[state.index])) now.parted = true;
      if (!subject.moves_freely(state.index)) continue;
      now.here.add(subject.mass[state.index], here, subject.acceleration);
      now.exact.add(subject.mass[state.index], exact, subject.acceleration);
    }
    return now;
  }

  void note(const Look& now) {
    if (now.parted && !result_.diverged_at) part(now);
    largest_kinetic_ = std::max(largest_kinetic_, now.exact.kinetic);
    largest_momentum_ = std::max(largest_momentum_, now.exact.momentum_size);
    kinetic_here_.add(now.here.kinetic);
    kinetic_exact_.add(now.exact.kinetic);
    const bool together = !result_.diverged_at;
    energy_.note(std::abs(now.here.energy() - now.exact.energy()), together);
    momentum_.note(length(difference(now.here.momentum, now.exact.momentum)), together);
    result_.position_error = now.position_error;
    result_.time = now.time;
  }

  void part(const Look& now) {
    result_.diverged_at = now.time;
    result_.diverged_at_collision = course_.meetings_until(now.time);
    result_.averaged_from = now.time;
    kinetic_here_ = kinetic_exact_ = {};
  }

  void report(const Look& now) const {
    const bool due = result_.steps % report_every_ == 0 || result_.steps == settings_.steps ||
                     (result_.diverged_at && *result_.diverged_at == now.time);
    if (due && settings_.position_error) settings_.position_error(now.time, now.position_error);
  }

  void finish() {
    result_.collisions = static_cast<std::int64_t>(meetings_.size());
    const double allowance = 2 * settings_.dt;
    result_.tally = match(course_.meetings(), meetings_,
                          {result_.diverged_at.value_or(result_.time), allowance + settings_.delay, allowance}, obstacle_);
    for (const BallState& state : states_)
      if (enclosures_.escaped(state.index, triple(state.position), result_.time - start_)) ++result_.escaped;
    const bool to_the_end = !result_.diverged_at;
    result_.energy_error = energy_.error(course_.keeps_energy() || to_the_end, largest_kinetic_);
    result_.momentum_error = momentum_.error(course_.keeps_momentum() || to_the_end, largest_momentum_);
    result_.here = averages(meetings_, kinetic_here_);
    result_.exact = averages(course_.meetings(), kinetic_exact_);
  }

  [[nodiscard]] Averages averages(const Meetings& meetings, const Mean& kinetic) const {
    Averages a;
    const double span = result_.time - result_.averaged_from;
    for (const Meeting& m : meetings) {
      const bool before = result_.diverged_at ? m.time <= result_.averaged_from : m.time < result_.averaged_from;
      if (before || m.time > result_.time) continue;
      a.collision_rate += 1;
      (m.kind == EventKind::ball_ball ? a.ball_impulse_rate : a.wall_impulse_rate) += m.impulse;
    }
    for (double* rate : {&a.collision_rate, &a.ball_impulse_rate, &a.wall_impulse_rate})
      *rate = span > 0 ? *rate / span : nan;
    a.kinetic_energy = kinetic.value();
    return a;
  }

  const Course& course_;
  const Enclosures& enclosures_;
  Stepper& stepper_;
  const ComparisonSettings& settings_;
  double start_;
  std::vector<double> apart_;  // [length] by ball: further off is parted
  std::vector<bool> obstacle_;
  std::int64_t look_every_ = 1, report_every_ = 1;  // [steps]
  Meetings meetings_;
  std::vector<BallState> states_;
  double largest_kinetic_ = 0.0, largest_momentum_ = 0.0;
  Balance energy_, momentum_;
  Mean kinetic_here_, kinetic_exact_;
  Comparison result_;
};

}  // namespace

Comparison compare(const Course& course, const Enclosures& enclosures, Stepper& stepper,
                   const ComparisonSettings& settings) {
  return Comparer(course, enclosures, stepper, settings)();
}

}  // namespace carom
