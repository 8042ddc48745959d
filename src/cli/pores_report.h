// The tables of `flowcert pores` for people.
#pragma once

#include <string>

#include "cli/layer.h"
#include "io/write_pores.h"

namespace flowcert::cli {

struct PoresReport {
  std::string input;  // "cage.xyz (chemical XYZ)"
  const PoresToWrite& what;
  bool shows_all = false;
  double seconds = 0;
};

void print_pores_report(const PoresReport& report);

// The number of cavities for each probe.
void print_cavity_curve(const Pores& pores);

}  // namespace flowcert::cli
