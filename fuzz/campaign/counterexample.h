// A case on which a property does not hold, and its file; inputs and starts of orbits as JSON.
//
// Guarantees: the file is a point file in XYZ format that every reader of such files takes. Its comments say where
// the case came from, which property it breaks and how, and both answers. What counterexample_of reads from a file is
// enough to try the case again: the property, the kind, the start, and exactly the points that were written.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "fuzz/inputs/input.h"
#include "fuzz/properties/property.h"
#include "oracle/exact_geometry.h"

namespace flowcert::fuzz {

// ---- JSON ----
// Coordinates are written as hexadecimal floats and rationals as p/q, so both are exact. Text that cannot be read
// throws nlohmann::json::exception or std::invalid_argument.
[[nodiscard]] nlohmann::json json_of(const Input& input);
[[nodiscard]] Input input_of(const nlohmann::json& rows);

// "1/2 0 -3", and back. Throws std::invalid_argument for what is not three rationals.
[[nodiscard]] std::string to_text(const oracle::Point& point);
[[nodiscard]] oracle::Point point_of(const std::string& text);

// ---- The case ----

struct Counterexample {
  std::uint64_t seed = 0;
  std::size_t number = 0;       // of the case in its campaign
  std::string source;           // a family's name, or "mutant"
  std::size_t rows_before = 0;  // of the case before it was shrunk
  std::string property;
  property::Trial trial;  // with its start as coordinates, if it has points
  property::Disagreement disagreement;
  bool is_small = false;  // nothing is left to be done to make it small
  // So many smaller inputs were tried, and no more, though it may get smaller; 0: it does not.
  std::size_t most_tried = 0;
  bool is_asked = false;  // somebody asked for it by its number (OneCase)
};

// One word, for the name of a file: "orbit-segment-type-1234".
[[nodiscard]] std::string name_of(const Counterexample& counterexample);

// "PROPERTY KIND".
[[nodiscard]] std::string kind_of(const Counterexample& counterexample);

// Whether the case ended its process, by a crash or by hanging. Then it cannot be part of its batch.
[[nodiscard]] bool ends_process(const Counterexample& counterexample);

// Why it may be larger than it has to be: "it hangs", "400 smaller inputs were tried", or, if it is not small yet, what
// `unless_small` says; empty if it cannot be made smaller.
[[nodiscard]] std::string why_not_fully_shrunk(const Counterexample& counterexample, const std::string& unless_small);

[[nodiscard]] std::string file_text(const Counterexample& counterexample);
// If the file does not name them, the property is empty and the start is a choice. Throws std::invalid_argument, one
// line "LINE: reason", for rows and comments that cannot be read.
[[nodiscard]] Counterexample counterexample_of(const std::string& file_text);

[[nodiscard]] nlohmann::json json_of(const Counterexample& counterexample);
// Throws nlohmann::json::exception or std::invalid_argument.
[[nodiscard]] Counterexample counterexample_of(const nlohmann::json& object);

}  // namespace flowcert::fuzz
