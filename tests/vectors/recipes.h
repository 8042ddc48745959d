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
#include "tests/vectors/shapes.h"

namespace oracle::vectors {

// A case with an answer: the stationary points, and what the members below ask for.
struct Recipe {
  std::string id;
  std::string comment;
  std::vector<std::string> aims;  // flags that do not follow from input and answer (flags.h)
  Rows points;
  bool limits = false;         // asks for the limits of U2
  bool stable = false;         // asks for the stable sets of index-2 and regular stationary points
  bool persistence = false;    // asks for the persistence pairs
  bool lambda = false;         // asks for λ-lists
  bool connections = false;    // asks for the connections, and whether the input is Morse-Smale
  bool volumes = false;        // asks for volumes of stable sets, and shares
  bool surfaces = false;       // asks for unstable sets of dimension 2
  std::vector<Point> starts;   // asks for the orbits from here,
  std::size_t own_starts = 0;  // and from so many starts of starts.h
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

// The parts of the table. recipes.cpp, flow_recipes.cpp and whole_complex_recipes.cpp add them.
void add_stationary_groups(std::vector<Group>& table);
void add_orbit_groups(std::vector<Group>& table);
void add_homology_groups(std::vector<Group>& table);
void add_whole_complex_groups(std::vector<Group>& table);
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
  // Adds the orbits from these starts to the case given last.
  void start_from(const std::vector<Point>& starts);
  // Adds three cases: the points exactly, with one coordinate one ulp up, and with it one ulp down.
  void threefold(std::size_t first, const std::string& comment, const Rows& points, std::size_t row, std::size_t axis);

  // What all cases from now on ask for.
  void with_limits() { limits_ = true; }
  void with_stable_sets() { stable_ = true; }
  void with_persistence() { persistence_ = true; }
  void with_lambda_lists() { lambda_ = true; }
  void with_connections() { connections_ = true; }
  void with_volumes() { volumes_ = true; }
  void with_unstable_surfaces() { surfaces_ = true; }
  void with_own_starts(std::size_t count) { own_starts_ = count; }

  [[nodiscard]] const Group& group() const { return group_; }

 private:
  Group group_;
  bool limits_ = false;
  bool stable_ = false;
  bool persistence_ = false;
  bool lambda_ = false;
  bool connections_ = false;
  bool volumes_ = false;
  bool surfaces_ = false;
  std::size_t own_starts_ = 0;
};

// Adds the cases 1 to 8 that several groups begin with.
void add_first_cases(GroupWriter& cases);

}  // namespace oracle::vectors
