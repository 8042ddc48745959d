// The conformance vectors as they are stored (spec/formats/vectors.md), and their points as point files.
//
// Guarantees: a file that cannot be used, because it is not as the format says, throws InvalidInput "FILE: case:
// reason". So no later step fails because of it. What the file says is taken as right; nothing is computed here.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "certify/layer.h"
#include "certify/orbit_claim.h"
#include "certify/pair_claim.h"
#include "flowcert/point_set.h"
#include "flowcert/stationary_points.h"
#include "io/json_fields.h"

namespace flowcert::certify {

enum class CaseResult { kDetermined, kAcceptable, kInvalid };

struct CaseOrbit {
  std::string start;  // "1/2,0,-3", as a command line takes it
  OrbitPath path;
};

struct CasePoint {
  StationaryIndex index;
  std::vector<PointId> contact;  // ascending
  ExactSphere sphere;
};

// Records of stationary points by side; none: infinity.
using CaseLimits = std::array<std::optional<std::size_t>, 2>;

// Of a stable set, without its skeleton.
struct CaseStable {
  std::size_t segments = 0;
  bool has_vertex = false;
  bool has_interval = false;
  // Records of index 1, ascending. None where there is a tie, and for a regular stationary point.
  std::optional<std::vector<std::size_t>> boundary;
  std::optional<std::vector<PointId>> walk;
};

struct VectorCase {
  std::string id;
  std::string group;
  std::string comment;
  std::vector<std::string> flags;
  CaseResult result = CaseResult::kDetermined;

  // An invalid case has its rows, or all of its point file. It also has the start, if the start is what has to be
  // refused.
  std::vector<std::vector<std::string>> words;
  std::optional<std::string> text;
  std::optional<std::string> refused_start;

  // All other cases have the points, and what is right.
  std::vector<Point> rows;
  std::size_t merged_duplicates = 0;
  std::vector<CasePoint> stationary;              // in the order of FC-OUT-02
  std::vector<std::optional<CaseLimits>> limits;  // by stationary point, where the file has them
  std::vector<std::optional<CaseStable>> stable;  // by record
  std::vector<CaseOrbit> orbits;
  std::optional<std::vector<ListedPair>> persistence;

  std::string json;  // all of it, as text

  [[nodiscard]] bool is_invalid() const { return result == CaseResult::kInvalid; }
};

struct VectorFlag {
  std::string name;
  std::string meaning;
};

struct Vectors {
  std::vector<VectorFlag> flags;    // in the order of flags.json
  std::vector<std::string> groups;  // in alphabetical order, as the cases
  std::vector<VectorCase> cases;
};

[[nodiscard]] Vectors read_vectors(const std::string& folder);
// The folder beside an installed program, or else in the tree that the program was built from.
[[nodiscard]] std::string usual_vectors_folder();

// ---- Point files ----
// The points of a conformance vector as a point file (spec/formats/points.md).
//
// Guarantees: a reader that rounds to nearest gets exactly the doubles of the vector, since decimals are the shortest
// that read back to them. If an invalid case has another word in place of a number, it is written as it is. Nothing
// else is wrong with the file.
enum class PointFileFormat { kXyz, kOff };

struct PointFileStyle {
  PointFileFormat format = PointFileFormat::kXyz;
  bool hexadecimal = false;  // hexadecimal floats instead of decimals
};

// Returns nothing for a case that is about the text of an XYZ file, if another format is asked for.
[[nodiscard]] std::optional<std::string> point_file_text(const VectorCase& one, const PointFileStyle& style);

// "points.xyz"
[[nodiscard]] std::string point_file_name(const PointFileStyle& style);

}  // namespace flowcert::certify
