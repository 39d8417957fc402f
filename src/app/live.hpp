#pragma once
// A run that can be watched in a browser while it goes: its page and its log, served on this machine alone.

#include <cstdint>
#include <memory>
#include <ostream>

#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"
#include "carom/write/run_report.hpp"
#include "run_record.hpp"
#include "run_to_the_end.hpp"

namespace carom::app {

/// Answers on 127.0.0.1 and nowhere else, to GET of
///   /         the page, with the scene and the balls at the start
///   /chunk?N  chunk N of the log (include/carom/write/replay_log.hpp); 204: not yet; empty: there are no more
///   /result   the summary, once the run has ended
/// and to nothing else: it reads no files.
class Live {
 public:
  /// `simulation` is at the start of its run. port 0: any that is free. Throws InputError.
  Live(int port, const Scene& scene, Simulation& simulation, const RunRecord& record);
  ~Live();
  Live(const Live&) = delete;
  Live& operator=(const Live&) = delete;

  [[nodiscard]] int port() const;

  /// The log is fed by what is watched from now on.
  void watch(Watchers& watchers);

  /// The run has ended: pages are told, and the server stays until `interrupt` is set.
  void finish(const RunReport& report, const std::atomic<bool>& interrupt);

 private:
  class Server;
  std::unique_ptr<Server> server_;
};

}  // namespace carom::app
