#include "carom/core/error.hpp"
#include "live.hpp"

namespace carom::app {

class Live::Server {};

Live::Live(int, const Scene&, Simulation&, const RunRecord&) {
  throw InputError(Problem{"", 0, "--live is not part of this carom", "cpp-httplib was not there when it was built",
                           "Install the Debian package libcpp-httplib-dev, and build carom again"});
}
Live::~Live() = default;
int Live::port() const { return 0; }
void Live::watch(Watchers&) {}
void Live::finish(const RunReport&, const std::atomic<bool>&) {}

}  // namespace carom::app
