// The file of stationary points (spec/formats.md, section 2): a header, then one record a point, to which a
// caller can add keys.
#pragma once

#include <functional>
#include <ostream>
#include <string>

#include "io/json_fields.h"

namespace flowcert::io {

// Told the place of a record in the list.
using FurtherKeys = std::function<void(std::size_t i, Json& record)>;

// progress, if given, is told now and then how many records are written. The stream's state tells whether all
// was written.
void write_stationary_records(std::ostream& out, const PointSet& points, const StationaryPoints& stationary,
                              const std::string& input_sha256, const FurtherKeys& add_further_keys,
                              const std::function<void(std::size_t done, std::size_t total)>& progress);

}  // namespace flowcert::io
