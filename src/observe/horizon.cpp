#include "carom/observe/horizon.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <tuple>
#include <vector>

#include "carom/observe/tangent_growth.hpp"
#include "carom/scene/rounded.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {

namespace {

double smallest_length(const Scene& scene, const Simulation& simulation) {
  double radius = std::numeric_limits<double>::infinity(), edge = radius;
  const auto take = [](double& smallest, double x) {
    if (x > 0) smallest = std::min(smallest, x);
  };
  for (const BallState& b : simulation.balls()) take(radius, b.radius);
  for (const WallSpec& w : scene.walls)
    if (w.kind == WallKind::circle || w.kind == WallKind::arc) take(radius, w.radius);
  if (std::isfinite(radius)) return radius;
  const auto side = [&edge, &take](const Coordinates& a, const Coordinates& b) {
    double square = 0;
    for (std::size_t k = 0; k < a.size() && k < b.size(); ++k) square += (b[k] - a[k]) * (b[k] - a[k]);
    take(edge, std::sqrt(square));
  };
  for (std::size_t k = 0; k < scene.space.lower.size(); ++k) take(edge, scene.space.upper[k] - scene.space.lower[k]);
  for (const WallSpec& w : scene.walls) {
    side(w.from, w.to);
    for (std::size_t i = 0; i < w.vertices.size(); ++i) side(w.vertices[i], w.vertices[(i + 1) % w.vertices.size()]);
  }
  if (std::isfinite(edge)) return edge;
  for (const BallSpec& a : scene.balls)
    for (const BallSpec& b : scene.balls) side(a.position, b.position);
  return std::isfinite(edge) ? edge : 1.0;
}

/// What a ball was in a collision.
struct Meeting {
  std::int64_t event = 0;
  Collision collision;
  bool as_partner = false;
  std::array<std::int64_t, 3> period{};  // in which the partner was met, seen from the ball's unwrapped place

  [[nodiscard]] const Collision::Party& self() const { return as_partner ? collision.partner : collision.ball; }
  [[nodiscard]] auto with() const {
    return std::tuple(collision.kind, as_partner ? collision.ball.number : collision.partner.number, collision.feature,
                      period);
  }
};

/// Pairs the k-th collision of a ball in one run with its k-th in another.
class Matching {
 public:
  explicit Matching(const Simulation& start) : edge_(start.periods()), epoch_length_(start.epoch_length()) {
    for (const BallState& b : start.balls()) radii_.push_back(b.radius);
    waiting_.resize(radii_.size());
  }

  /// A collision of run 0 or 1. Calls off(error, meeting of run 0) for each pair of meetings that this completes with the
  /// same partner, and parted(meeting of run 0) for one with another.
  template <class Off, class Parted>
  void add(int run, std::int64_t event, const Collision& c, Off&& off, Parted&& parted) {
    const std::array<std::int64_t, 3> period = period_of(c);
    meet(run, c.ball.number, Meeting{event, c, false, period}, off, parted);
    if (c.kind == EventKind::ball_ball) meet(run, c.partner.number, Meeting{event, c, true, period}, off, parted);
  }

 private:
  struct Waiting {
    int run = 0;
    std::deque<Meeting> meetings;
  };

  template <class Off, class Parted>
  void meet(int run, std::uint32_t ball, Meeting meeting, Off&& off, Parted&& parted) {
    Waiting& w = waiting_[ball];
    if (w.meetings.empty()) w.run = run;
    if (w.run == run) {
      meeting.collision.digits = nullptr;
      w.meetings.push_back(std::move(meeting));
      return;
    }
    const Meeting other = std::move(w.meetings.front());
    w.meetings.pop_front();
    const Meeting& first = run == 0 ? meeting : other;
    const Meeting& second = run == 0 ? other : meeting;
    if (first.with() != second.with()) {
      parted(first);
    } else {
      off(error(first, second), first);
    }
  }

  /// The image of the partner that was met: balls of the same number in other periods are other partners.
  [[nodiscard]] std::array<std::int64_t, 3> period_of(const Collision& c) const {
    std::array<std::int64_t, 3> period{};
    if (c.kind != EventKind::ball_ball) return period;
    const double sigma = radii_[c.ball.number] + radii_[c.partner.number];
    for (std::size_t k = 0; k < 3; ++k)
      if (edge_[k] > 0)
        period[k] = std::llround((c.ball.position[k] - sigma * c.normal[k] - c.partner.position[k]) / edge_[k]) +
                    (c.ball.image[k] - c.partner.image[k]);
    return period;
  }

