#include "progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace carom::app {

namespace {

constexpr double first_shown = 1.0;  // [s]
constexpr double shown_every = 0.2;  // [s]
constexpr std::size_t bar_width = 20;

std::string duration(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

/// Of the terminal behind standard error.
int terminal_columns() {
  winsize size = {};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

std::string progress_line(const std::string& text, double share, double seconds, int columns) {
  std::string line;
  if (share > 0) {
    const double done = std::min(share, 1.0);
    const auto filled = static_cast<std::size_t>(done * bar_width);
    line = "[" + std::string(filled, '#') + std::string(bar_width - filled, '.') +
           fmt::format("] {:3.0f} %  {} left, ", std::floor(100 * done), duration(seconds * (1 - done) / done));
  }
  return (line + text).substr(0, static_cast<std::size_t>(std::max(1, columns - 1)));
}

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
  *screen_ << "\r\x1b[K" << progress_line(text, done, shown_at_, terminal_columns()) << std::flush;
}

void Progress::show(const Simulation& simulation) {
  if (!due()) return;
  const std::int64_t collisions = simulation.counts().collisions();
  write(fmt::format("{:.3g} collisions/s, {} events, time {:.6g}", static_cast<double>(collisions) / shown_at_, collisions,
                    simulation.time()),
        fraction_done(simulation));
}

void Progress::show(const std::string& what, double share) {
  if (due()) write(what, share);
}

}  // namespace carom::app
