// Writes a configuration of any size as XYZ, for benchmarks: write_configuration NAME SIZE
//
// Guarantees: the same bytes on every machine. SIZE is the number of points of half-shell and long-cascade, and
// of the teeth of capsule.
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <string>

#include "fuzz/inputs/capsule_sample.h"
#include "fuzz/inputs/large_configurations.h"

int main(int argc, char** argv) {
  using namespace flowcert::fuzz;
  const std::map<std::string, std::function<Input(std::size_t)>> all = {
      {"capsule", [](std::size_t size) { return capsule_sample(size); }},
      {"half-shell", [](std::size_t size) { return half_shell(size, 1); }},
      {"long-cascade", [](std::size_t size) { return long_cascade(size, 1); }}};
  const auto chosen = argc == 3 ? all.find(argv[1]) : all.end();
  if (chosen == all.end()) {
    std::cerr << "usage: write_configuration capsule|half-shell|long-cascade SIZE\n";
    return 2;
  }
  try {
    std::cout << chosen->second(std::strtoull(argv[2], nullptr, 10));
  } catch (const std::exception& error) {
    std::cerr << "write_configuration: " << error.what() << '\n';
    return 2;
  }
}
