#include "interrupt.hpp"

#include <csignal>

namespace carom::app {

namespace {

std::atomic<bool> requested{false};
std::atomic<int> caught{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free, "set by a signal handler");

extern "C" void on_signal(int number) {
  caught.store(number);
  requested.store(true);
}

struct sigaction former_int, former_term;

}  // namespace

Interrupt::Interrupt() {
  requested = false;
  caught = 0;
  struct sigaction action = {};
  action.sa_handler = on_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;  // the second one finds the default again
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, &former_int);
  sigaction(SIGTERM, &action, &former_term);
}

Interrupt::~Interrupt() {
  sigaction(SIGINT, &former_int, nullptr);
  sigaction(SIGTERM, &former_term, nullptr);
}

std::atomic<bool>& Interrupt::flag() const noexcept { return requested; }
int Interrupt::signal() const noexcept { return caught; }

}  // namespace carom::app
