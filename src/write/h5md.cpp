#include "carom/write/h5md.hpp"

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "carom/write/output_file.hpp"
#include "h5.hpp"
#include "h5md_parameters.hpp"
#include "part_file.hpp"

namespace carom {

namespace {

using h5::Id;
using h5::Series;

constexpr std::int64_t departed = -1;

/// An element in time whose steps and times are those of another.
Id element_beside(const Id& parent, const char* name, const Id& first) {
  Id group = h5::new_group(parent, name);
  for (const char* shared : {"step", "time"})
    h5::check(H5Lcreate_hard(first.get(), shared, group.get(), shared, H5P_DEFAULT, H5P_DEFAULT));
  return group;
}

/// Numbers of (radius, mass), in order of appearance.
std::vector<std::int32_t> species_of(const std::vector<BallState>& balls) {
  std::map<std::pair<double, double>, std::int32_t> numbers;
  std::vector<std::int32_t> species;
  for (const BallState& ball : balls)
    species.push_back(
        numbers.try_emplace({ball.radius.value, ball.mass.value}, static_cast<std::int32_t>(numbers.size())).first->second);
  return species;
}

}  // namespace

class H5md::File {
 public:
  File(const std::string& path, const TrajectoryHead& head, const Provenance& provenance)
      : path_(path), part_(path), head_(head) {
    [[maybe_unused]] static const herr_t kept_open = H5dont_atexit();  // see abandon
    guarded([&] { begin(provenance); });
    if (error_) throw OutputError(unwritten(path_, *error_));
  }

  void write(const TrajectoryFrame& frame) {
    guarded([&] {
      if (step_ == 0) begin_frames(frame);
      append(frame);
    });
  }

  [[nodiscard]] bool failed() const noexcept { return error_.has_value(); }

  void finish(const Ending& ending) {
    guarded([&] {
      flush();
      write_ending(Id(H5Gopen2(h_->file.get(), "parameters", H5P_DEFAULT)), ending);
      h5::check(H5Fflush(h_->file.get(), H5F_SCOPE_GLOBAL));
    });
    close();
    if (!error_)
      if (const int error = part_.keep(); error != 0) error_ = error;
    if (error_) throw OutputError(unwritten(path_, *error_));
  }

  void close() {
    const h5::Quiet quiet;
    h_.reset();
  }

 private:
  /// The file, and its datasets that grow; none: not in this file.
  struct Handles {
    Id file, all;
    std::optional<Series<std::int64_t>> step, collisions, image, id;
    std::optional<Series<double>> time, position, velocity, mass, radius;
    std::optional<Series<double>> energy, dissipated, injected, imbalance, momentum;
  };

  /// After a first failure nothing is tried any more.
  template <class Work>
  void guarded(Work work) {
    if (error_) return;
    const h5::Quiet quiet;
    try {
      work();
    } catch (const h5::Failure& failure) {
      error_ = failure.error;
      abandon();
    }
  }

  /// HDF5 crashes when it closes a file that it could not write. So the file stays open until the process ends, and then
  /// too.
  void abandon() {
    static auto& abandoned = *new std::vector<std::unique_ptr<Handles>>;
    abandoned.push_back(std::move(h_));
  }

  void begin(const Provenance& provenance) {
    const Id access(H5Pcreate(H5P_FILE_ACCESS));
    h5::check(H5Pset_libver_bounds(access.get(), H5F_LIBVER_V18, H5F_LIBVER_LATEST));
    h_->file = Id(H5Fcreate(part_.path().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()));
    part_.begun();
    write_h5md_group(h_->file);
    write_parameters(h5::new_group(h_->file, "parameters"), head_, provenance);
    h_->all = h5::new_group(h5::new_group(h_->file, "particles"), "all");
    write_box();
    const Id position = h5::new_group(h_->all, "position");
    h_->step.emplace(position, "step", std::vector<hsize_t>{});
    h_->time.emplace(position, "time", std::vector<hsize_t>{});
    h_->position.emplace(position, "value", vectors());
    if (head_.velocities) h_->velocity.emplace(element_beside(h_->all, "velocity", position), "value", vectors());
    if (head_.space == SpaceKind::periodic)
      h_->image.emplace(element_beside(h_->all, "image", position), "value", vectors());
    if (head_.varying) {
      h_->id.emplace(element_beside(h_->all, "id", position), "value", scalars(), &departed);
      h_->mass.emplace(element_beside(h_->all, "mass", position), "value", scalars());
      if (head_.radii) h_->radius.emplace(element_beside(h_->all, "radius", position), "value", scalars());
    }
  }

  [[nodiscard]] std::vector<hsize_t> vectors() const { return {head_.balls, static_cast<hsize_t>(head_.dimension)}; }
  [[nodiscard]] std::vector<hsize_t> scalars() const { return {head_.balls}; }

