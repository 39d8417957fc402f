// check_example PROGRAM FOLDER OUT: runs FOLDER/scene.toml as FOLDER/expected.json says, and compares.
//
// expected.json holds {"runs": [{"command": "run", "arguments": [..], "status": 0, "values": {POINTER: EXPECTED, ..}}, ..]}.
// A POINTER (RFC 6901) names a value of what `carom run --json --final`, or another command with --json, prints; EXPECTED is
// a value (equal to the last bit), [value, tolerance], or {"at_least": .., "at_most": ..}. A run of status 2 must print
// nothing on stdout.

#include <sys/wait.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

namespace {

using nlohmann::json;

struct Finished {
  int status = -1;
  std::string output;
};

std::string quoted(const std::string& argument) {
  std::string s = "'";
  for (const char c : argument) s += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return s + "'";
}

Finished run(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot start " + command);
  Finished finished;
  std::array<char, 4096> part;
  while (const std::size_t n = std::fread(part.data(), 1, part.size(), pipe)) finished.output.append(part.data(), n);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) finished.status = WEXITSTATUS(status);
  return finished;
}

bool agrees(const json& found, const json& expected) {
  if (expected.is_array())
    return found.is_number() && std::abs(found.get<double>() - expected[0].get<double>()) <= expected[1].get<double>();
  if (expected.is_object())
    return found.is_number() && (!expected.contains("at_most") || found.get<double>() <= expected["at_most"]) &&
           (!expected.contains("at_least") || found.get<double>() >= expected["at_least"]);
  return found == expected;
}

int differences(const std::string& program, const std::string& folder, const std::string& out, const json& wanted) {
  const std::string name = wanted.value("command", "run");
  std::string command = quoted(program) + ' ' + name + ' ' + quoted(folder + "/scene.toml") + " --json";
  if (name == "run") command += " --final --out " + quoted(out);
  for (const json& argument : wanted.value("arguments", json::array())) command += ' ' + quoted(argument);
  const Finished finished = run(command);
  int count = 0;
  const auto differ = [&](const std::string& what) {
    if (count++ == 0) std::cout << command << '\n';
    std::cout << "  " << what << '\n';
  };

  const int status = wanted.value("status", 0);
  if (finished.status != status)
    differ("exit status " + std::to_string(finished.status) + ", expected " + std::to_string(status));
  if (status == 2) {
    if (!finished.output.empty()) differ("a refused scene printed a result");
    return count;
  }
  const json summary = json::parse(finished.output, nullptr, false);
  if (summary.is_discarded()) {
    differ("stdout is no JSON: " + finished.output);
    return count;
  }
  for (const auto& [pointer, expected] : wanted.at("values").items()) {
    const json::json_pointer place(pointer);
    if (!summary.contains(place)) {
      differ(pointer + " is missing");
    } else if (!agrees(summary.at(place), expected)) {
      differ(pointer + " is " + summary.at(place).dump() + ", expected " + expected.dump());
    }
  }
  return count;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 4) throw std::runtime_error("usage: check_example PROGRAM FOLDER OUT");
  const std::string folder = argv[2];
  std::ifstream file(folder + "/expected.json");
  if (!file) throw std::runtime_error(folder + " has no expected.json: an example says what to expect");
  const json expected = json::parse(file);
  if (expected.at("runs").empty()) throw std::runtime_error(folder + "/expected.json lists no run");
  int count = 0;
  for (const json& wanted : expected["runs"]) count += differences(argv[1], folder, argv[3], wanted);
  return count == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
