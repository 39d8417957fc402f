#include "ranks.hpp"

#include <dlfcn.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <thread>

#include "carom/core/error.hpp"

namespace carom::app {

namespace fs = std::filesystem;

namespace {

/// Open MPI, MPICH and Slurm say it in the environment.
bool started_by_mpirun() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"})
    if (std::getenv(name) != nullptr) return true;
  return false;
}

/// Beside the program where it was built, or where it was installed.
fs::path module_file() {
  std::error_code ignored;
  const fs::path here = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const fs::path& folder : {here, here / CAROM_MODULES})
    if (fs::exists(folder / "carom_mpi.so", ignored)) return folder / "carom_mpi.so";
  return {};
}

[[noreturn]] void refuse(const std::string& why) {
  throw InputError(Problem{"", 0, "carom was started by mpirun", why, "Start one process, which uses all processors: --threads"});
}

}  // namespace

std::unique_ptr<Ranks> Ranks::begin() {
  if (!started_by_mpirun()) return nullptr;
  const fs::path file = module_file();
  if (file.empty()) refuse("this build has no MPI, so that each process would do all the work (Debian: libopenmpi-dev)");
  void* module = dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);  // parts of MPI look for its symbols
  if (module == nullptr) refuse(dlerror());
  const auto start = reinterpret_cast<CaromRanksBegin>(dlsym(module, "carom_ranks_begin"));
  CaromRanks ranks{};
  if (start == nullptr || !start(&ranks)) refuse("MPI does not start");
  return std::unique_ptr<Ranks>(new Ranks(ranks));
}

Ranks::~Ranks() { module_.end(); }

std::optional<Letter> Ranks::receive() const {
  Letter letter;
  std::size_t size = 0;
  if (!module_.poll(&letter.from, &size)) return std::nullopt;
  letter.text.resize(size);
  module_.take(letter.from, letter.text.data(), size);
  return letter;
}

Letter Ranks::wait() const {
  while (true) {
    if (std::optional<Letter> letter = receive()) return std::move(*letter);
    std::this_thread::sleep_for(std::chrono::microseconds(200));  // MPI would spin, and take a processor from who computes
  }
}

void Ranks::abort() const {
  module_.abort();
  std::abort();
}

}  // namespace carom::app