  void write_box() {
    const Id box = h5::new_group(h_->all, "box");
    const auto dimension = static_cast<std::size_t>(head_.dimension);
    h5::put_attribute(box, "dimension", std::int64_t{head_.dimension});
    h5::put_text_attribute(
        box, "boundary", std::vector<std::string>(dimension, head_.space == SpaceKind::periodic ? "periodic" : "none"));
    if (head_.space == SpaceKind::open) return;
    std::vector<double> edges;
    for (std::size_t k = 0; k < dimension; ++k) edges.push_back(head_.upper[k] - head_.lower[k]);
    h5::put_array<double>(box, "edges", {dimension}, edges);
    h5::put_array<double>(box, "lower", {dimension}, std::span(head_.lower).first(dimension));
    h5::put_array<double>(box, "upper", {dimension}, std::span(head_.upper).first(dimension));
  }

  /// What stays as the first frame has it, and the observables, if there are any.
  void begin_frames(const TrajectoryFrame& frame) {
    if (!head_.varying && frame.balls.size() == head_.balls) {
      std::vector<double> mass, radius;
      for (const BallState& ball : frame.balls) {
        mass.push_back(ball.mass);
        radius.push_back(ball.radius);
      }
      h5::put_array<double>(h_->all, "mass", scalars(), mass);
      if (head_.radii) h5::put_array<double>(h_->all, "radius", scalars(), radius);
      h5::put_array<std::int32_t>(h_->all, "species", scalars(), species_of(frame.balls));
    }
    if (!frame.books) return;
    const Id position(H5Gopen2(h_->all.get(), "position", H5P_DEFAULT));
    const Id observables = h5::new_group(h_->file, "observables");
    const auto begin = [&](auto& series, const char* name, std::vector<hsize_t> row = {}) {
      series.emplace(element_beside(observables, name, position), "value", std::move(row));
    };
    begin(h_->collisions, "collisions");
    begin(h_->energy, "total_energy");
    begin(h_->dissipated, "dissipated_energy");
    begin(h_->injected, "injected_energy");
    begin(h_->imbalance, "energy_imbalance");
    begin(h_->momentum, "momentum", {static_cast<hsize_t>(head_.dimension)});
  }

  void append(const TrajectoryFrame& frame) {
    h_->step->append(step_++);
    h_->time->append(frame.time.value);
    append_balls(frame);
    if (!h_->energy || !frame.books) return;
    const FrameBooks& b = *frame.books;
    h_->collisions->append(b.collisions);
    h_->energy->append(b.energy);
    h_->dissipated->append(b.dissipated);
    h_->injected->append(b.injected);
    h_->imbalance->append(b.imbalance);
    h_->momentum->append(std::vector<double>(b.momentum.begin(), b.momentum.end()));
  }

  void append_balls(const TrajectoryFrame& frame) {
    const auto dimension = static_cast<std::size_t>(head_.dimension);
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> position(head_.balls * dimension, nothing), velocity = position;
    std::vector<double> mass(head_.balls, nothing), radius = mass;
    std::vector<std::int64_t> image(head_.balls * dimension, 0), id(head_.balls, departed);
    for (const BallState& ball : frame.balls) {
      const std::size_t i = ball.index;
      for (std::size_t k = 0; k < dimension; ++k) {
        position[i * dimension + k] = ball.position[k];
        velocity[i * dimension + k] = ball.velocity[k];
        image[i * dimension + k] = ball.image[k];
      }
      mass[i] = ball.mass;
      radius[i] = ball.radius;
      id[i] = ball.index;
    }
    h_->position->append(position);
    if (h_->velocity) h_->velocity->append(velocity);
    if (h_->image) h_->image->append(image);
    if (h_->id) h_->id->append(id);
    if (h_->mass) h_->mass->append(mass);
    if (h_->radius) h_->radius->append(radius);
  }

  void flush() {
    const auto all = [](auto&... series) { ((series ? series->flush() : void()), ...); };
    all(h_->step, h_->collisions, h_->image, h_->id, h_->time);
    all(h_->position, h_->velocity, h_->mass, h_->radius);
    all(h_->energy, h_->dissipated, h_->injected, h_->imbalance, h_->momentum);
  }

  std::string path_;
  PartFile part_;
  TrajectoryHead head_;
  std::unique_ptr<Handles> h_ = std::make_unique<Handles>();
  std::int64_t step_ = 0;
  std::optional<int> error_;  // errno of the first failure
};

H5md::H5md(std::string path, const TrajectoryHead& head, const Provenance& provenance)
    : file_(std::make_unique<File>(path, head, provenance)) {}

H5md::~H5md() {
  file_->close();
}

void H5md::write(const TrajectoryFrame& frame) { file_->write(frame); }
bool H5md::failed() const noexcept { return file_->failed(); }
void H5md::finish(const Ending& ending) { file_->finish(ending); }

}  // namespace carom
