// The table of conformance vectors: which inputs there are, under which permanent ids, and what they aim at.
//
// Guarantees: a function of this source and of fuzz/ alone, the same on every machine. An id is never
// renumbered and never given to another input: new cases get new numbers, and a family of fuzz/ that has to
// change leaves the inputs that were drawn from it behind, as given points.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "oracle/exact_geometry.h"
#include "tests/vectors/cycle_claims.h"
#include "tests/vectors/shapes.h"

namespace oracle::vectors {

// What is asked of a case beside its stationary points.
struct Asked {
  bool limits = false;         // the limits of U2
  bool stable = false;         // the stable sets of index-2 and regular stationary points
  bool persistence = false;    // the persistence pairs
  bool lambda = false;         // λ-lists
  bool connections = false;    // the connections, and whether the input is Morse-Smale
  bool volumes = false;        // volumes of stable sets, and shares
  bool surfaces = false;       // unstable sets of dimension 2
  bool trees = false;          // both merge trees
  bool pockets = false;        // pockets at several persistences, for several probes
  bool medial = false;         // what is above several angles and persistences
  bool infinity = false;       // the skeleton of infinity
  bool statistics = false;     // n_U2, n_S2 and n_WCC
  bool cycles = false;         // claims of cycles, right and wrong ones
  bool locations = false;      // of starts, not the orbits but the locations
  std::size_t own_starts = 0;  // so many starts of starts.h
};

// A case with an answer.
struct Recipe {
  std::string id;
  std::string comment;
  std::vector<std::string> aims;  // flags that do not follow from input and answer (flags.h)
  Rows points;
  Asked asks;
  std::vector<Point> starts;             // instead of starts of starts.h
  std::vector<CycleClaim> cycle_claims;  // beside those that follow from the points
};

// A case that has to be refused.
struct InvalidRecipe {
  std::string id;
  std::string comment;
  std::vector<std::string> aims;
  std::vector<std::vector<std::string>> points;   // words of a point file, a row each
  std::optional<std::string> text;                // instead of points: all of a point file
  std::optional<std::vector<std::string>> start;  // of an orbit, where the points are right
};

struct Group {
  std::string name;  // also the name of its file
  std::string title;
  std::vector<std::string> clauses;  // what all of its cases rest on
  std::vector<Recipe> recipes;
  std::vector<InvalidRecipe> invalid_recipes;
};

// All groups, in the order of ids.
const std::vector<Group>& groups();

// Throws std::logic_error for an id that is given twice.
void require_different_ids(const std::vector<Group>& table);

// The parts of the table, each from a file of its own.
void add_stationary_groups(std::vector<Group>& table);
void add_orbit_groups(std::vector<Group>& table);
void add_homology_groups(std::vector<Group>& table);
void add_whole_complex_groups(std::vector<Group>& table);
void add_landscape_groups(std::vector<Group>& table);
void add_cycle_groups(std::vector<Group>& table);
void add_invalid_groups(std::vector<Group>& table);

// For example "cospherical-clusters-0007".
std::string case_id(const std::string& group, std::size_t number);

// {1, ..., count}.
std::vector<std::uint64_t> seeds(std::size_t count);
// Points from texts such as "1/2 0 -3".
std::vector<Point> positions(std::initializer_list<const char*> texts);

// Makes a group, case by case. Clauses and aims are lists of words, parted by blanks.
class GroupWriter {
 public:
  GroupWriter(const char* name, const char* title, const char* clauses);

  // Adds cases first, first + 1, ...: the family's inputs of that size, one for each seed.
  void drawn(std::size_t first, const char* family, int size, const std::vector<std::uint64_t>& seeds);
  void given(std::size_t number, const std::string& comment, const char* aims, const Rows& points);
  // Gives these starts to the case given last.
  void start_from(const std::vector<Point>& starts);
  // Gives a claim of cycles to the case given last.
  void claim_cycles(const std::vector<std::string>& lines, const std::vector<std::string>& reasons);
  // Adds three cases: the points exactly, with one coordinate one ulp up, and with it one ulp down.
  void threefold(std::size_t first, const std::string& comment, const Rows& points, std::size_t row, std::size_t axis);
  // Adds three cases: the points, their mirror image (x changes its sign), and that with its rows in reversed order.
  void mirrored(std::size_t first, const std::string& comment, const char* aims, const Rows& points);

  // What all cases from now on ask for.
  void asking(const Asked& asks) { asks_ = asks; }

  [[nodiscard]] const Group& group() const { return group_; }

 private:
  Group group_;
  Asked asks_;
};

// Adds the cases 1 to 8 that several groups begin with.
void add_first_cases(GroupWriter& cases);
// Adds the cases 1 to 26, 27 to 29 and 30 to 38 of the groups about the whole complex: shapes of usual sizes, extreme
// scales, and what is exact or one ulp off.
void add_named_shapes(GroupWriter& cases);
void add_named_extremes(GroupWriter& cases);
void add_named_triples(GroupWriter& cases);
// All of these.
void add_named_cases(GroupWriter& cases);

}  // namespace oracle::vectors
