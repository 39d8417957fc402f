// Reads the snapshots of Smallenburg's EDMD: the number of spheres, the edges of a periodic box from 0, then a line a sphere:
// a letter, its position (outside the box if it has left it) and its radius. Lines that start with # are comments.

#include "carom/write/frame_reader.hpp"
#include "reading.hpp"

namespace carom {

namespace {

class SphFrames final : public FrameReader {
 public:
  explicit SphFrames(const std::string& path) : lines_(path) {
    head_.dimension = 3;
    head_.space = SpaceKind::periodic;
    head_.velocities = false;
    begin();
  }

  [[nodiscard]] const TrajectoryHead& head() const override { return head_; }

  bool next(TrajectoryFrame& frame) override {
    if (left_ < 0) return false;
    frame = {};
    frame.time = static_cast<double>(frames_++);
    for (std::uint32_t i = 0; left_ > 0; ++i, --left_) {
      if (!line()) lines_.refuse("the frame ends early", std::to_string(left_) + " spheres are missing", "Was the file cut off?");
      frame.balls.push_back(sphere(i));
    }
    begin();
    return true;
  }

 private:
  /// A line that is no comment.
  bool line() {
    while (lines_.next(line_))
      if (!line_.starts_with('#') && !words_of(line_).empty()) return true;
    return false;
  }

  /// The two lines before the spheres of a frame, if there is one more.
  void begin() {
    left_ = -1;
    if (!line()) {
      if (frames_ == 0) lines_.refuse("there is no frame", "a snapshot begins with the number of spheres");
      return;
    }
    const auto number = words_of(line_);
    if (number.size() != 1) lines_.refuse("\"" + line_ + "\"", "a frame begins with the number of spheres alone");
    left_ = lines_.integer(number[0]);
    if (left_ < 1) lines_.refuse(std::to_string(left_) + " spheres", "a frame has one at least");
    const bool there = line();
    const auto edges = words_of(line_);
    if (!there || edges.size() != 3) lines_.refuse("\"" + line_ + "\"", "the edges of the box are three numbers");
    for (std::size_t k = 0; k < 3; ++k) {
      const double edge = lines_.number(edges[k]);
      if (!(edge > 0)) lines_.refuse("an edge of " + std::string(edges[k]), "it is above 0");
      if (frames_ > 0 && edge != head_.upper[k]) lines_.refuse("the box changes", "a trajectory has one space");
      head_.upper[k] = edge;
    }
  }

  [[nodiscard]] BallState sphere(std::uint32_t index) const {
    const auto words = words_of(line_);
    if (words.size() < 5) lines_.refuse("\"" + line_ + "\"", "a sphere is a letter, three coordinates and a radius");
    BallState b;
    b.index = index;
    for (std::size_t k = 0; k < 3; ++k) b.position.push_back(lines_.number(words[k + 1]));
    b.image.assign(3, 0);
    b.velocity.assign(3, Number(0.0));
    b.radius = lines_.number(words[4]);
    return b;
  }

  LineReader lines_;
  TrajectoryHead head_;
  std::string line_;
  std::int64_t left_ = -1, frames_ = 0;  // left_: spheres of the frame that has begun; -1: none has
};

}  // namespace

std::unique_ptr<FrameReader> read_sph_frames(const std::string& path) { return std::make_unique<SphFrames>(path); }

}  // namespace carom
