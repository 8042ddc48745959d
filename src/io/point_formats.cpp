// Which format a content has. Marks at its front decide where there are any; a count above the rows leaves PTS and
// chemical XYZ; what is left is a table, if its first line has numbers or names of columns.
#include "io/point_formats.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <utility>
#include <vector>

#include "flowcert/read_points.h"
#include "geometry/floating_point.h"
#include "io/foreign_text.h"
#include "io/input_bytes.h"
#include "io/number_text.h"
#include "io/pqr_line.h"
#include "io/table_columns.h"

namespace flowcert::io {

namespace {

struct Format {
  std::string_view name;
  PointFormat format;
  void (*read)(std::string_view, PointRows&);
};
constexpr auto kFormats = std::to_array<Format>({{"table", PointFormat::kTable, read_table},
                                                 {"pts", PointFormat::kPts, read_pts},
                                                 {"chemical", PointFormat::kChemical, read_chemical},
                                                 {"off", PointFormat::kOff, read_off},
                                                 {"ply", PointFormat::kPly, read_ply},
                                                 {"obj", PointFormat::kObj, read_obj},
                                                 {"pcd", PointFormat::kPcd, read_pcd},
                                                 {"npy", PointFormat::kNpy, read_npy},
                                                 {"pdb", PointFormat::kPdb, read_pdb},
                                                 {"pqr", PointFormat::kPqr, read_pqr},
                                                 {"cif", PointFormat::kCif, read_cif}});

std::string all_names() {
  std::vector<std::string_view> names;
  for (const Format& format : kFormats) names.push_back(format.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

// ---- Formats that are known and not read ----

struct Mark {
  std::string_view bytes;
  std::string_view name;
};

// What files of other formats begin with.
constexpr auto kMarks = std::to_array<Mark>({{"PK\x03\x04", "a ZIP archive, as NPZ is"},
                                             {"LASF", "LAS or LAZ"},
                                             {"ASTM-E57", "E57"},
                                             {"\x89HDF", "HDF5"},
                                             {"CDF\x01", "NetCDF"},
                                             {"CDF\x02", "NetCDF"},
                                             {"<", "XML, as VTU and X3D are"},
                                             {"{", "JSON"},
                                             {"[", "JSON"},
                                             {"glTF", "glTF"},
                                             {"BZh", "bzip2"},
                                             {"\xfd\x37zXZ", "xz"},
                                             {"\x28\xb5\x2f\xfd", "Zstandard"},
                                             {"\xff\xfe", "text in UTF-16"},
                                             {"\xfe\xff", "text in UTF-16"},
                                             {"@<TRIPOS>", "MOL2"},
                                             {"ITEM: TIMESTEP", "a LAMMPS dump"},
                                             {"TITLE =", "Tecplot"},
                                             {"VARIABLES", "Tecplot"},
                                             {"\x89PNG", "a picture"},
                                             {"\xff\xd8\xff", "a picture"},
                                             {"%PDF", "PDF"}});

// The count of triangles is behind 80 bytes of a header, and each triangle takes 50.
bool is_binary_stl(std::string_view bytes) {
  if (bytes.size() < 84) return false;
  const double triangles = *stored_number(bytes.data() + 80, {'u', 4}, false);
  return static_cast<double>(bytes.size()) == 84 + 50 * triangles;
}

std::vector<std::string_view> first_lines(std::string_view text, std::size_t count) {
  std::vector<std::string_view> found;
  LineReader lines(text, "");
  for (std::string_view line; found.size() < count && lines.next(line);) found.push_back(line);
  found.resize(count);
  return found;
}

// VTK's first line is a comment of a table, whose third line is no word alone.
bool is_vtk(const std::vector<std::string_view>& lines) {
  const std::string_view kind = trimmed(lines[2]);
  return lines[0].starts_with("# vtk DataFile") && (kind == "ASCII" || kind == "BINARY");
}

// SDF or MOL: counts in columns of three, and a version at the end. Comments of formats that are read may end so, too.
bool is_molfile(const std::vector<std::string_view>& lines) {
  const std::string_view counts = without_comment(lines[3]);
  return (counts.ends_with("V2000") || counts.ends_with("V3000")) && is_integer(trimmed(counts.substr(0, 3))) &&
         is_integer(trimmed(counts.substr(3, 3)));
}

// GRO: a title, a count, and rows of fixed columns, whose first five are a number, with a name at once behind it.
bool is_gro(const std::vector<std::string_view>& lines) {
  const std::string_view atom = lines[2];
  return is_integer(trimmed(lines[1])) && atom.size() >= 44 && is_integer(trimmed(atom.substr(0, 5))) &&
         !is_blank(atom[4]) && !is_digit(atom[5]) && !is_blank(atom[5]);
}

// PTX: columns, rows, and the place of the scanner.
bool is_ptx(const std::vector<std::string_view>& lines) {
  return is_integer(trimmed(lines[0])) && is_integer(trimmed(lines[1])) && words_of(lines[2]).size() == 3 &&
         is_row_of_numbers(lines[2]);
}

// The name of a format that is not read, or nothing.
std::string_view unread_format(std::string_view bytes) {
  for (const Mark& mark : kMarks) {
    if (bytes.starts_with(mark.bytes)) return mark.name;
  }
  if (is_binary_stl(bytes)) return "STL";
  const std::vector<std::string_view> lines = first_lines(bytes, 4);
  if (lines[0].starts_with("solid") && trimmed(lines[1]).starts_with("facet")) return "STL";
  if (is_vtk(lines)) return "VTK";
  if (is_molfile(lines)) return "SDF or MOL";
  if (is_gro(lines)) return "GRO";
  if (is_ptx(lines)) return "PTX";
  return bytes.substr(0, 4096).find('\0') != std::string_view::npos ? "binary data" : std::string_view();
}

// ---- Formats that are read ----

// The first line that is neither blank nor a comment.
std::string_view first_line(std::string_view text) {
  LineReader lines(text, "");
  for (std::string_view line; lines.next_uncommented(line);) {
    if (!trimmed(line).starts_with("//")) return trimmed(line);
  }
  return {};
}

// After a count that stands alone: its rows, or a comment and its atoms.
struct Counted {
  bool fits_pts = false, fits_chemical = false;  // by the number of lines, too
  bool is_like_pts = false, is_like_chemical = false;
};

bool names_axes(std::string_view line) {
  return std::ranges::any_of(lists_of_names(line), [](const ColumnNames& list) { return list.has_axes(3); });
}

Counted counted(std::string_view text) {
  LineReader lines(text, "");
  const std::string_view line_of_count = first_line(text);
  std::string_view line;
  while (lines.next(line) && trimmed(line) != line_of_count) continue;
  std::uint64_t count = 0, filled = 0, atoms = 0;
  std::from_chars(line_of_count.data(), line_of_count.data() + line_of_count.size(), count);  // 0: it is too large
  Counted found;
  // Extended XYZ says itself where an atom's columns are. Elements may all be numbers.
  bool is_extended = false, is_first = true, are_numbers = true, is_named = false;
  for (std::uint64_t number = 1; lines.next(line); ++number) {
    const bool is_comment = trimmed(line).starts_with("//");
    if (!is_all_blank(line) && !is_comment) ++filled;
    if (!is_comment && std::exchange(is_first, false)) found.is_like_pts = is_row_of_numbers(line);
    if (number == 1) is_extended = lower_case(line).find("properties") != std::string::npos;
    if (number == 1) is_named = names_axes(line);
    const bool is_atom = is_extended ? !is_all_blank(line) : is_chemical_atom(line);
    if (number == 2) found.is_like_chemical = is_atom;
    if (number < 2 || number > count + 1) continue;
    if (is_atom) ++atoms;
    are_numbers = are_numbers && is_row_of_numbers(line);
  }
  found.fits_pts = found.is_like_pts && filled == count;
  found.is_like_chemical = found.is_like_chemical && !(are_numbers && is_named);
  // Below names of columns, or below a row, atoms by number may be rows.
  found.fits_chemical = count > 0 && atoms == count && !(are_numbers && (is_named || found.is_like_pts));
  return found;
}

PointFormat format_after_count(std::string_view text, std::string_view file) {
  const Counted found = counted(text);
  if (found.fits_pts != found.fits_chemical) return found.fits_pts ? PointFormat::kPts : PointFormat::kChemical;
  if (found.is_like_pts && found.is_like_chemical) {
    reject_file(file, "can be read in two ways, as a count with rows (--format pts) or with atoms (--format chemical)");
  }
  if (found.is_like_chemical) return PointFormat::kChemical;
  if (found.is_like_pts) return PointFormat::kPts;
  reject_file(file,
              "begins with a count, but neither rows of numbers follow, as in PTS, nor a comment and atoms, as in "
              "chemical XYZ");
}

// Whether the first line may be names of columns, and the next one has numbers.
bool has_named_columns(std::string_view text) {
  LineReader lines(text, "");
  std::string_view line;
  if (!lines.next_uncommented(line)) return false;
  const std::vector<std::string_view> names = fields_of(line, separators_of(line));
  if (names.size() < 2 || std::ranges::any_of(names, begins_as_number) || !lines.next_uncommented(line)) return false;
  const std::vector<std::string_view> row = fields_of(line, separators_of(line));
  return 2 * std::ranges::count_if(row, begins_as_number) > std::ssize(row);
}

bool has_vertex_lines(std::string_view text) {
  LineReader lines(text, "");
  for (std::string_view line, word; lines.next_uncommented(line);) {
    if (Fields(line, Separators::kBlanks).next(word) && word == "v") return true;
  }
  return false;
}

[[noreturn]] void reject_unknown(std::string_view file, std::string_view name) {
  reject_file(file,
              fmt::format("{}; these formats are read: {} (--format says one)",
                          name.empty() ? "not a known format" : fmt::format("looks like {}, which is not read", name),
                          all_names()));
}

}  // namespace

std::string_view name_of(PointFormat format) { return std::ranges::find(kFormats, format, &Format::format)->name; }

void read_as(PointFormat format, std::string_view bytes, PointRows& rows) {
  std::ranges::find(kFormats, format, &Format::format)->read(bytes, rows);
}

PointFormat format_named(std::string_view name) {
  const auto found = std::ranges::find(kFormats, name, &Format::name);
  if (found != kFormats.end()) return found->format;
  if (name == "xyz")
    throw InvalidInput("--format xyz can mean two: table (rows of numbers) or chemical (a count, a comment, atoms)");
  throw InvalidInput(fmt::format("no format {}; there are {}", in_quotes(name), all_names()));
}

PointFormat format_with_columns(std::string_view bytes) {
  return is_integer(first_line(bytes)) ? PointFormat::kPts : PointFormat::kTable;
}

PointFormat format_of_content(std::string_view bytes, std::string_view file) {
  const std::string_view line = first_line(bytes);
  const std::vector<std::string_view> words = words_of(line);
  if (bytes.starts_with("\x93NUMPY")) return PointFormat::kNpy;
  if (trimmed(first_lines(bytes, 1)[0]) == "ply") return PointFormat::kPly;
  if (words.empty()) return PointFormat::kTable;
  if (words[0] != "FIELDS" && names_axes(line)) return PointFormat::kTable;
  if (is_pcd_keyword(words[0])) return PointFormat::kPcd;
  if (const std::string_view name = unread_format(bytes); !name.empty()) reject_unknown(file, name);
  if (!off_keyword(line).empty()) return PointFormat::kOff;
  if (words.size() == 1 && lower_case(line).starts_with("data_") && line.find(',') == std::string::npos)
    return PointFormat::kCif;
  if (begins_as_pqr(bytes)) return PointFormat::kPqr;
  if (is_pdb_record(line)) return PointFormat::kPdb;
  if (is_obj_keyword(words[0]) && (words[0] == "v" || has_vertex_lines(bytes))) return PointFormat::kObj;
  if (words.size() == 1 && is_integer(words[0])) return format_after_count(bytes, file);
  if (is_chemical_atom(line) && !is_row_of_numbers(line)) {
    reject_file(file, "looks like atoms without a count above: --columns 2,3,4 reads the numbers");
  }
  // A row of a table, be it right or not, has more numbers than other fields.
  const std::vector<std::string_view> fields = fields_of(line, separators_of(line));
  const bool is_row = 2 * std::ranges::count_if(fields, begins_as_number) > std::ssize(fields);
  if (!is_row && !has_named_columns(bytes)) reject_unknown(file, "");
  return PointFormat::kTable;
}

}  // namespace flowcert::io

// ---- Reading ----
// From a name to its bytes, through gzip, to the reader of its format. CGAL::IO::read_points is not used; the readers
// say what it does with damaged files of each format.

namespace flowcert {

using namespace io;

namespace {

// An option that the format does not know is not passed over.
void check_options(PointFormat format, std::string_view file, const ReadingOptions& options) {
  const bool is_table = format == PointFormat::kTable || format == PointFormat::kPts;
  const bool is_molecule = format == PointFormat::kPdb || format == PointFormat::kPqr || format == PointFormat::kCif;
  const auto allow = [&](bool is_given, bool is_known, const char* option, const char* formats) {
    if (!is_given || is_known) return;
    reject_file(file, fmt::format("{} is for {}, and this is {}", option, formats, name_of(format)));
  };
  allow(!options.columns.empty(), is_table, "--columns", "tables");
  allow(options.z.has_value(), is_table || format == PointFormat::kNpy, "--z", "tables and NPY");
  allow(!options.chains.empty(), is_molecule, "--chains", "PDB, PQR and CIF");
  allow(!options.models.empty(), is_molecule, "--models", "PDB, PQR and CIF");
  allow(!options.atoms.empty(), is_molecule || format == PointFormat::kChemical, "--atoms",
        "PDB, PQR, CIF and chemical XYZ");
  allow(options.frame != 0, format == PointFormat::kChemical, "--frame", "chemical XYZ");
}

// Whether the format has what the radii are taken from.
void check_radii(PointFormat format, std::string_view file, const AtomRadii& radii) {
  using Source = AtomRadii::Source;
  const bool is_table = format == PointFormat::kTable || format == PointFormat::kPts;
  const bool has_elements = format == PointFormat::kPdb || format == PointFormat::kPqr || format == PointFormat::kCif ||
                            format == PointFormat::kChemical;
  const auto reject = [&](std::string_view formats) {
    reject_file(
        file, fmt::format("--radii {} is for {}, and this is {}", on_one_line(radii.text()), formats, name_of(format)));
  };
  if (radii.source() == Source::kPqr && format != PointFormat::kPqr) reject("PQR");
  if (radii.source() == Source::kColumn && !is_table) reject("tables");
  if (radii.needs_elements() && !has_elements) reject("PDB, PQR, CIF and chemical XYZ, which have elements");
}

}  // namespace

PointFile io::read_content(std::string_view bytes, const std::string& name, const ReadingOptions& options,
                           BallRows* balls) {
  const geometry::IeeeDoubles ieee;
  std::string decompressed;
  bytes = plain_content(bytes, name, decompressed, options.unlimited);
  const bool is_pqr = balls != nullptr && balls->radii().source() == AtomRadii::Source::kPqr;
  const PointFormat format = !options.format.empty()    ? format_named(options.format)
                             : is_pqr                   ? PointFormat::kPqr
                             : !options.columns.empty() ? format_with_columns(bytes)
                                                        : format_of_content(bytes, name);
  check_options(format, name, options);
  if (balls != nullptr) check_radii(format, name, balls->radii());
  PointRows rows(name, options, balls);
  read_as(format, bytes, rows);
  PointFile file = rows.take();
  file.format = name_of(format);
  return file;
}

PointFile read_points_from(std::string_view bytes, const std::string& name, const ReadingOptions& options) {
  if (options.finite) reject_file(name, "--finite is for atoms with radii, and there are none");
  return read_content(bytes, name, options, nullptr);
}

PointFile read_points(const std::string& path, const ReadingOptions& options) {
  return read_points_from(read_bytes(path, options.progress), path, options);
}

}  // namespace flowcert
