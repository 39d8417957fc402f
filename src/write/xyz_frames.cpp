// Reads extended XYZ: the number of balls, a line of KEY=VALUE, then a line a ball.

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "carom/write/frame_reader.hpp"
#include "reading.hpp"

namespace carom {

namespace {

/// KEY=VALUE, VALUE in quotes or braces where it has blanks. A key alone is "T".
std::map<std::string, std::string> pairs_of(std::string_view line) {
  std::map<std::string, std::string> pairs;
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  for (std::size_t i = 0; i < line.size();) {
    if (blank(line[i])) {
      ++i;
      continue;
    }
    std::string key, value = "T";
    while (i < line.size() && !blank(line[i]) && line[i] != '=') key += line[i++];
    if (i < line.size() && line[i] == '=') {
      value.clear();
      const char open = ++i < line.size() ? line[i] : ' ';
      const char close = open == '"' ? '"' : open == '\'' ? '\'' : open == '{' ? '}' : '\0';
      if (close != '\0') ++i;
      while (i < line.size() && (close != '\0' ? line[i] != close : !blank(line[i]))) value += line[i++];
      if (close != '\0' && i < line.size()) ++i;
    }
    pairs[key] = value;
  }
  return pairs;
}

/// Where the columns of a property begin.
struct Layout {
  std::optional<std::size_t> position, velocity, radius, mass, id, image;
  std::size_t columns = 0;
};

class XyzFrames final : public FrameReader {
 public:
  explicit XyzFrames(const std::string& path) : lines_(path) {
    if (!begin()) lines_.refuse("there is no frame", "a frame begins with the number of balls");
  }

  [[nodiscard]] const TrajectoryHead& head() const override { return head_; }

  bool next(TrajectoryFrame& frame) override {
    if (left_ < 0) return false;
    frame = {};
    frame.time = time_ ? *time_ : Number(static_cast<double>(frames_));
    for (std::int64_t row = 0; left_ > 0; --left_, ++row) {
      std::string line;
      if (!lines_.next(line)) lines_.refuse("the frame ends early", std::to_string(left_) + " balls are missing", "Was the file cut off?");
      frame.balls.push_back(ball(line, row));
    }
    std::sort(frame.balls.begin(), frame.balls.end(),
              [](const BallState& a, const BallState& b) { return a.index < b.index; });
    for (std::size_t i = 1; i < frame.balls.size(); ++i)
      if (frame.balls[i].index == frame.balls[i - 1].index) lines_.refuse("two balls have one id", "ids tell balls apart");
    ++frames_;
    static_cast<void>(begin());
    return true;
  }

