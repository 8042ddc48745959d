// What is wrong with an input is said with its name before it.
#pragma once

#include <string>

#include "flowcert/point_set.h"
#include "io/layer.h"

namespace flowcert::io {

// Runs the work. An InvalidInput that it throws gets this name.
template <typename Work>
auto naming(const std::string& name, const Work& work) {
  try {
    return work();
  } catch (const InvalidInput& error) {
    throw InvalidInput(name + ": " + error.what());
  }
}

}  // namespace flowcert::io
