#include "live.hpp"

#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <httplib.h>

#include "carom/core/error.hpp"
#include "carom/write/replay_log.hpp"
#include "view_page.hpp"
#include "view_scene.hpp"
#include "write/replay_scene.hpp"
#include "write/summary_object.hpp"

namespace carom::app {

namespace {

constexpr const char* here = "127.0.0.1";
constexpr std::int64_t most_events = 2'000'000;  // that are kept for pages: some 400 MB
constexpr auto pause = std::chrono::milliseconds(50);

/// N of "/chunk?N".
std::optional<std::size_t> number_asked(const httplib::Request& request) {
  if (request.params.size() != 1) return std::nullopt;
  const std::string& word = request.params.begin()->first;
  if (word.empty() || word.size() > 9 || word.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
  return std::stoul(word);
}

}  // namespace

class Live::Server {
 public:
  Server(int port, const Scene& scene, Simulation& simulation, const RunRecord& record)
      : log_(scene, simulation, [this](std::string chunk) { keep(std::move(chunk)); }) {
    Json head = scene_of_page(scene, simulation, log_, record);
    head["live"] = true;
    page_ = live_page(*page_parts(), scene.dimension, head, replay_start(scene, simulation));
    answer();
    http_.set_keep_alive_timeout(1);
    http_.set_socket_options([](socket_t socket) {  // not SO_REUSEPORT: a port belongs to one run
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    port_ = port == 0 ? http_.bind_to_any_port(here) : http_.bind_to_port(here, port) ? port : -1;
    if (port_ < 0)
      throw InputError(Problem{"", 0, "--live " + std::to_string(port) + ": the port is taken, or not allowed", "",
                               "Give another one, or 0 for any that is free"});
    thread_ = std::thread([this] { http_.listen_after_bind(); });
  }
  ~Server() {
    while (!http_.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    http_.stop();
    thread_.join();
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  [[nodiscard]] int port() const noexcept { return port_; }

  void add(const Collision& c) {
    if (log_.events() < most_events) log_.add(c);
  }
  void flush() { log_.flush(); }

  void finish(const RunReport& report) {
    const std::int64_t collisions = report.summary.events.collisions();
    const Json result{{"summary", summary_object(report)},
                      {"cut", collisions > most_events ? Json(log_.events()) : Json(nullptr)},
                      {"tables", Json::array()}};
    log_.flush();
    const std::lock_guard lock(mutex_);
    result_ = json_text(result);
  }

 private:
  void keep(std::string chunk) {
    const std::lock_guard lock(mutex_);
    chunks_.push_back(std::move(chunk));
  }

  void answer() {
    using httplib::Request, httplib::Response;
    http_.Get("/", [this](const Request&, Response& response) { response.set_content(page_, "text/html; charset=utf-8"); });
    http_.Get("/chunk", [this](const Request& request, Response& response) {
      const std::optional<std::size_t> n = number_asked(request);
      const std::lock_guard lock(mutex_);
      if (!n) {
        response.status = 400;
      } else if (*n < chunks_.size()) {
        response.set_content(chunks_[*n], "application/octet-stream");
      } else if (result_.empty()) {
        response.status = 204;
      }
    });
    http_.Get("/result", [this](const Request&, Response& response) {
      const std::lock_guard lock(mutex_);
      if (result_.empty()) {
        response.status = 404;
      } else {
        response.set_content(result_, "application/json");
      }
    });
  }

  ReplayLog log_;
  std::string page_;
  httplib::Server http_;
  int port_ = -1;
  std::thread thread_;
  std::mutex mutex_;  // of what follows
  std::vector<std::string> chunks_;
  std::string result_;
};

Live::Live(int port, const Scene& scene, Simulation& simulation, const RunRecord& record) {
  if (page_parts() == nullptr)
    throw InputError(Problem{"", 0, "--live is not part of this carom", "node and npm were not there when it was built",
                             "Install the Debian packages nodejs and npm, and build carom again"});
  server_ = std::make_unique<Server>(port, scene, simulation, record);
}
Live::~Live() = default;

int Live::port() const { return server_->port(); }

void Live::watch(Watchers& watchers) {
  watchers.collision = [this, before = watchers.collision](const Collision& c) {
    if (before) before(c);
    server_->add(c);
  };
  watchers.slice = [this, before = watchers.slice] {
    if (before) before();
    server_->flush();
  };
}

void Live::finish(const RunReport& report, const std::atomic<bool>& interrupt) {
  server_->finish(report);
  while (!interrupt.load()) std::this_thread::sleep_for(pause);
}

}  // namespace carom::app
