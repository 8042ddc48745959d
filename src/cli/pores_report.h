// The tables of `flowcert pores`, and of `flowcert pockets --radii`, for people.
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

struct CavitiesReport {
  std::string input;
  const CavitiesToWrite& what;
  bool shows_all = false;
  double seconds = 0;
};

// The cavities for one probe, with their atoms.
void print_cavities_report(const CavitiesReport& report);

}  // namespace flowcert::cli
