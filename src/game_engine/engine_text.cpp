// Engines and their options as text: box2d:continuous:threshold=0.1

#include <cmath>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "carom/core/number.hpp"
#include "registry.hpp"

namespace carom {

namespace {

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t colon = 0; (colon = text.find(':')) != text.npos; text.remove_prefix(colon + 1))
    parts.push_back(text.substr(0, colon));
  parts.push_back(text);
  return parts;
}

}  // namespace

GameEngineOptions parse_game_engine(std::string_view text) {
  const std::vector<std::string_view> parts = split(text);
  GameEngineOptions options;
  options.engine = parts[0];
  const std::size_t number = game_engine::engine_number(options.engine);
  const game_engine::EngineFacts& facts = game_engine::engine_facts(number);
  const bool continuous = game_engines()[number].continuous;
  std::vector<Problem> problems;
  const auto wrong = [&](std::string_view option, std::string why) {
    problems.push_back({"", 0, fmt::format("\"{}\" in engine \"{}\"", option, text), std::move(why), ""});
  };
  for (const std::string_view option : std::vector(parts.begin() + 1, parts.end())) {
    constexpr std::string_view threshold = "threshold=";
    if (option == "continuous" && continuous) {
      options.continuous = true;
    } else if (option == "awake") {
      options.awake = true;
    } else if (option.starts_with(threshold) && facts.thresholds) {
      try {
        options.threshold = parse_number(option.substr(threshold.size()));
        if (!(*options.threshold >= 0) || std::isinf(*options.threshold))
          wrong(option, "a threshold is a speed, at least 0");
      } catch (const std::logic_error&) {
        wrong(option, "a threshold is a number");
      }
    } else {
      wrong(option, fmt::format("the options of {} are {}awake{}", facts.title, continuous ? "continuous, " : "",
                                facts.thresholds ? ", threshold=V" : ""));
    }
  }
  if (!problems.empty()) throw InputError(problems);
  return options;
}

std::string game_engine_text(const GameEngineOptions& options) {
  std::string text = options.engine;
  if (options.continuous) text += ":continuous";
  if (options.awake) text += ":awake";
  if (options.threshold) text += fmt::format(":threshold={}", *options.threshold);
  return text;
}

}  // namespace carom
