// Reads H5MD: the first group of particles, and carom's own observables where they are there.

#include <algorithm>
#include <array>
#include <optional>

#include "carom/core/error.hpp"
#include "carom/write/frame_reader.hpp"
#include "h5.hpp"
#include "reading.hpp"

namespace carom {

namespace {

using h5::Id;

bool has(const Id& parent, const std::string& name) { return H5Lexists(parent.get(), name.c_str(), H5P_DEFAULT) > 0; }

Id group(const Id& parent, const std::string& name) { return Id(H5Gopen2(parent.get(), name.c_str(), H5P_DEFAULT)); }

/// A dataset and its shape.
struct Set {
  Id id;
  std::vector<hsize_t> shape;

  Set(const Id& parent, const std::string& name) : id(H5Dopen2(parent.get(), name.c_str(), H5P_DEFAULT)) {
    const Id space(H5Dget_space(id.get()));
    shape.resize(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space.get()))));
    if (!shape.empty()) H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr);
  }

  [[nodiscard]] hsize_t row_size() const {
    hsize_t size = 1;
    for (std::size_t k = 1; k < shape.size(); ++k) size *= shape[k];
    return size;
  }

  /// Row `row`, or all of it where there are no rows in time.
  template <class T>
  [[nodiscard]] std::vector<T> read(std::optional<hsize_t> row) const {
    const Id space(H5Dget_space(id.get()));
    hsize_t count = row ? row_size() : static_cast<hsize_t>(H5Sget_simple_extent_npoints(space.get()));
    if (row) {
      std::vector<hsize_t> from(shape.size(), 0), size = shape;
      from[0] = *row;
      size[0] = 1;
      h5::check(H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, from.data(), nullptr, size.data(), nullptr));
    }
    std::vector<T> values(count);
    const Id memory(H5Screate_simple(1, &count, nullptr));
    h5::check(H5Dread(id.get(), h5::memory_type<T>(), memory.get(), space.get(), H5P_DEFAULT, values.data()));
    return values;
  }
};

/// An element: a group with a value in time, or a dataset.
struct Element {
  std::optional<Set> set;
  bool in_time = false;

  Element() = default;
  Element(const Id& parent, const std::string& name) {
    if (!has(parent, name)) return;
    in_time = has(parent, name) && H5Oexists_by_name(parent.get(), name.c_str(), H5P_DEFAULT) > 0 && is_group(parent, name);
    set.emplace(parent, in_time ? name + "/value" : name);
  }

  explicit operator bool() const { return set.has_value(); }

  template <class T>
  [[nodiscard]] std::vector<T> at(hsize_t frame) const {
    return set->read<T>(in_time ? std::optional(frame) : std::nullopt);
  }

 private:
  static bool is_group(const Id& parent, const std::string& name) {
    const Id object(H5Oopen(parent.get(), name.c_str(), H5P_DEFAULT));
    return H5Iget_type(object.get()) == H5I_GROUP;
  }
};

std::string first_link(const Id& parent) {
  const ssize_t size = H5Lget_name_by_idx(parent.get(), ".", H5_INDEX_NAME, H5_ITER_INC, 0, nullptr, 0, H5P_DEFAULT);
  if (size < 0) throw h5::Failure{h5::last_errno()};
  std::string name(static_cast<std::size_t>(size) + 1, '\0');
  H5Lget_name_by_idx(parent.get(), ".", H5_INDEX_NAME, H5_ITER_INC, 0, name.data(), name.size(), H5P_DEFAULT);
  name.pop_back();
  return name;
}

/// Without the zeros that pad it; texts of fixed length only, as H5MD has them.
std::string text_of(hid_t type, const auto& read) {
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0) return {};
  std::string bytes(H5Tget_size(type), '\0');
  Id memory(H5Tcopy(type));
  h5::check(read(memory.get(), bytes.data()));
  return bytes.substr(0, bytes.find('\0'));
}

std::string text_attribute(const Id& object, const char* name) {
  if (H5Aexists(object.get(), name) <= 0) return {};
  const Id attribute(H5Aopen(object.get(), name, H5P_DEFAULT));
  const Id type(H5Aget_type(attribute.get())), space(H5Aget_space(attribute.get()));
  const auto count = static_cast<std::size_t>(std::max<hssize_t>(1, H5Sget_simple_extent_npoints(space.get())));
  return text_of(type.get(), [&](hid_t memory, char* to) {
    std::string all(count * H5Tget_size(memory), '\0');
    const herr_t status = H5Aread(attribute.get(), memory, all.data());
    std::copy_n(all.begin(), H5Tget_size(memory), to);
    return status;
  });
}

class H5mdFrames final : public FrameReader {
 public:
  explicit H5mdFrames(const std::string& path) : path_(path) {
    read([&] { open(); });
  }

