#pragma once
// HDF5's C interface with owners, and failures that are told once.

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <hdf5.h>

namespace carom::h5 {

/// While it lives HDF5 prints no errors of its own.
class Quiet {
 public:
  Quiet();
  ~Quiet();
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

/// A call of HDF5 has failed. `error` is the errno that it met, or 0.
struct Failure {
  int error = 0;
};

/// The errno in HDF5's stack of errors; 0: there is none.
[[nodiscard]] int last_errno();

/// An identifier of HDF5, closed at the end.
class Id {
 public:
  Id() = default;
  /// Throws Failure if `id` says that the call which gave it has failed.
  explicit Id(hid_t id);
  ~Id() { close(); }
  Id(Id&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
  Id& operator=(Id&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  [[nodiscard]] hid_t get() const noexcept { return id_; }
  /// Whether the identifier was let go of without an error.
  bool close() noexcept;

 private:
  hid_t id_ = -1;
};

/// Throws Failure where a call says that it has failed.
void check(herr_t status);

template <class T>
[[nodiscard]] hid_t memory_type();
template <>
[[nodiscard]] inline hid_t memory_type<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
[[nodiscard]] inline hid_t memory_type<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
[[nodiscard]] inline hid_t memory_type<std::int32_t>() {
  return H5T_NATIVE_INT32;
}

/// Of HDF5's default property list.
[[nodiscard]] Id new_group(const Id& parent, const char* name);

/// An attribute of one value, or of several.
template <class T>
void put_attribute(const Id& object, const char* name, std::span<const T> values, bool scalar = false) {
  const hsize_t size = values.size();
  const Id space(scalar ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &size, nullptr));
  const Id attribute(H5Acreate2(object.get(), name, memory_type<T>(), space.get(), H5P_DEFAULT, H5P_DEFAULT));
  check(H5Awrite(attribute.get(), memory_type<T>(), values.data()));
}
template <class T>
void put_attribute(const Id& object, const char* name, const T& value) {
  put_attribute(object, name, std::span<const T>(&value, 1), true);
}

/// Texts of fixed length, UTF-8, padded with zeros; one text is a scalar.
void put_text_attribute(const Id& object, const char* name, const std::string& text);
void put_text_attribute(const Id& object, const char* name, const std::vector<std::string>& texts);
void put_text(const Id& parent, const char* name, const std::string& text);

/// A dataset of a shape that stays.
template <class T>
void put_array(const Id& parent, const char* name, const std::vector<hsize_t>& shape, std::span<const T> values) {
  const Id space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr));
  const Id set(H5Dcreate2(parent.get(), name, memory_type<T>(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  check(H5Dwrite(set.get(), memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
}

/// A dataset that grows along its first dimension. Rows are gathered until they fill a chunk, some 16 KiB, or one row; so
/// memory does not grow with it.
template <class T>
class Series {
 public:
  /// `row` is the shape of a row. With `fill`, that is the dataset's fill value.
  Series(const Id& parent, const char* name, std::vector<hsize_t> row, const T* fill = nullptr) : row_(std::move(row)) {
    for (const hsize_t n : row_) row_size_ *= n;
    rows_in_chunk_ = std::max<hsize_t>(1, std::min<hsize_t>(512, chunk_bytes / (row_size_ * sizeof(T))));
    std::vector<hsize_t> size = whole(0), most = whole(H5S_UNLIMITED), chunk = whole(rows_in_chunk_);
    if (row_size_ * sizeof(T) > largest_chunk_bytes && row_.size() > 0)
      chunk[1] = std::max<hsize_t>(1, row_[0] * largest_chunk_bytes / (row_size_ * sizeof(T)));
    const Id space(H5Screate_simple(static_cast<int>(size.size()), size.data(), most.data()));
    const Id layout(H5Pcreate(H5P_DATASET_CREATE));
    check(H5Pset_chunk(layout.get(), static_cast<int>(chunk.size()), chunk.data()));
    if (fill != nullptr) check(H5Pset_fill_value(layout.get(), memory_type<T>(), fill));
    set_ = Id(H5Dcreate2(parent.get(), name, memory_type<T>(), space.get(), H5P_DEFAULT, layout.get(), H5P_DEFAULT));
    gathered_.reserve(rows_in_chunk_ * row_size_);
  }

  /// As many values as the row's shape has.
  void append(std::span<const T> row) {
    gathered_.insert(gathered_.end(), row.begin(), row.end());
    if (gathered_.size() >= rows_in_chunk_ * row_size_) flush();
  }
  void append(const T& value) { append(std::span<const T>(&value, 1)); }

  void flush() {
    const hsize_t rows = gathered_.size() / row_size_;
    if (rows == 0) return;
    const std::vector<hsize_t> size = whole(rows_ + rows), count = whole(rows);
    std::vector<hsize_t> offset(row_.size() + 1, 0);
    offset[0] = rows_;
    check(H5Dset_extent(set_.get(), size.data()));
    const Id in_file(H5Dget_space(set_.get()));
    check(H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, offset.data(), nullptr, count.data(), nullptr));
    const Id in_memory(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr));
    check(H5Dwrite(set_.get(), memory_type<T>(), in_memory.get(), in_file.get(), H5P_DEFAULT, gathered_.data()));
    rows_ += rows;
    gathered_.clear();
  }

 private:
  static constexpr hsize_t chunk_bytes = hsize_t{1} << 14;
  static constexpr hsize_t largest_chunk_bytes = hsize_t{1} << 20;

  [[nodiscard]] std::vector<hsize_t> whole(hsize_t rows) const {
    std::vector<hsize_t> shape{rows};
    shape.insert(shape.end(), row_.begin(), row_.end());
    return shape;
  }

  std::vector<hsize_t> row_;
  hsize_t row_size_ = 1, rows_in_chunk_ = 1, rows_ = 0;
  std::vector<T> gathered_;
  Id set_;
};

}  // namespace carom::h5
