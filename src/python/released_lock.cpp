// A thread that the library started has no state in Python, and Python handles signals in its main thread alone.
#include "released_lock.h"

namespace flowcert::python {

namespace {

using Clock = std::chrono::steady_clock;

// People notice a delay of a tenth of a second.
constexpr std::chrono::milliseconds kBetweenQuestions{20};

thread_local bool was_called_by_python = false;
thread_local Clock::time_point next_question;

}  // namespace

ReleasedLock::ReleasedLock() {
  was_called_by_python = true;
  next_question = Clock::now() + kBetweenQuestions;
}

ReleasedLock::~ReleasedLock() { was_called_by_python = false; }

void stop_if_interrupted() {
  if (!was_called_by_python) return;
  const Clock::time_point now = Clock::now();
  if (now < next_question) return;
  next_question = now + kBetweenQuestions;
  const pybind11::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
}

}  // namespace flowcert::python
