// What `flowcert compute --manifolds all -o` writes of a point file, read as JSON, and numbers of it for the oracle.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "oracle/program/read_records.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance {

using nlohmann::json;

inline constexpr char kCube[] = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n";
inline constexpr char kOctahedron[] = "1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n";
// Its base is a square whose centre is the circumcentre of all: a regular stationary point of kind 2-3.
inline constexpr char kHalfOctahedron[] = "1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n";
inline constexpr char kPyramid[] = "0 0 0\n2 0 0\n2 2 0\n0 2 0\n1 1 3\n";
// Regular stationary points of kinds 1-2 and 1-3.
inline constexpr char kChain[] = "0 0 0\n1 0 0\n1 1 0\n1 1 1\n2 1 1\n";
// An orbit of U2 of {0,1,2} ends at {0,3,4}, which has index 2.
inline constexpr char kSaddleToSaddle[] = "0 5 0\n-3 0 -2\n3 0 -2\n0 0 12\n0 -5 0\n";

struct Written {
  json header;
  std::vector<json> records;

  // The record with these samples as contact set.
  [[nodiscard]] const json& of(const std::vector<std::size_t>& contact) const {
    for (const json& record : records) {
      if (record["contact"] == contact) return record;
    }
    throw std::runtime_error("no such record");
  }
};

inline std::string file_of(const Scratch& scratch, const std::string& points, const std::vector<std::string>& options) {
  const std::string output = scratch.path("records.jsonl");
  std::vector<std::string> words = {"compute", scratch.file("points.xyz", points), "-o", output};
  words.insert(words.end(), options.begin(), options.end());
  const Finished finished = flowcert(words);
  EXPECT_EQ(finished.status, 0) << finished.err;
  return content_of(output);
}

inline Written written(const std::string& points, std::vector<std::string> options = {"--volumes", "exact"}) {
  const Scratch scratch;
  options.insert(options.end(), {"--manifolds", "all"});
  Written result;
  for (const std::string& line : lines_of(file_of(scratch, points, options))) {
    (result.header.is_null() ? result.header : result.records.emplace_back()) = json::parse(line);
  }
  return result;
}

inline oracle::Rational rational(const json& text) {
  const auto read = oracle::parse_rational(text.get<std::string>());
  EXPECT_TRUE(read && read->canonical) << text;
  return read ? read->value : 0;
}

inline oracle::Point position(const json& field) {
  return {rational(field[0]), rational(field[1]), rational(field[2])};
}

inline std::vector<std::array<double, 3>> rows_of(const std::string& points) {
  std::vector<std::array<double, 3>> rows;
  std::istringstream text(points);
  for (std::array<double, 3> row{}; text >> row[0] >> row[1] >> row[2];) rows.push_back(row);
  return rows;
}

}  // namespace flowcert::conformance
