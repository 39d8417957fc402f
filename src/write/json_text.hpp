#pragma once
// JSON as carom prints it: numbers in the shortest text that reads back the same, keys in their order, lines for people.

#include <string>

#include <nlohmann/json.hpp>

#include "carom/core/number.hpp"

namespace carom {

using Json = nlohmann::ordered_json;

/// All its digits as a string where there are more than a double has, else the double.
inline void to_json(Json& json, const Number& number) {
  if (number.text.empty()) {
    json = number.value;
  } else {
    json = number.text;
  }
}

/// A line for each key of the object and for each object in an array, ended by a newline. Non-finite numbers are null.
[[nodiscard]] std::string json_text(const Json& object);

/// The same on one line, without a newline.
[[nodiscard]] std::string json_line(const Json& object);

}  // namespace carom
