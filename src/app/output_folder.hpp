#pragma once
// The folder that --out names.

#include <filesystem>

namespace carom::app {

/// Makes it if it is not there. Throws OutputError.
void make_folder(const std::filesystem::path& folder);

}  // namespace carom::app
