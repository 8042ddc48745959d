// Inputs and starts of orbits as JSON: rows of hexadecimal floats, rationals p/q.
//
// Guarantees: exact, both ways. What cannot be read throws nlohmann::json::exception or
// std::invalid_argument.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "fuzz/inputs/input.h"
#include "oracle/exact_geometry.h"

namespace flowcert::fuzz {

[[nodiscard]] nlohmann::json json_of(const Input& input);
[[nodiscard]] Input input_of(const nlohmann::json& rows);

// "1/2 0 -3", and back. Throws std::invalid_argument for what is not three rationals.
[[nodiscard]] std::string to_text(const oracle::Point& point);
[[nodiscard]] oracle::Point point_of(const std::string& text);

}  // namespace flowcert::fuzz
