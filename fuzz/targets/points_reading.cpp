// Point files; see reading.h for what is asked of them.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <sstream>

#include "flowcert/read_points.h"
#include "fuzz/properties/input_points.h"
#include "fuzz/targets/reading.h"
#include "oracle/program/read_points.h"

namespace flowcert::fuzz {
namespace {

using Rows = std::vector<Row>;

Rows rows_of(const PointFile& file) { return property::input_of(file.rows).rows; }

// Here -0.0 differs from 0.0.
bool same_bits(const Rows& a, const Rows& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Row)) == 0);
}

bool is_finite(const Row& row) { return std::isfinite(row[0]) && std::isfinite(row[1]) && std::isfinite(row[2]); }

std::string text_of(const Rows& rows) {
  std::ostringstream text;
  text << rows.size() << " rows:\n" << Input{rows};
  return text.str();
}

// Returns nothing if the file is refused.
std::optional<PointFile> file_read(std::string_view text, const std::string& name) {
  try {
    return read_points_from(text, name);
  } catch (const InvalidInput&) {
    return std::nullopt;
  }
}

std::optional<Rows> rows_for_oracle(std::string_view text, const std::string& name) {
  const bool is_obj = name.ends_with(".obj");
  std::istringstream in{std::string(text)};
  try {
    return oracle::read_points(in, name, is_obj ? oracle::PointFormat::kObj : oracle::PointFormat::kTable);
  } catch (const oracle::UnusableInput&) {
    return std::nullopt;
  }
}

// Ends of lines and marks that the oracle does not know, and bytes that the library takes for another format's.
bool is_for_oracle(std::string_view text, const std::string& name) {
  if (!name.ends_with(".xyz") && !name.ends_with(".obj")) return false;
  if (text.starts_with("\x1f\x8b") || text.starts_with("\xef\xbb\xbf")) return false;
  if (text.find('\0') != std::string_view::npos) return false;
  for (std::size_t k = text.find('\r'); k != std::string_view::npos; k = text.find('\r', k + 1)) {
    if (!text.substr(k).starts_with("\r\n")) return false;
  }
  return true;
}

// The oracle reads less than the library does, and what it reads is the same.
std::string complaint_against_oracle(Bytes bytes, const std::string& name) {
  const std::string_view text = fuzz::text_of(bytes);
  if (!is_for_oracle(text, name)) return {};
  const std::optional<PointFile> file = file_read(text, name);
  const std::optional<Rows> truth = rows_for_oracle(text, name);
  if (!truth) return {};
  if (!file) return "the library refuses, and the oracle reads " + text_of(*truth);
  if (same_bits(rows_of(*file), *truth)) return {};
  return text_of(rows_of(*file)) + "are, for the oracle, " + text_of(*truth);
}

}  // namespace

std::string complaint_about_points(Bytes bytes, const std::string& name) {
  PointFile file;
  try {
    file = read_points_from(text_of(bytes), name);
  } catch (const InvalidInput& error) {
    const std::string complaint = complaint_about_refusal(error);
    return complaint.empty() ? complaint_against_oracle(bytes, name) : complaint;
  }
  const Rows rows = rows_of(file);
  if (!std::all_of(rows.begin(), rows.end(), is_finite)) return "not all finite: " + text_of(rows);
  if (!rows.empty()) {
    std::ostringstream xyz;
    xyz << Input{rows};
    const Rows again = rows_of(read_points_from(xyz.str(), "a.xyz"));
    if (!same_bits(rows, again)) return "as XYZ, others: " + text_of(rows) + "became " + text_of(again);
  }
  const Rows named = rows_of(read_points_from(text_of(bytes), "-", {.format = file.format}));
  if (!same_bits(rows, named)) return "by its format's name, others: " + text_of(rows) + "became " + text_of(named);
  return complaint_against_oracle(bytes, name);
}

}  // namespace flowcert::fuzz
