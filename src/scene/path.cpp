#include "path.hpp"

#include <algorithm>
#include <utility>

namespace carom::scene_text {

namespace {
bool is_bare(const std::string& part) {
  return !part.empty() && std::all_of(part.begin(), part.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}
}  // namespace

std::string dotted(const Path& path) {
  std::string s;
  for (const std::string& part : path) {
    if (!s.empty()) s += '.';
    s += is_bare(part) ? part : '"' + part + '"';
  }
  return s;
}

Path operator/(Path path, std::string part) {
  path.push_back(std::move(part));
  return path;
}

bool touches(const std::set<Path>& set, const Path& path) {
  for (std::size_t n = 1; n < path.size(); ++n) {
    if (set.count(Path(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(n))) > 0) return true;
  }
  // In lexicographic order, what is inside `path` follows it directly.
  const auto next = set.lower_bound(path);
  return next != set.end() && next->size() >= path.size() && std::equal(path.begin(), path.end(), next->begin());
}

}  // namespace carom::scene_text
