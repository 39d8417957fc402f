#pragma once
// Frames as H5MD 1.1 [H5MD], in HDF5, which h5py, MDAnalysis and VMD read.

#include <memory>
#include <string>

#include "carom/write/trajectory.hpp"

namespace carom {

/// particles/all: position (wrapped), velocity and, in a periodic space, image; mass, radius and species; box, whose
/// `boundary` is periodic or none, with its edges and its corners `lower` and `upper`. Row i is ball i. Where balls leave, mass and radius
/// are in time too, `id` is i or, for a ball that has left, -1 (its fill value), and there are no species: the number of a
/// ball's (radius, mass) in order of appearance.
///
/// `step` counts frames; `time` is the double nearest to the time. Every element shares the two.
///
/// observables: collisions (so far), total_energy, dissipated_energy, injected_energy, energy_imbalance, momentum.
///
/// parameters: title, scene (the text of the scene file), settings (what was set over it), stopped_by, and of a run
/// composition, precision, seed, epoch_length, and the group ledger: its books at the end.
class H5md final : public Trajectory {
 public:
  /// Throws OutputError.
  H5md(std::string path, const TrajectoryHead& head, const Provenance& provenance);
  ~H5md() override;

  [[nodiscard]] Books books() const override { return Books::kept; }
  void write(const TrajectoryFrame& frame) override;
  [[nodiscard]] bool failed() const noexcept override;
  void finish(const Ending& ending) override;

 private:
  class File;
  std::unique_ptr<File> file_;
};

}  // namespace carom
