#include "report.hpp"

#include <algorithm>
#include <utility>

#include "words.hpp"

namespace carom::scene_text {

namespace {

std::string assignment(const std::string& value) { return "value = " + value; }

}  // namespace

Report::Report(std::string_view text, std::string file, const std::vector<Override>& overrides)
    : file_(std::move(file)), overrides_(overrides) {
  documents_.emplace_back(std::string(text));
  for (const Override& o : overrides) documents_.emplace_back(assignment(o.value));
}

toml::table Report::parse_file() {
  try {
    return documents_.front().parse("0");
  } catch (const toml::parse_error& error) {
    const std::string what(error.description());
    const bool too_long = what.find("floating-point") != std::string::npos || what.find("64 bits") != std::string::npos;
    problems_.push_back({file_, static_cast<int>(error.source().begin.line), what, "not valid TOML",
                         too_long ? "A number that TOML cannot hold may stand as a string" : ""});
    return {};
  }
}

toml::table Report::parse_override(std::size_t index) {
  const std::string name = std::to_string(index + 1);
  try {
    toml::table table = documents_[index + 1].parse(name);
    if (table.size() == 1) return table;
  } catch (const toml::parse_error&) {  // then it is a string
  }
  documents_[index + 1] = Document(assignment(toml_string(overrides_[index].value)));
  try {
    return documents_[index + 1].parse(name);
  } catch (const toml::parse_error& error) {
    add_override(index, std::string(error.description()), "the value is no text");
    return {};
  }
}

std::size_t Report::document(const toml::source_region& at) const {
  return at.path ? static_cast<std::size_t>(std::stoul(*at.path)) : 0;
}

int Report::line(const toml::node& node) const {
  return document(node.source()) == 0 ? static_cast<int>(node.source().begin.line) : 0;
}

std::string Report::literal(const toml::node& number) {
  return documents_[document(number.source())].literal(number.source().begin);
}

void Report::refuse(const toml::node& at, const Path& path, std::string what, std::string why, std::string hint) {
  add(&at, std::move(what), std::move(why), std::move(hint));
  out_of_judgement(path);
}

void Report::add(const toml::node* at, std::string what, std::string why, std::string hint) {
  add(at == nullptr ? toml::source_region{} : at->source(), std::move(what), std::move(why), std::move(hint));
}

void Report::add(const toml::source_region& at, std::string what, std::string why, std::string hint) {
  if (const std::size_t d = document(at); d > 0) {
    add_override(d - 1, std::move(what), std::move(why), std::move(hint));
  } else {
    problems_.push_back({file_, static_cast<int>(at.begin.line), std::move(what), std::move(why), std::move(hint)});
  }
}

void Report::add_override(std::size_t index, std::string what, std::string why, std::string hint) {
  const Override& o = overrides_[index];
  problems_.push_back({"", 0, "--set " + o.key + "=" + o.value + ": " + what, std::move(why), std::move(hint)});
}

std::vector<Problem> Report::problems() const {
  std::vector<Problem> sorted = problems_;
  const auto place = [](const Problem& p) { return std::pair(p.file.empty() && p.line == 0, p.line); };
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Problem& a, const Problem& b) { return place(a) < place(b); });
  return sorted;
}

}  // namespace carom::scene_text
