#pragma once
// The event log: one line a collision, nothing rounded that was not rounded before.

#include <cstdint>
#include <string>
#include <vector>

#include "carom/sim/simulation.hpp"
#include "carom/write/output_file.hpp"

namespace carom {

/// Columns: time, epoch, offset, kind, ball, partner, feature; position (x, y, z), image (ix, ..) and velocity after the
/// impact (vx, ..) of the ball, then of the partner (px, .., pix, .., pvx, ..; empty for a wall); impulse, tie. Components
/// beyond the scene's dimension are absent. The moment of a collision is epoch * epoch_length + offset, exactly; `time` is
/// its double.
///
/// Lines that start with # are comments; the last one says how the run ended, so a log that was cut off has none.
class EventsCsv {
 public:
  /// Throws OutputError.
  EventsCsv(std::string path, const Simulation& simulation, const std::string& title);

  void write(const Collision& collision);

  /// A write has failed: what comes after is lost, and `finish` will say why.
  [[nodiscard]] bool failed() const noexcept { return file_.failed(); }

  /// Ends the log. Throws OutputError if anything of it could not be written.
  void finish(Stop stopped_by);

 private:
  void append_digits(double x, const std::string* digits);
  void append_party(const Collision::Party& party, const CollisionDigits::Party* digits);

  OutputFile file_;
  int dimension_;
  std::vector<std::string> wall_labels_;
  std::int64_t written_ = 0;
};

}  // namespace carom
