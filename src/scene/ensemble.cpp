#include "carom/scene/ensemble.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "carom/core/error.hpp"
#include "carom/core/random.hpp"
#include "carom/core/rational.hpp"
#include "ensemble_keys.hpp"
#include "outline.hpp"
#include "words.hpp"

namespace carom {

namespace {

using scene_text::BallKey;

/// The same for the same key, whatever other keys there are: FNV-1a.
std::uint32_t use_of(std::string_view key) {
  std::uint32_t hash = 2166136261u;
  for (const char c : key) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return hash;
}

std::string number_text(double x) { return fmt::format("{}", x); }

std::string vector_text(const std::vector<double>& v) {
  std::string s = "[";
  for (const double x : v) s += (s.size() > 1 ? ", " : "") + number_text(x);
  return s + "]";
}

/// Value k of `steps`, from the exact ends and rounded once: tenths come out as they are written.
std::string step(const VarySpec& v, std::int64_t k) {
  const Rational from = exact(*v.from), to = exact(*v.to);
  return number_text(nearest_double(from + (to - from) * k / (v.steps - 1)));
}

std::string drawn(const VarySpec& v, RandomStream& draws) {
  if (!v.from) return fmt::format("{:.0f}", std::floor(draws.uniform() * 0x1p53));  // a seed
  const double u = draws.uniform();
  return number_text((1 - u) * v.from->value + u * v.to->value);
}

/// Numbers of values of the lists; 0: drawn.
std::int64_t length(const VarySpec& v) { return v.values.empty() ? v.steps : static_cast<std::int64_t>(v.values.size()); }
bool is_listed(const VarySpec& v) { return length(v) > 0; }

std::int64_t combinations_of(const EnsembleSpec& spec) {
  std::int64_t n = 1;
  for (const VarySpec& v : spec.vary)
    if (is_listed(v)) n = spec.combine == Combine::zip ? length(v) : n * length(v);
  return n;
}

/// What is drawn of a ball, once the scene is known; none: the key is drawn from a range, or listed.
std::optional<BallKey> placed(const VarySpec& v) {
  return is_listed(v) || v.from ? std::nullopt : scene_text::ball_key(v.key);
}

Coordinates numbers(const std::vector<double>& v) {
  Coordinates c;
  for (const double x : v) c.push_back(parse_number(number_text(x)));
  return c;
}

/// Uniform on the directions: of a point in the unit disk, its angle doubled (2-D); [Marsaglia1972] (3-D).
std::vector<double> direction(int dimension, RandomStream& draws) {
  if (dimension == 1) return {draws.uniform() < 0.5 ? -1.0 : 1.0};
  double a = 0, b = 0, s = 0;
  do {
    a = 2 * draws.uniform() - 1;
    b = 2 * draws.uniform() - 1;
    s = a * a + b * b;
  } while (s >= 1 || s == 0);
  if (dimension == 2) return {(a * a - b * b) / s, 2 * a * b / s};
  const double root = 2 * std::sqrt(1 - s);
  return {a * root, b * root, 1 - 2 * s};
}

[[noreturn]] void refuse(const VarySpec& v, std::string why, std::string hint = {}) {
  throw InputError(Problem{"", 0, "vary " + v.key, std::move(why), std::move(hint)});
}

/// Draws the place and the direction of a ball of the scene.
class Placing {
 public:
  Placing(const VarySpec& vary, BallKey key, Ensemble::Member& member) : vary_(vary), key_(key), member_(member) {
    if (key_.ball >= member.scene.balls.size())
      refuse(vary_, fmt::format("the scene has {} [[ball]]s, numbered from 0", member.scene.balls.size()));
  }

  void direction_at_its_speed(RandomStream& draws) {
    BallSpec& ball = member_.scene.balls[key_.ball];
    double square = 0;
    for (const Number& v : ball.velocity) square += v.value * v.value;
    if (!(square > 0)) refuse(vary_, "the ball is at rest, and a direction is drawn at its speed", "Give it a velocity");
    std::vector<double> v = direction(member_.scene.dimension, draws);
    for (double& x : v) x *= std::sqrt(square);
    ball.velocity = numbers(v);
    put("velocity", v);
  }

