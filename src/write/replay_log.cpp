#include "carom/write/replay_log.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace carom {

namespace {

static_assert(std::endian::native == std::endian::little, "chunks are little-endian");

constexpr std::uint32_t magic = 0x4c505243;  // "CRPL"
constexpr std::uint32_t with_acceleration = 1, with_size = 2;
enum Kind : std::uint8_t { two_balls, ball_and_wall, other };

template <class T>
void put(std::string& bytes, const std::vector<T>& column) {
  bytes.append(reinterpret_cast<const char*>(column.data()), column.size() * sizeof(T));
}

/// Collisions do not tell of all changes of motion.
bool needs_changes(const Scene& scene) {
  return scene.collision.law != LawKind::restitution || scene.collision.regularise == Regularise::rest ||
         scene.run.rescale_every.has_value();
}

}  // namespace

ReplayLog::ReplayLog(const Scene& scene, Simulation& simulation, ChunkSink sink)
    : sink_(std::move(sink)),
      dimension_(scene.dimension),
      epoch_length_(simulation.epoch_length()),
      acceleration_(scene.motion.acceleration.begin(), scene.motion.acceleration.end()),
      told_(needs_changes(scene)) {
  acceleration_.resize(3);
  const std::array<double, 3> periods = simulation.periods();
  period_.assign(periods.begin(), periods.end());
  const std::vector<BallState> balls = simulation.balls();
  energy_of_.resize(balls.size());
  for (const BallState& b : balls) {
    mass_.push_back(b.mass);
    radius_.push_back(b.radius);
    MotionChange m;
    m.ball = b.index;
    m.mass = b.mass;
    for (std::size_t k = 0; k < b.position.size(); ++k) {
      m.position[k] = b.position[k];
      m.image[k] = b.image[k];
      m.velocity[k] = b.velocity[k];
    }
    account(m);
  }
  initial_ = energy_;
  if (told_) simulation.watch_motion([this](const MotionChange& m) { change(m); });
}

void ReplayLog::begin_event(double time, std::int64_t epoch, double offset) {
  const bool same_instant = epoch == last_epoch_ && offset == last_offset_;
  if (same_instant && !columns_.kind.empty()) {
    columns_.energy.back() = columns_.balance.back() = std::numeric_limits<float>::quiet_NaN();
  } else if (columns_.kind.size() >= events_in_chunk) {
    flush();
  }
  const auto whole = static_cast<double>(epoch);  // may be rounded; below 2^62, so its own integer is one
  const DoubleDouble epochs{whole, static_cast<double>(epoch - static_cast<std::int64_t>(whole))};
  const double low = (epochs * epoch_length_ + offset - time).hi;  // at most half an ulp of time
  columns_.time.push_back(time);
  columns_.time_low.push_back(static_cast<float>(low));
  columns_.changes_end.push_back(static_cast<std::uint32_t>(columns_.change_ball.size()));
  columns_.energy.push_back(0);
  columns_.dissipated.push_back(0);
  columns_.balance.push_back(0);
  last_epoch_ = epoch;
  last_offset_ = offset;
  ++events_;
}

void ReplayLog::add(const Collision& c) {
  begin_event(c.time, c.epoch, c.offset);
  columns_.impulse.push_back(c.impulse);
  columns_.gap.push_back(static_cast<float>(c.gap));
  for (int k = 0; k < dimension_; ++k) columns_.normal.push_back(static_cast<float>(c.normal[static_cast<std::size_t>(k)]));
  columns_.ball.push_back(c.ball.number);
  columns_.partner.push_back(c.partner.number);
  columns_.feature.push_back(c.feature);
  columns_.kind.push_back(c.kind == EventKind::ball_ball ? two_balls : ball_and_wall);
  columns_.tie.push_back(c.tie);
  dissipated_ = dissipated_ + c.dissipated;
  injected_ = injected_ + c.injected;
  if (!told_) {
    change_of(c.ball, c);
    if (c.kind == EventKind::ball_ball) change_of(c.partner, c);
  }
  note_energy();
}

void ReplayLog::change_of(const Collision::Party& party, const Collision& c) {
  MotionChange m;
  m.ball = party.number;
  m.time = c.time;
  m.epoch = c.epoch;
  m.offset = c.offset;
  m.position = party.position;
  m.image = party.image;
  m.velocity = party.velocity_after;
  m.mass = mass_[party.number];
  m.radius = radius_[party.number];
  change(m);
}

void ReplayLog::change(const MotionChange& m) {
  if (m.epoch != last_epoch_ || m.offset != last_offset_) {
    begin_event(m.time, m.epoch, m.offset);
    columns_.impulse.push_back(0);
    columns_.gap.push_back(0);
    columns_.normal.insert(columns_.normal.end(), static_cast<std::size_t>(dimension_), 0.0F);
    columns_.ball.push_back(m.ball);
    columns_.partner.push_back(m.ball);
    columns_.feature.push_back(0);
    columns_.kind.push_back(other);
    columns_.tie.push_back(0);
  }
  columns_.change_ball.push_back(m.ball);
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k) {
    columns_.position.push_back(m.position[k]);
    columns_.velocity.push_back(m.velocity[k]);
    if (told_) columns_.acceleration.push_back(m.acceleration[k]);
  }
  if (told_) {
    columns_.radius.push_back(m.alive ? m.radius : std::numeric_limits<double>::quiet_NaN());
    columns_.mass.push_back(m.mass);
  }
  columns_.changes_end.back() = static_cast<std::uint32_t>(columns_.change_ball.size());
  account(m);
  if (told_) note_energy();
}

/// Between its changes the energy of a ball is constant.
void ReplayLog::account(const MotionChange& m) {
  DoubleDouble e;
  if (m.alive && std::isfinite(m.mass)) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k) {
      const DoubleDouble x = two_prod(static_cast<double>(m.image[k]), period_[k]) + m.position[k];
      e = e + two_prod(m.velocity[k], m.velocity[k]) * 0.5;
      e = e - x * acceleration_[k];
    }
    e = e * m.mass;
  }
  energy_ = energy_ - energy_of_[m.ball] + e;
  energy_of_[m.ball] = e;
}

void ReplayLog::note_energy() {
  columns_.energy.back() = static_cast<float>(energy_.hi);
  columns_.dissipated.back() = static_cast<float>(dissipated_.hi);
  columns_.balance.back() = static_cast<float>((energy_ + dissipated_ - initial_ - injected_).hi);
}

void ReplayLog::flush() {
  const Columns& c = columns_;
  if (c.kind.empty()) return;
  std::string bytes;
  put(bytes, std::vector<std::uint32_t>{
                 magic, static_cast<std::uint32_t>(dimension_), static_cast<std::uint32_t>(c.kind.size()),
                 static_cast<std::uint32_t>(c.change_ball.size()), told_ ? with_acceleration | with_size : 0, 0, 0, 0});
  for (const auto* column : {&c.time, &c.impulse, &c.position, &c.velocity, &c.acceleration, &c.radius, &c.mass})
    put(bytes, *column);
  for (const auto* column : {&c.time_low, &c.gap, &c.energy, &c.dissipated, &c.balance, &c.normal}) put(bytes, *column);
  for (const auto* column : {&c.ball, &c.partner}) put(bytes, *column);
  put(bytes, c.feature);
  for (const auto* column : {&c.changes_end, &c.change_ball}) put(bytes, *column);
  put(bytes, c.kind);
  put(bytes, c.tie);
  columns_ = Columns{};
  last_offset_ = -1.0;  // a change at the same instant begins an event of its own in the next chunk
  sink_(std::move(bytes));
}

}  // namespace carom
