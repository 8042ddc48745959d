// From a name to its bytes, through gzip, to the reader of its format. CGAL::IO::read_points is not used; the readers
// say what it does with damaged files of each format.
#include "flowcert/read_points.h"

#include <fmt/format.h>

#include "geometry/floating_point.h"
#include "io/input_bytes.h"
#include "io/point_formats.h"

namespace flowcert {

using namespace io;
namespace {

// An option that the format does not know is not passed over.
void check_options(PointFormat format, std::string_view file, const ReadingOptions& options) {
  const bool is_table = format == PointFormat::kTable || format == PointFormat::kPts;
  const bool is_molecule = format == PointFormat::kPdb || format == PointFormat::kCif;
  const auto allow = [&](bool is_given, bool is_known, const char* option, const char* formats) {
    if (!is_given || is_known) return;
    reject_file(file, fmt::format("{} is for {}, and this is {}", option, formats, name_of(format)));
  };
  allow(!options.columns.empty(), is_table, "--columns", "tables");
  allow(options.z.has_value(), is_table || format == PointFormat::kNpy, "--z", "tables and NPY");
  allow(!options.chains.empty(), is_molecule, "--chains", "PDB and CIF");
  allow(!options.models.empty(), is_molecule, "--models", "PDB and CIF");
  allow(!options.atoms.empty(), is_molecule || format == PointFormat::kChemical, "--atoms",
        "PDB, CIF and chemical XYZ");
  allow(options.frame != 0, format == PointFormat::kChemical, "--frame", "chemical XYZ");
}

}  // namespace

PointFile read_points_from(std::string_view bytes, const std::string& name, const ReadingOptions& options) {
  const geometry::IeeeDoubles ieee;
  std::string decompressed;
  bytes = plain_content(bytes, name, decompressed, options.unlimited);
  const PointFormat format = !options.format.empty()    ? format_named(options.format)
                             : !options.columns.empty() ? format_with_columns(bytes)
                                                        : format_of_content(bytes, name);
  check_options(format, name, options);
  PointRows rows(name, options);
  read_as(format, bytes, rows);
  PointFile file = rows.take();
  file.format = name_of(format);
  return file;
}

PointFile read_points(const std::string& path, const ReadingOptions& options) {
  return read_points_from(read_bytes(path, options.progress), path, options);
}

}  // namespace flowcert
