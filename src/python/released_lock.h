// What the library computes, it computes without Python's lock, and Ctrl-C stops it.
//
// Guarantees: while a ReleasedLock lives, other threads of Python run. stop_if_interrupted() may be called by any
// thread of the library. It asks Python for signals only in the thread that Python called, and only now and then, so
// that it costs nothing.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>

namespace flowcert::python {

class ReleasedLock {
 public:
  ReleasedLock();
  ~ReleasedLock();
  ReleasedLock(const ReleasedLock&) = delete;
  ReleasedLock& operator=(const ReleasedLock&) = delete;

 private:
  pybind11::gil_scoped_release released_;
};

// Throws what a handler of signals has raised in Python, for example KeyboardInterrupt. It takes the lock for that, so
// the caller must not have it.
void stop_if_interrupted();

}  // namespace flowcert::python
