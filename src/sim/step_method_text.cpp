// The text names of the fixed-step methods.

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "carom/core/number.hpp"
#include "step_method_rules.hpp"

namespace carom {

namespace {

constexpr std::array corrections{std::pair{"full", PositionCorrection::full},
                                 std::pair{"baumgarte", PositionCorrection::baumgarte},
                                 std::pair{"none", PositionCorrection::none}};

std::string text_of(PositionCorrection c) {
  return std::find_if(corrections.begin(), corrections.end(), [&](const auto& word) { return word.second == c; })->first;
}
std::string text_of(double x) { return fmt::format("{}", x); }
std::string text_of(int n) { return fmt::format("{}", n); }

// What is no such value is thrown as the rule that it breaks.
void read(std::string_view text, double& x) {
  try {
    x = parse_number(text);
  } catch (const std::logic_error&) {
    throw std::string("it is a number");
  }
}
void read(std::string_view text, int& n) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (error != std::errc() || end != text.data() + text.size()) throw std::string("it is a whole number");
}
void read(std::string_view text, PositionCorrection& c) {
  for (const auto& [word, value] : corrections)
    if (text == word) {
      c = value;
      return;
    }
  throw std::string("it is full, baumgarte or none");
}

/// Visits the options of a method: key("name", value), or flag("name", value, on) for one that is on or off.
template <class Visitor>
void visit_options(Visitor& visitor, auto& method) {
  using Method = std::remove_cvref_t<decltype(method)>;
  if constexpr (std::is_same_v<Method, SweptOptions>) {
    visitor.flag("substeps", method.sweep, Sweep::substeps);
    visitor.key("limit", method.limit);
    visitor.key("threshold", method.threshold);
  } else if constexpr (std::is_same_v<Method, PenaltyOptions>) {
    visitor.key("contact_time", method.contact_time);
    visitor.key("steps", method.steps);
  } else {
    visitor.key("iterations", method.solver.iterations);
    visitor.key("correction", method.solver.correction);
    visitor.key("fraction", method.solver.fraction);
    visitor.key("slop", method.solver.slop);
    visitor.key("threshold", method.solver.threshold);
  }
}

/// Puts one option, name or name=value, in its place.
struct Setter {
  std::string_view name;
  std::optional<std::string_view> value;
  std::vector<std::string> known{};
  bool found = false;
  std::string wrong{};

  void flag(const char* key, auto& option, auto on) {
    known.emplace_back(key);
    if (name != key) return;
    found = true;
    if (value) wrong = "it takes no value";
    option = on;
  }
  template <class T>
  void key(const char* key, std::optional<T>& option) {
    T read_value{};
    const bool before = found;
    this->key(key, read_value);
    if (found && !before) option = read_value;
  }
  template <class T>
  void key(const char* key, T& option) {
    known.emplace_back(key);
    if (name != key) return;
    found = true;
    if (!value) {
      wrong = "it needs a value";
      return;
    }
    try {
      read(*value, option);
    } catch (const std::string& rule) {
      wrong = rule;
    }
  }
};

/// All options as they are written, each with its text; "" where there is nothing to write.
struct Lister {
  std::vector<std::string> options{};

  void flag(const char* key, const auto& option, auto on) { options.push_back(option == on ? key : ""); }
  template <class T>
  void key(const char* key, const std::optional<T>& option) {
    options.push_back(option ? fmt::format("{}={}", key, text_of(*option)) : "");
  }
  template <class T>
  void key(const char* key, const T& option) {
    options.push_back(fmt::format("{}={}", key, text_of(option)));
  }
};

std::vector<std::string> list_options(const auto& method) {
  Lister lister;
  visit_options(lister, method);
  return lister.options;
}

StepMethodOptions plain_method(std::size_t number) {
  switch (number) {
    case 0:
      return DiscreteOptions{};
    case 1:
      return SweptOptions{};
    case 2:
      return SpeculativeOptions{};
    default:
      return PenaltyOptions{};
  }
}

/// What stands before the first `mark`, which is taken off `rest` with it.
std::string_view cut(std::string_view& rest, char mark) {
  const std::size_t end = std::min(rest.find(mark), rest.size());
  const std::string_view head = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return head;
}

}  // namespace

const std::vector<std::string>& step_method_names() {
  static const std::vector<std::string> names{"discrete", "swept", "speculative", "penalty"};
  return names;
}

StepMethodOptions parse_step_method(std::string_view text) {
  const auto& names = step_method_names();
  std::string_view rest = text;
  const std::string_view name = cut(rest, ':');
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InputError(Problem{"", 0, fmt::format("no fixed-step method \"{}\"", name), "",
                             fmt::format("Known: {}", fmt::join(names, ", "))});
  StepMethodOptions method = plain_method(static_cast<std::size_t>(found - names.begin()));
  std::vector<Problem> problems;
  bool more = name.size() < text.size();
  while (more) {
    more = rest.find(':') != std::string_view::npos;
    std::string_view option = cut(rest, ':');
    const bool has_value = option.find('=') != std::string_view::npos;
    Setter setter{cut(option, '='), std::nullopt};
    if (has_value) setter.value = option;
    std::visit([&](auto& m) { visit_options(setter, m); }, method);
    if (!setter.found)
      problems.push_back({"", 0, fmt::format("{} has no option \"{}\"", name, setter.name), "",
                          fmt::format("Known: {}", fmt::join(setter.known, ", "))});
    if (!setter.wrong.empty())
      problems.push_back(
          {"", 0, fmt::format("{}: {} = \"{}\"", name, setter.name, setter.value.value_or("")), setter.wrong, ""});
  }
  for (Problem& p : judge_step_method(method)) problems.push_back(std::move(p));
  if (!problems.empty()) throw InputError(std::move(problems));
  return method;
}

std::string step_method_text(const StepMethodOptions& method) {
  std::string text = step_method_names()[method.index()];
  const auto plain = std::visit([](const auto& m) { return list_options(std::remove_cvref_t<decltype(m)>{}); }, method);
  const auto options = std::visit([](const auto& m) { return list_options(m); }, method);
  for (std::size_t i = 0; i < options.size(); ++i)
    if (options[i] != plain[i] && !options[i].empty()) text += ":" + options[i];
  return text;
}

}  // namespace carom