 private:
  /// The two lines before the balls of a frame; false: there is no more.
  bool begin() {
    left_ = -1;
    std::string line;
    do {
      if (!lines_.next(line)) return false;
    } while (words_of(line).empty());
    const auto words = words_of(line);
    if (words.size() != 1) lines_.refuse("\"" + line + "\"", "a frame begins with the number of balls alone");
    const std::int64_t count = lines_.integer(words[0]);
    if (count < 1 || count > 0x7fff'ffff) lines_.refuse(std::to_string(count) + " balls", "a frame has one at least");
    if (!lines_.next(line)) lines_.refuse("the frame ends early", "its second line is missing", "Was the file cut off?");
    const auto pairs = pairs_of(line);
    const auto find = [&](const char* key) -> const std::string* {
      const auto at = pairs.find(key);
      return at == pairs.end() ? nullptr : &at->second;
    };
    layout(find("Properties"));
    space(find("dimension"), find("Lattice"), find("Origin"), find("pbc"));
    time_.reset();
    for (const char* key : {"Time", "time"})
      if (const std::string* time = find(key)) time_ = lines_.number(*time);
    left_ = count;
    return true;
  }

  void layout(const std::string* properties) {
    std::string text = properties != nullptr ? *properties : "species:S:1:pos:R:3";
    std::replace(text.begin(), text.end(), ':', ' ');
    const auto parts = words_of(text);
    if (parts.size() % 3 != 0) lines_.refuse("Properties=" + text, "it is a list of name:type:columns");
    layout_ = {};
    for (std::size_t i = 0; i < parts.size(); i += 3) {
      const std::string_view name = parts[i];
      const std::int64_t width = lines_.integer(parts[i + 2]);
      if (width < 1 || width > 1000) lines_.refuse("Properties has " + std::to_string(width) + " columns", "it is 1 or more");
      const auto take = [&](std::optional<std::size_t>& to, std::int64_t needed, std::initializer_list<std::string_view> names) {
        if (width == needed && std::find(names.begin(), names.end(), name) != names.end()) to = layout_.columns;
      };
      take(layout_.position, 3, {"pos", "positions"});
      take(layout_.velocity, 3, {"velo", "vel", "velocity", "velocities"});
      take(layout_.radius, 1, {"radius", "radii"});
      take(layout_.mass, 1, {"mass", "masses"});
      take(layout_.id, 1, {"id"});
      take(layout_.image, 3, {"map_shift"});
      layout_.columns += static_cast<std::size_t>(width);
    }
    if (!layout_.position) lines_.refuse("Properties has no pos:R:3", "the balls must be somewhere");
    head_.velocities = layout_.velocity.has_value();
    head_.radii = layout_.radius.has_value();
  }

  void space(const std::string* dimension, const std::string* lattice, const std::string* origin, const std::string* pbc) {
    TrajectoryHead h = head_;
    h.dimension = dimension != nullptr ? static_cast<int>(lines_.integer(*dimension)) : 3;
    if (h.dimension < 1 || h.dimension > 3) lines_.refuse("dimension=" + *dimension, "it is 1, 2 or 3");
    h.space = SpaceKind::open;
    if (lattice != nullptr) {
      const std::vector<double> cell = numbers(*lattice, 9, "Lattice");
      const std::vector<double> from = origin != nullptr ? numbers(*origin, 3, "Origin") : std::vector<double>(3, 0.0);
      h.space = periodic(pbc, h.dimension) ? SpaceKind::periodic : SpaceKind::box;
      h.lower = h.upper = {};
      for (std::size_t k = 0; k < 9; ++k)
        if (k % 4 != 0 && cell[k] != 0.0)
          lines_.refuse("the cell is not a box along the axes", "carom's spaces are", "Cut out such a box first");
      for (std::size_t k = 0; k < static_cast<std::size_t>(h.dimension); ++k) {
        h.lower[k] = from[k];
        h.upper[k] = from[k] + cell[4 * k];
        if (!(h.lower[k] < h.upper[k])) lines_.refuse("an edge of the cell is not above 0", "the balls are within it");
      }
    }
    if (frames_ > 0 && (h.dimension != head_.dimension || h.space != head_.space || h.lower != head_.lower || h.upper != head_.upper))
      lines_.refuse("the space changes", "a trajectory has one space");
    head_ = h;
  }

  [[nodiscard]] std::vector<double> numbers(const std::string& text, std::size_t count, const char* key) const {
    std::vector<double> list;
    for (const std::string_view word : words_of(text)) list.push_back(lines_.number(word));
    if (list.size() != count) lines_.refuse(std::string(key) + " has " + std::to_string(list.size()) + " numbers", "it has " + std::to_string(count));
    return list;
  }

  /// Without pbc, a cell is periodic.
  [[nodiscard]] bool periodic(const std::string* pbc, int dimension) const {
    if (pbc == nullptr) return true;
    std::size_t repeated = 0;
    const auto flags = words_of(*pbc);
    if (flags.size() != 3) lines_.refuse("pbc=\"" + *pbc + "\"", "it has three flags, T or F");
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) repeated += flags[k] == "T" || flags[k] == "1" ? 1 : 0;
    if (repeated != 0 && repeated != static_cast<std::size_t>(dimension))
      lines_.refuse("pbc=\"" + *pbc + "\"", "a space of carom is periodic in all its dimensions or in none");
    return repeated != 0;
  }

  [[nodiscard]] BallState ball(const std::string& line, std::int64_t row) {
    const auto words = words_of(line);
    if (words.size() < layout_.columns)
      lines_.refuse("the line has " + std::to_string(words.size()) + " columns", "Properties asks for " + std::to_string(layout_.columns));
    BallState b;
    b.index = layout_.id ? rank(lines_.integer(words[*layout_.id])) : static_cast<std::uint32_t>(row);
    for (std::size_t k = 0; k < static_cast<std::size_t>(head_.dimension); ++k) {
      b.position.push_back(lines_.number(words[*layout_.position + k]));
      b.velocity.push_back(layout_.velocity ? lines_.number(words[*layout_.velocity + k]) : Number(0.0));
      b.image.push_back(layout_.image ? lines_.integer(words[*layout_.image + k]) : 0);
    }
    if (layout_.radius) b.radius = lines_.number(words[*layout_.radius]);
    if (layout_.mass) b.mass = lines_.number(words[*layout_.mass]);
    return b;
  }

  /// Balls are numbered as they appear. carom writes its own numbers in order, so those stay.
  [[nodiscard]] std::uint32_t rank(std::int64_t id) {
    return ranks_.try_emplace(id, static_cast<std::uint32_t>(ranks_.size())).first->second;
  }

  LineReader lines_;
  TrajectoryHead head_;
  Layout layout_;
  std::optional<Number> time_;
  std::map<std::int64_t, std::uint32_t> ranks_;
  std::int64_t left_ = -1, frames_ = 0;  // left_: balls of the frame that has begun; -1: none has
};

}  // namespace

std::unique_ptr<FrameReader> read_xyz_frames(const std::string& path) { return std::make_unique<XyzFrames>(path); }

}  // namespace carom
