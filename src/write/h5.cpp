#include "h5.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace carom::h5 {

Quiet::Quiet() {
  H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Quiet::~Quiet() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

int last_errno() {
  // The drivers tell it in words: "..., errno = 28, error message = ...".
  int error = 0;
  const auto look = [](unsigned, const H5E_error2_t* entry, void* to) -> herr_t {
    const char* at = entry->desc != nullptr ? std::strstr(entry->desc, "errno = ") : nullptr;
    if (at != nullptr) *static_cast<int*>(to) = std::atoi(at + std::strlen("errno = "));
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, look, &error);
  return error;
}

Id::Id(hid_t id) : id_(id) {
  if (id_ < 0) throw Failure{last_errno()};
}

bool Id::close() noexcept {
  if (id_ < 0) return true;
  return H5Idec_ref(std::exchange(id_, -1)) >= 0;
}

void check(herr_t status) {
  if (status < 0) throw Failure{last_errno()};
}

Id new_group(const Id& parent, const char* name) {
  return Id(H5Gcreate2(parent.get(), name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
}

namespace {

Id text_type(std::size_t size) {
  Id type(H5Tcopy(H5T_C_S1));
  check(H5Tset_size(type.get(), std::max<std::size_t>(1, size)));
  check(H5Tset_strpad(type.get(), H5T_STR_NULLPAD));
  check(H5Tset_cset(type.get(), H5T_CSET_UTF8));
  return type;
}

/// At least one byte to read.
const char* bytes_of(const std::string& text) { return text.c_str(); }

}  // namespace

void put_text_attribute(const Id& object, const char* name, const std::string& text) {
  const Id type = text_type(text.size());
  const Id space(H5Screate(H5S_SCALAR));
  const Id attribute(H5Acreate2(object.get(), name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT));
  check(H5Awrite(attribute.get(), type.get(), bytes_of(text)));
}

void put_text_attribute(const Id& object, const char* name, const std::vector<std::string>& texts) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  std::string padded;
  for (const std::string& text : texts) {
    padded += text;
    padded.append(longest - text.size(), '\0');
  }
  const Id type = text_type(longest);
  const hsize_t size = texts.size();
  const Id space(H5Screate_simple(1, &size, nullptr));
  const Id attribute(H5Acreate2(object.get(), name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT));
  check(H5Awrite(attribute.get(), type.get(), bytes_of(padded)));
}

void put_text(const Id& parent, const char* name, const std::string& text) {
  const Id type = text_type(text.size());
  const Id space(H5Screate(H5S_SCALAR));
  const Id set(H5Dcreate2(parent.get(), name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  check(H5Dwrite(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes_of(text)));
}

}  // namespace carom::h5
