// See interruption.h.
#include "fuzz/judge/interruption.h"

#include <signal.h>

#include <atomic>

namespace flowcert::judge {

namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

// Read by all threads, written by a signal handler.
std::atomic<int> noted{0};
static_assert(std::atomic<int>::is_always_lock_free);

void note(int number) {
  int none = 0;
  noted.compare_exchange_strong(none, number);
}

void replace_handlers(void (*from)(int), void (*to)(int)) {
  for (const int number : kSignals) {
    struct sigaction current {};
    if (::sigaction(number, nullptr, &current) == 0 && current.sa_handler == from) ::signal(number, to);
  }
}

}  // namespace

Interruption::Interruption() {
  noted = 0;
  replace_handlers(SIG_DFL, note);
}

Interruption::~Interruption() { replace_handlers(note, SIG_DFL); }

int Interruption::signal() { return noted; }

}  // namespace flowcert::judge
