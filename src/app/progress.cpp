#include "progress.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace carom::app {

namespace {

constexpr double first_shown = 1.0;  // [s]
constexpr double shown_every = 0.2;  // [s]

std::string duration(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

Progress::Progress(std::ostream* screen, const RunSpec& run) : screen_(screen), run_(run) {}

Progress::~Progress() {
  if (shown_at_ > 0) *screen_ << "\r\x1b[K" << std::flush;
}

double Progress::seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

double Progress::fraction_done(const Simulation& simulation) const {
  double done = 0.0;
  if (run_.until && *run_.until > run_.start)
    done = std::max(done, (simulation.time() - run_.start) / (*run_.until - run_.start));
  if (run_.events && *run_.events > 0)
    done = std::max(done, static_cast<double>(simulation.counts().collisions()) / static_cast<double>(*run_.events));
  return done;
}

bool Progress::due() {
  if (screen_ == nullptr) return false;
  const double now = seconds();
  if (now < std::max(first_shown, shown_at_ + shown_every)) return false;
  shown_at_ = now;
  return true;
}

void Progress::write(const std::string& text, double done) const {
  *screen_ << "\r\x1b[K" << text;
  if (done > 0) *screen_ << fmt::format(", {} left", duration(shown_at_ * (1 - done) / done));
  *screen_ << std::flush;
}

void Progress::show(const Simulation& simulation) {
  if (!due()) return;
  const std::int64_t collisions = simulation.counts().collisions();
  write(fmt::format("{} events, time {:.6g}, {:.3g} collisions/s", collisions, simulation.time(),
                    static_cast<double>(collisions) / shown_at_),
        fraction_done(simulation));
}

void Progress::show(const std::string& what, double share) {
  if (due()) write(fmt::format("{}: {:.0f} %", what, 100 * share), share);
}

}  // namespace carom::app