  void place(RandomStream& draws) {
    const std::optional<scene_text::Outline> outline = scene_text::Outline::of(member_.scene);
    if (!outline)
      refuse(vary_, "an open space without walls around it has no places to draw from", fmt::format("Draw from ranges: --vary {0}.0=FROM:TO --vary {0}.1=FROM:TO", vary_.key));
    constexpr int tries = 100'000;
    std::vector<double> x(outline->lower.size());
    for (int k = 0; k < tries; ++k) {
      for (std::size_t c = 0; c < x.size(); ++c) {
        const double u = draws.uniform();
        x[c] = (1 - u) * outline->lower[c] + u * outline->upper[c];
      }
      if (!outline->holds(x)) continue;
      member_.scene.balls[key_.ball].position = numbers(x);
      return put("position", x);
    }
    refuse(vary_, fmt::format("none of {} places drawn is within the walls", tries), "Are they closed?");
  }

 private:
  void put(const char* what, const std::vector<double>& v) {
    member_.set.push_back({fmt::format("ball.{}.{}", key_.ball, what), vector_text(v)});
  }

  const VarySpec& vary_;
  BallKey key_;
  Ensemble::Member& member_;
};

std::uint64_t stream_of(std::int64_t run, std::int64_t attempt) {
  return static_cast<std::uint64_t>(run) | static_cast<std::uint64_t>(attempt) << 40;
}

}  // namespace

Ensemble::Ensemble(SceneSource source, EnsembleSpec spec) : source_(std::move(source)), spec_(std::move(spec)) {
  if (spec_.vary.empty() && spec_.count.value_or(1) == 1)
    throw InputError(Problem{source_.file, 0, "the scene has nothing to vary", "the runs of a sweep differ in a key, or are many",
                             "Add --vary KEY=FROM:TO:STEPS, or [ensemble]"});
  combinations_ = combinations_of(spec_);
}

bool Ensemble::places() const {
  return std::any_of(spec_.vary.begin(), spec_.vary.end(), [](const VarySpec& v) {
    const std::optional<BallKey> key = placed(v);
    return key && key->what != BallKey::What::velocity;
  });
}

std::vector<Override> Ensemble::listed(std::int64_t combination) const {
  std::vector<Override> set;
  std::int64_t left = combination;
  for (auto v = spec_.vary.rbegin(); v != spec_.vary.rend(); ++v) {
    if (!is_listed(*v)) continue;
    const std::int64_t k = spec_.combine == Combine::zip ? combination : left % length(*v);
    left /= length(*v);
    set.push_back({v->key, v->values.empty() ? step(*v, k) : v->values[static_cast<std::size_t>(k)]});
  }
  std::reverse(set.begin(), set.end());
  return set;
}

Ensemble::Member Ensemble::member(std::int64_t run, std::int64_t attempt) const {
  Member m;
  m.set = listed(run % combinations_);
  const auto draws_for = [&](const VarySpec& v) { return RandomStream(spec_.seed, stream_of(run, attempt), use_of(v.key)); };
  for (const VarySpec& v : spec_.vary) {
    if (is_listed(v) || placed(v)) continue;
    RandomStream draws = draws_for(v);
    m.set.push_back({v.key, drawn(v, draws)});
  }
  std::vector<Override> all = source_.set;
  all.insert(all.end(), m.set.begin(), m.set.end());
  m.scene = read_scene(source_.text, source_.file, all);
  for (const VarySpec& v : spec_.vary) {
    const std::optional<BallKey> key = placed(v);
    if (!key) continue;
    Placing placing(v, *key, m);
    RandomStream draws = draws_for(v);
    if (key->what != BallKey::What::velocity) placing.place(draws);
    if (key->what != BallKey::What::position) placing.direction_at_its_speed(draws);
  }
  return m;
}

std::vector<std::string> ensemble_explained(const Scene& scene) {
  if (!scene.ensemble) return {};
  const EnsembleSpec& spec = *scene.ensemble;
  std::vector<std::string> keys;
  for (const VarySpec& v : spec.vary) {
    const auto range = [&v] { return fmt::format("from {} to {}", number_text(v.from->value), number_text(v.to->value)); };
    keys.push_back(v.key + ": " + (!v.values.empty() ? fmt::format("{}", fmt::join(v.values, ", "))
                                   : v.steps > 0     ? fmt::format("{} equal steps {}", v.steps, range())
                                   : v.from          ? "drawn " + range() + ", each value alike"
                                                     : "drawn, as the key suggests"));
  }
  std::vector<std::string> said{fmt::format("{} runs by carom sweep, the same for the seed {} whatever the threads; carom run takes "
                                            "the scene as it is written, once",
                                            combinations_of(spec) * spec.count.value_or(1), spec.seed)};
  said.insert(said.end(), keys.begin(), keys.end());
  return said;
}

}  // namespace carom
