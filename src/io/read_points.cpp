// From a name to its bytes, through gzip, to the reader of its format. CGAL::IO::read_points is not used; the readers
// say what it does with damaged files of each format.
#include "flowcert/read_points.h"

#include "io/input_bytes.h"
#include "io/layer.h"
#include "io/line_reader.h"

namespace flowcert {

using namespace io;
namespace {

enum class Format { kXyz, kOff, kPly, kObj, kPdb, kMmcif };

Format format_of_name(std::string name) {
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (name.ends_with(".gz")) name.resize(name.size() - 3);
  if (name.ends_with(".off")) return Format::kOff;
  if (name.ends_with(".ply")) return Format::kPly;
  if (name.ends_with(".obj")) return Format::kObj;
  if (name.ends_with(".pdb") || name.ends_with(".ent")) return Format::kPdb;
  if (name.ends_with(".cif") || name.ends_with(".mmcif")) return Format::kMmcif;
  return Format::kXyz;
}

Format format_of_content(std::string_view bytes) {
  LineReader lines(bytes, "");
  std::string_view line;
  std::string_view word;
  if (!lines.next_uncommented(line)) return Format::kXyz;
  Fields(line, Separators::kBlanks).next(word);
  if (word == "ply") return Format::kPly;
  if (is_off_keyword(word)) return Format::kOff;
  if (is_pdb_record(word)) return Format::kPdb;
  if (word.starts_with("data_")) return Format::kMmcif;
  return is_obj_keyword(word) ? Format::kObj : Format::kXyz;
}

PointFile read_as(Format format, std::string_view bytes, std::string_view file,
                  const std::vector<std::string>& chains) {
  const bool has_chains = format == Format::kPdb || format == Format::kMmcif;
  if (!chains.empty() && !has_chains) reject_file(file, "only PDB and mmCIF files have chains");
  PointFile points;
  switch (format) {
    case Format::kXyz:
      points = read_xyz(bytes, file);
      points.format = "xyz";
      break;
    case Format::kOff:
      points = read_off(bytes, file);
      points.format = "off";
      break;
    case Format::kPly:
      points = read_ply(bytes, file);
      points.format = "ply";
      break;
    case Format::kObj:
      points = read_obj(bytes, file);
      points.format = "obj";
      break;
    case Format::kPdb:
      points = read_pdb(bytes, file, chains);
      points.format = "pdb";
      break;
    case Format::kMmcif:
      points = read_mmcif(bytes, file, chains);
      points.format = "mmcif";
      break;
  }
  return points;
}

}  // namespace

PointFile read_points_from(std::string_view bytes, const std::string& name, const std::vector<std::string>& chains) {
  std::string decompressed;
  bytes = plain_content(bytes, name, decompressed);
  return read_as(name == "-" ? format_of_content(bytes) : format_of_name(name), bytes, name, chains);
}

PointFile read_points(const std::string& path, const std::vector<std::string>& chains) {
  return read_points_from(read_bytes(path), path, chains);
}

}  // namespace flowcert
