#pragma once
// The processes of one sweep where mpirun has started several.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "ranks_module.hpp"

namespace carom::app {

struct Letter {
  int from = 0;
  std::string text;
};

/// MPI is in a module of its own, which is loaded where mpirun has started carom and nowhere else.
class Ranks {
 public:
  /// None: this process is alone. Throws InputError where there are others and no module to reach them by.
  [[nodiscard]] static std::unique_ptr<Ranks> begin();
  ~Ranks();  ///< waits for the others
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  [[nodiscard]] int rank() const { return module_.rank(); }
  [[nodiscard]] int size() const { return module_.size(); }

  /// By one thread at a time.
  void send(int to, const std::string& text) const { module_.send(to, text.data(), text.size()); }
  /// What has come; none: nothing yet.
  [[nodiscard]] std::optional<Letter> receive() const;
  /// Waits for it.
  [[nodiscard]] Letter wait() const;
  /// Ends all processes: something is wrong with this one.
  [[noreturn]] void abort() const;

 private:
  explicit Ranks(const CaromRanks& module) : module_(module) {}

  CaromRanks module_;
};

}  // namespace carom::app
