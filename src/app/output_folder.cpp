#include "output_folder.hpp"

#include <string>
#include <system_error>

#include "carom/write/output_file.hpp"

namespace carom::app {

namespace fs = std::filesystem;

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder, error))
    throw OutputError("cannot make the folder \"" + folder.string() + "\": " +
                      (error ? error.message() : std::string("something else has that name")) + ". Choose another --out.");
}

}  // namespace carom::app
