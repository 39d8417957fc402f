#include "run_to_the_end.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

#include "sample_times.hpp"

namespace carom::app {

namespace {

/// A number of collisions that takes about a tenth of a second.
class Slice {
 public:
  [[nodiscard]] std::int64_t collisions() const { return collisions_; }

  void learn(double seconds) {
    if (seconds < 0.05 && collisions_ < largest) collisions_ *= 2;
    if (seconds > 0.2 && collisions_ > 1) collisions_ /= 2;
  }

 private:
  static constexpr std::int64_t largest = std::int64_t{1} << 40;
  std::int64_t collisions_ = 256;
};

class Runner {
 public:
  Runner(Simulation& simulation, const RunSpec& run, const Watchers& watchers)
      : simulation_(simulation), run_(run), watchers_(watchers), samples_(run) {
    samples_.skip_to(simulation.time());  // it may have run before
  }

  Stop operator()() {
    frame();
    while (true) {
      const std::optional<Number> sample = watchers_.frame && !every_event() ? samples_.next() : std::nullopt;
      const std::optional<Appointment> look = next_look();
      const bool looks_first = look && look->time && (!sample || look->time->value < sample->value);
      const std::optional<Number> target = looks_first ? look->time : sample;
      const Stop stop = advance(target ? target : run_.until, look ? look->events : std::nullopt);
      const bool at_target = target && (stop == Stop::until || (stop == Stop::no_events_left && run_.until));
      const bool at_look = look && look->events && simulation_.counts().collisions() >= *look->events;
      if (at_look || (at_target && looks_first)) watchers_.samplers->look(simulation_);
      if (every_event() && simulation_.counts().collisions() > framed_) frame();
      if (at_target && !looks_first) {
        frame();
        samples_.advance();
      } else if (!at_target && (stop != Stop::events || left() == 0)) {
        return end(stop, target.has_value());
      }
    }
  }

 private:
  /// None: nothing more before the end.
  [[nodiscard]] std::optional<Appointment> next_look() const {
    if (watchers_.samplers == nullptr) return std::nullopt;
    std::optional<Appointment> look = watchers_.samplers->next();
    if (look && look->time && run_.until && look->time->value > run_.until->value) return std::nullopt;
    return look;
  }

  Stop advance(const std::optional<Number>& to, const std::optional<std::int64_t>& look) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    std::int64_t most = std::min(left(), every_event() ? 1 : slice_.collisions());
    if (look) most = std::min(most, std::max<std::int64_t>(*look - simulation_.counts().collisions(), 0));
    const Stop stop = simulation_.advance(to, most, watchers_.collision, watchers_.interrupt);
    if (stop == Stop::events) slice_.learn(std::chrono::duration<double>(Clock::now() - begin).count());
    if (watchers_.slice) watchers_.slice();
    return stop;
  }

  [[nodiscard]] bool every_event() const { return watchers_.frame && watchers_.frames_at == FramesAt::events; }

  [[nodiscard]] std::int64_t left() const {
    return run_.events ? *run_.events - simulation_.counts().collisions() : std::numeric_limits<std::int64_t>::max();
  }

  Stop end(Stop stop, bool before_a_sample) {
    if (stop == Stop::no_events_left && before_a_sample) simulation_.return_to_last_event();
    if (simulation_.time() > last_frame_) frame();
    return stop;
  }

  void frame() {
    if (!watchers_.frame) return;
    watchers_.frame();
    last_frame_ = simulation_.time();
    framed_ = simulation_.counts().collisions();
  }

  Simulation& simulation_;
  const RunSpec& run_;
  const Watchers& watchers_;
  SampleTimes samples_;
  Slice slice_;
  double last_frame_ = -std::numeric_limits<double>::infinity();
  std::int64_t framed_ = 0;  // collisions up to the last frame
};

}  // namespace

Stop run_to_the_end(Simulation& simulation, const RunSpec& run, const Watchers& watchers) {
  return Runner(simulation, run, watchers)();
}

}  // namespace carom::app
