// Reads the trajectory that TrajectoryCsv writes.

#include <algorithm>
#include <array>
#include <optional>

#include "carom/write/frame_reader.hpp"
#include "reading.hpp"
#include "space_word.hpp"

namespace carom {

namespace {

/// Where the columns of a vector are; none of them: it is not in the table.
using Columns = std::vector<std::size_t>;

class CsvFrames final : public FrameReader {
 public:
  explicit CsvFrames(const std::string& path) : lines_(path) {
    while (more_ && header_.empty()) step();
    if (header_.empty()) lines_.refuse("there is no table", "the file ends before it", "Give a trajectory of carom");
    step();
  }

  [[nodiscard]] const TrajectoryHead& head() const override { return head_; }
  [[nodiscard]] std::string stopped_by() const override { return stopped_by_; }
  [[nodiscard]] bool has_end_mark() const override { return true; }

  bool next(TrajectoryFrame& frame) override {
    if (!more_) return false;
    frame = {};
    const std::string time(cells_[time_]);
    frame.time = lines_.number(time);
    // A frame ends where the time changes or the numbers of the balls begin anew.
    do {
      frame.balls.push_back(ball());
      step();
    } while (more_ && cells_[time_] == time && lines_.integer(cells_[ball_]) > frame.balls.back().index);
    return true;
  }

 private:
  /// Goes on to the next row (or the header), taking the comments on the way.
  void step() {
    while ((more_ = lines_.next(line_))) {
      if (line_.empty()) continue;
      if (line_.front() == '#') {
        comment(line_);
        continue;
      }
      cells_ = cells_of(line_);
      if (header_.empty()) {
        header();
      } else if (cells_.size() != header_.size()) {
        lines_.refuse("the row has " + std::to_string(cells_.size()) + " cells", "the header has " + std::to_string(header_.size()),
                      "Was the file cut off?");
      }
      return;
    }
  }

  void comment(std::string_view text) {
    const std::size_t colon = text.find(": ");
    if (colon == std::string_view::npos || text.size() < 2) return;
    const std::string_view key = text.substr(2, colon - 2), value = text.substr(colon + 2);
    if (key == "title") head_.title = value;
    if (key == "dimension") head_.dimension = static_cast<int>(std::clamp<std::int64_t>(lines_.integer(value), 1, 3));
    if (key == "epoch_length") head_.epoch_length = lines_.number(value.substr(value.find("= ") + 2));
    if (key == "space")
      for (const SpaceKind kind : {SpaceKind::open, SpaceKind::box, SpaceKind::periodic})
        if (value == space_word(kind)) head_.space = kind;
    if (key == "lower") corner(head_.lower, value);
    if (key == "upper") corner(head_.upper, value);
    if (key == "end") stopped_by_ = value.substr(0, value.find(','));
  }

  void corner(std::array<double, 3>& to, std::string_view text) const {
    const auto words = words_of(text);
    for (std::size_t k = 0; k < std::min<std::size_t>(3, words.size()); ++k) to[k] = lines_.number(words[k]);
  }

  void header() {
    for (const std::string_view cell : cells_) header_.emplace_back(cell);
    if (find("epoch"))
      lines_.refuse("this is a log of collisions", "it does not say where all balls are", "Give the file of output.trajectory");
    time_ = needed("time");
    ball_ = needed("ball");
    position_ = vector("");
    image_ = vector("i");
    velocity_ = vector("v");
    radius_ = find("radius");
    mass_ = find("mass");
    if (position_.empty()) lines_.refuse("there is no column x", "a trajectory says where the balls are");
    head_.velocities = !velocity_.empty();
    head_.radii = radius_.has_value();
  }

  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const {
    const auto at = std::find(header_.begin(), header_.end(), name);
    if (at == header_.end()) return std::nullopt;
    return static_cast<std::size_t>(at - header_.begin());
  }
  [[nodiscard]] std::size_t needed(std::string_view name) const {
    const auto at = find(name);
    if (!at) lines_.refuse("there is no column " + std::string(name), "a trajectory has one");
    return *at;
  }
  [[nodiscard]] Columns vector(const std::string& prefix) const {
    Columns columns;
    for (int k = 0; k < head_.dimension; ++k)
      if (const auto at = find(prefix + "xyz"[k])) columns.push_back(*at);
    if (columns.size() != static_cast<std::size_t>(head_.dimension)) columns.clear();
    return columns;
  }

  [[nodiscard]] BallState ball() const {
    BallState b;
    const std::int64_t number = lines_.integer(cells_[ball_]);
    if (number < 0 || number > 0x7fff'ffff) lines_.refuse("ball " + std::to_string(number), "balls are numbered from 0");
    b.index = static_cast<std::uint32_t>(number);
    for (const std::size_t k : position_) b.position.push_back(lines_.number(cells_[k]));
    for (const std::size_t k : image_) b.image.push_back(lines_.integer(cells_[k]));
    b.image.resize(b.position.size(), 0);
    for (const std::size_t k : velocity_) b.velocity.push_back(lines_.number(cells_[k]));
    b.velocity.resize(b.position.size());
    if (radius_) b.radius = lines_.number(cells_[*radius_]);
    if (mass_) b.mass = lines_.number(cells_[*mass_]);
    return b;
  }

  LineReader lines_;
  TrajectoryHead head_;
  std::vector<std::string> header_;
  std::size_t time_ = 0, ball_ = 0;
  Columns position_, image_, velocity_;
  std::optional<std::size_t> radius_, mass_;
  std::string line_, stopped_by_;
  std::vector<std::string_view> cells_;  // of line_
  bool more_ = true;
};

}  // namespace

std::unique_ptr<FrameReader> read_csv_frames(const std::string& path) { return std::make_unique<CsvFrames>(path); }

}  // namespace carom
