#include "run_record.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "carom/core/error.hpp"
#include "carom/write/output_file.hpp"
#include "write/json_text.hpp"

namespace carom::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* record_file = "run.json";

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace

RunRecord record_of(const SceneArguments& arguments) {
  RunRecord record{arguments.file, text_of(arguments.file), arguments.set};
  if (!arguments.until.empty()) record.set.push_back("run.until=" + arguments.until);
  if (!arguments.events.empty()) record.set.push_back("run.events=" + arguments.events);
  return record;
}

void write_run_record(const std::string& folder, const RunRecord& record) {
  OutputFile file((fs::path(folder) / record_file).string());
  file.line() += json_text({{"carom", CAROM_VERSION}, {"scene", record.file}, {"set", record.set}, {"text", record.text}});
  file.close();
}

std::optional<RunRecord> read_run_record(const std::string& folder) {
  const fs::path path = fs::path(folder) / record_file;
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return std::nullopt;
  try {
    const Json j = Json::parse(text_of(path));
    return RunRecord{j.at("scene"), j.at("text"), j.at("set")};
  } catch (const Json::exception&) {
    throw InputError(Problem{path.string(), 0, "this is no record of a run", "carom run --out writes one beside its files",
                             "Name the scene file itself"});
  }
}

Scene read_scene(const RunRecord& record) {
  std::vector<Override> overrides;
  for (const std::string& set : record.set) {
    const std::size_t equals = set.find('=');
    overrides.push_back({set.substr(0, equals), equals == std::string::npos ? "" : set.substr(equals + 1)});
  }
  return carom::read_scene(record.text, record.file, overrides);
}

}  // namespace carom::app
