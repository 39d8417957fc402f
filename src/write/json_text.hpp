#pragma once
// JSON as carom prints it: numbers in the shortest text that reads back the same, keys in their order, lines for people.

#include <string>

#include <nlohmann/json.hpp>

namespace carom {

using Json = nlohmann::ordered_json;

/// A line for each key of the object and for each object in an array, ended by a newline. Non-finite numbers are null.
[[nodiscard]] std::string json_text(const Json& object);

}  // namespace carom