  /// Distance of the ball's places in the two runs, at the time of the first.
  [[nodiscard]] double error(const Meeting& a, const Meeting& b) const {
    const double late = static_cast<double>(a.collision.epoch - b.collision.epoch) * epoch_length_ +
                        (a.collision.offset - b.collision.offset);
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double turns = static_cast<double>(b.self().image[k] - a.self().image[k]);
      const double d = (b.self().position[k] - a.self().position[k]) + (turns != 0 ? turns * edge_[k] : 0.0) +
                       late * b.self().velocity_before[k];
      square += d * d;
    }
    return std::sqrt(square);
  }

  std::vector<Waiting> waiting_;
  std::vector<double> radii_;
  std::array<double, 3> edge_;
  double epoch_length_;
};

/// One run, a collision at a time.
class Steps {
 public:
  Steps(const Scene& scene, const Precision& precision) : scene_(scene), simulation_(scene, precision) {}

  [[nodiscard]] const Simulation& simulation() const { return simulation_; }
  [[nodiscard]] std::int64_t event() const { return event_; }

  /// False at the end of the run.
  template <class Sink>
  bool next(Sink&& sink, const std::atomic<bool>* interrupt) {
    if (scene_.run.events && event_ >= *scene_.run.events) return false;
    bool met = false;
    simulation_.advance(
        scene_.run.until, 1,
        [&](const Collision& c) {
          met = true;
          ++event_;
          sink(c);
        },
        interrupt);
    return met;
  }

 private:
  const Scene& scene_;
  Simulation simulation_;
  std::int64_t event_ = 0;
};

}  // namespace

Horizon find_horizon(const Scene& scene, const HorizonOptions& options, const std::atomic<bool>* interrupt) {
  const Scene doubles = rounded_to_double(scene);
  Horizon found;
  found.digits = options.digits;
  Steps run(scene, {}), truth(doubles, Precision::decimal(options.digits));
  Steps meant(scene, Precision::decimal(options.digits));
  const Simulation& start = run.simulation();
  found.length = smallest_length(scene, start);
  Matching beside(start), input(start);
  std::optional<TangentGrowth> tangent;
  if (scene.collision.law == LawKind::restitution) tangent.emplace(scene, start);

  const auto mark = [](const Meeting& m) { return HorizonMark{m.event, m.collision.time}; };
  const auto off = [&](double error, const Meeting& m) {
    found.largest_error = std::max(found.largest_error, error);
    if (m.event == 1) found.first_error = std::max(found.first_error, error);
    if (!found.percent && error > 0.01 * found.length) found.percent = mark(m);
    if (!found.radius && error > found.length) found.radius = mark(m);
  };
  const auto parted = [&](const Meeting& m) {
    if (!found.partner) found.partner = mark(m);
  };
  bool input_parted = false;
  const auto input_off = [&](double error, const Meeting& m) {
    if (input_parted) return;
    found.input_error = std::max(found.input_error, error);
    if (!found.input && error > 0.01 * found.length) found.input = mark(m);
  };
  const auto input_gone = [&](const Meeting& m) {
    if (!found.input) found.input = mark(m);
    input_parted = true;
  };

  bool input_on = true;
  while (found.compared < options.collisions && !found.partner) {
    if (interrupt != nullptr && interrupt->load()) break;
    Collision a, b;
    const std::int64_t before_a = run.event(), before_b = truth.event();
    const bool met_a = run.next(
        [&](const Collision& c) {
          a = c;
          if (tangent) tangent->collision(c);
          beside.add(0, run.event(), c, off, parted);
        },
        interrupt);
    const bool met_b = truth.next(
        [&](const Collision& c) {
          b = c;
          beside.add(1, truth.event(), c, off, parted);
          if (input_on) input.add(0, truth.event(), c, input_off, input_gone);
        },
        interrupt);
    if (input_on && !input_parted)
      input_on = meant.next([&](const Collision& c) { input.add(1, meant.event(), c, input_off, input_gone); }, interrupt);
    if (!met_a || !met_b) {
      if (met_a != met_b && !found.partner && (interrupt == nullptr || !interrupt->load()))
        found.partner = HorizonMark{run.event() + (met_a ? 0 : 1), met_a ? a.time : b.time};
      break;
    }
    found.compared = run.event();
    const auto who = [](const Collision& c) { return std::tuple(c.kind, c.ball.number, c.partner.number, c.feature); };
    const bool singly = run.event() == before_a + 1 && truth.event() == before_b + 1;  // not several at one instant
    if (!found.order && singly && who(a) != who(b)) found.order = HorizonMark{run.event(), a.time};
  }
  if (tangent && found.compared > 0) {
    found.digits_lost = tangent->digits();
    found.digits_per_collision = *found.digits_lost / static_cast<double>(found.compared);
  }
  return found;
}

}  // namespace carom