  [[nodiscard]] const TrajectoryHead& head() const override { return head_; }
  [[nodiscard]] std::string stopped_by() const override { return stopped_by_; }

  bool next(TrajectoryFrame& frame) override {
    if (row_ >= frames_) return false;
    read([&] { fill(frame); });
    ++row_;
    return true;
  }

 private:
  template <class Work>
  void read(Work work) {
    const h5::Quiet quiet;
    try {
      work();
    } catch (const h5::Failure&) {
      throw InputError(Problem{"", 0, "cannot read \"" + path_ + "\"", "it is no H5MD file, or is damaged", "Check the name; a file that carom wrote in full does not end in .part"});
    }
  }

  void open() {
    file_ = Id(H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
    const Id particles = group(file_, "particles");
    const Id all = group(particles, first_link(particles));
    position_ = Element(all, "position");
    if (!position_ || !position_.in_time || position_.set->shape.size() != 3 || position_.set->shape[2] < 1 ||
        position_.set->shape[2] > 3)
      throw h5::Failure{};
    time_ = Element(all, "position/time");
    velocity_ = Element(all, "velocity");
    image_ = Element(all, "image");
    mass_ = Element(all, "mass");
    radius_ = Element(all, "radius");
    id_ = Element(all, "id");
    frames_ = position_.set->shape[0];
    head_.dimension = static_cast<int>(position_.set->shape[2]);
    head_.velocities = static_cast<bool>(velocity_);
    head_.radii = static_cast<bool>(radius_);
    if (has(all, "box")) read_box(group(all, "box"));
    if (has(file_, "parameters")) {
      const Id parameters = group(file_, "parameters");
      stopped_by_ = text_attribute(parameters, "stopped_by");
      if (has(parameters, "title")) {
        const Set title(parameters, "title");
        const Id type(H5Dget_type(title.id.get()));
        head_.title = text_of(type.get(), [&](hid_t memory, char* to) {
          return H5Dread(title.id.get(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, to);
        });
      }
    }
  }

  void read_box(const Id& box) {
    const bool periodic = text_attribute(box, "boundary") == "periodic";
    const Element edges(box, "edges"), lower(box, "lower"), upper(box, "upper");
    if (!edges) return;
    head_.space = periodic ? SpaceKind::periodic : SpaceKind::box;
    const std::vector<double> from = lower ? lower.at<double>(0) : std::vector<double>(3, 0.0), size = edges.at<double>(0);
    const std::vector<double> to = upper ? upper.at<double>(0) : std::vector<double>();
    if (size.size() < position_.set->shape[2] || from.size() < position_.set->shape[2]) throw h5::Failure{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(head_.dimension); ++k) {
      head_.lower[k] = from[k];
      head_.upper[k] = k < to.size() ? to[k] : from[k] + size[k];
    }
  }

  void fill(TrajectoryFrame& frame) const {
    frame = {};
    const auto dimension = static_cast<std::size_t>(head_.dimension), count = static_cast<std::size_t>(position_.set->shape[1]);
    const auto of = [&]<class T>(const Element& element, std::size_t size, T otherwise) {
      std::vector<T> values = element ? element.at<T>(row_) : std::vector<T>(size, otherwise);
      if (values.size() != size) throw h5::Failure{};
      return values;
    };
    const auto position = of(position_, count * dimension, 0.0), velocity = of(velocity_, count * dimension, 0.0);
    const auto image = of(image_, count * dimension, std::int64_t{0});
    const auto mass = of(mass_, count, 1.0), radius = of(radius_, count, 0.0);
    const auto id = of(id_, count, std::int64_t{0});
    frame.time = time_ ? time_.set->read<double>(row_).front() : static_cast<double>(row_);
    for (std::size_t i = 0; i < count; ++i) {
      if (id_ && id[i] < 0) continue;  // it has left
      BallState b;
      b.index = static_cast<std::uint32_t>(i);
      for (std::size_t k = 0; k < dimension; ++k) {
        b.position.emplace_back(position[i * dimension + k]);
        b.velocity.emplace_back(velocity[i * dimension + k]);
        b.image.push_back(image[i * dimension + k]);
      }
      b.mass = mass[i];
      b.radius = radius[i];
      frame.balls.push_back(std::move(b));
    }
  }

  std::string path_;
  Id file_;
  TrajectoryHead head_;
  Element position_, time_, velocity_, image_, mass_, radius_, id_;
  std::string stopped_by_;
  hsize_t frames_ = 0, row_ = 0;
};

}  // namespace

std::unique_ptr<FrameReader> read_h5md_frames(const std::string& path) { return std::make_unique<H5mdFrames>(path); }

}  // namespace carom
