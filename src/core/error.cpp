#include "carom/core/error.hpp"

namespace carom {

std::string Problem::text() const {
  std::string s;
  if (!file.empty()) s += file + ":";
  if (line > 0) s += std::to_string(line) + ":";
  if (!s.empty()) s += " ";
  s += what;
  if (!why.empty()) s += " (" + why + ")";
  s += ".";
  if (!hint.empty()) s += " " + hint;
  return s;
}

namespace {
std::string joined(const std::vector<Problem>& problems) {
  std::string s;
  for (const Problem& p : problems) {
    if (!s.empty()) s += "\n";
    s += p.text();
  }
  return s;
}
}  // namespace

InputError::InputError(std::vector<Problem> problems)
    : std::runtime_error(joined(problems)), problems_(std::move(problems)) {}

}  // namespace carom
