// Pores of balls as text for other programs (spec/formats/pores.md).
//
// Guarantees: values are exact, as polynomials, with the nearest doubles beside them. The text depends on the balls and
// what is asked for alone.
#pragma once

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "flowcert/atom_names.h"
#include "flowcert/ball_cavities.h"
#include "flowcert/pores.h"

namespace flowcert {

struct PoresToWrite {
  const Pores& pores;
  Rational depth;
  std::optional<Rational> probe;
  const AtomNames* atoms = nullptr;  // of a molecule
  std::string radii{};               // as a user says them; empty where they are numbers of a program
};

// The cavities for one probe.
struct CavitiesToWrite {
  const BallSet& balls;
  const std::vector<BallCavity>& cavities;
  Rational probe;
  const AtomNames* atoms = nullptr;
  std::string radii{};
};

// The numbers of the chambers with the greatest peak and the greatest exit, the first ones at a tie. Twice these values
// are the diameters of FC-BALL-10; nothing where there is none.
struct WidestChambers {
  std::optional<std::size_t> of_peak, of_exit;
};
[[nodiscard]] WidestChambers widest_chambers(const Pores& pores);

// One JSON object, chamber by chamber.
void write_pores(std::ostream& out, const PoresToWrite& what);
// A table in CSV with a line of names, a row for each chamber. Numbers are the nearest doubles. Of several peak points,
// or gates, the first one has the position, and all have the atoms.
void write_pores_csv(std::ostream& out, const PoresToWrite& what);
// The same of all windows of chambers, a row for each chamber and each of its windows.
void write_windows_csv(std::ostream& out, const PoresToWrite& what);
// The number of cavities as a function of the probe, a row for each step, from the greatest probe down.
void write_cavity_curve_csv(std::ostream& out, const Pores& pores);

// One JSON object.
void write_cavities(std::ostream& out, const CavitiesToWrite& what);
// A row for each cavity, with the atoms that line it; and a row for each cavity and each of these atoms.
void write_cavities_csv(std::ostream& out, const CavitiesToWrite& what);
void write_cavity_atoms_csv(std::ostream& out, const CavitiesToWrite& what);

}  // namespace flowcert
