// PDB with PQR, and CIF, a section for each: the centres of atoms as points.
//
// Gemmi's readers are not used: they take "1.2.3" as 1.2 and blanks as 0, without a word, and know no line of a row.
// What is left out is counted, so that it can be said.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/atom_selection.h"
#include "io/crystal_cell.h"
#include "io/number_text.h"
#include "io/pdb_line.h"
#include "io/point_formats.h"
#include "io/pqr_line.h"

namespace flowcert::io {

// ---- PDB and PQR ----
// Fixed columns, where a line holds to them (pdb_line.h). A record MODEL begins a model, and so does the first atom
// after END, by which trajectories part their frames. PQR has the same records, and other lines for atoms.
namespace {

// Files of structures without a crystal have a cell of three times 1.
void see_cell(std::string_view line, std::size_t number, PointRows& rows) {
  const std::vector<std::string_view> words = words_of(line);
  const bool is_crystal = words.size() > 3 && std::any_of(words.begin() + 1, words.begin() + 4,
                                                          [](auto word) { return parse_number(word).value != 1; });
  if (is_crystal) rows.note(number, std::string(kCellNote));
}

void read_records(std::string_view text, PointRows& rows, PdbAtom (*atom_of)(std::string_view, const LinePlace&)) {
  AtomSelection selection(rows.options(), rows.file(), true);
  LineReader lines(text, rows.file());
  std::size_t models = 0;
  bool is_taken = false, has_begun = false;
  const auto begin_model = [&](std::string_view name) {
    ++models;
    is_taken = selection.takes_model(name.empty() ? std::to_string(models) : std::string(name));
    has_begun = true;
  };
  for (std::string_view line; lines.next(line);) {
    switch (pdb_record(line, lines.place())) {
      case PdbRecord::kModel:
        begin_model(trimmed(line.substr(std::min<std::size_t>(6, line.size()))));
        break;
      case PdbRecord::kEnd:
        has_begun = false;
        break;
      case PdbRecord::kAtom: {
        if (!has_begun) begin_model("");
        const PdbAtom atom = atom_of(line, lines.place());
        if (rows.balls() != nullptr) rows.balls()->see_radius(atom.radius);
        const bool is_wanted =
            is_taken && selection.takes({.chain = atom.chain,
                                         .residue = atom.residue,
                                         .element = atom.element,
                                         .is_hetatm = atom.is_hetatm,
                                         .location = atom.location,
                                         .residue_place = fmt::format("{} {}", models, atom.place_residue),
                                         .place = fmt::format("{} {}{}", models, atom.place_residue, atom.place_name)});
        if (is_wanted && rows.add(atom.position, lines.place())) {
          rows.name({atom.chain, atom.residue, atom.number, atom.name, atom.element}, atom.said_element);
        }
        break;
      }
      case PdbRecord::kOther:
        if (rows.balls() != nullptr && line.starts_with("CRYST1")) see_cell(line, lines.place().line, rows);
        break;
    }
  }
  selection.finish(rows);
}

}  // namespace

void read_pdb(std::string_view text, PointRows& rows) { read_records(text, rows, pdb_atom); }

void read_pqr(std::string_view text, PointRows& rows) { read_records(text, rows, pqr_atom); }

// ---- CIF ----
// A table `loop_` of the category _atom_site has a row for each atom: in mmCIF with Cartesian coordinates, in CIF of
// small molecules with Cartesian or fractional ones. Data blocks with such a table are models.
namespace {

constexpr std::string_view kRoundedNote =
    "the cell has other angles than right ones: its Cartesian positions are the nearest doubles, taken exactly";

struct CifWord {
  std::string_view text;
  bool is_quoted = false;
};

// The words, between blanks. Words in quotes and text between lines that begin with ';' are one word each. '#' starts a
// comment. Nothing is copied. Throws InvalidInput for a quote or a text that does not end.
class CifWords {
 public:
  CifWords(std::string_view text, std::string_view file) : lines_(text, file) {}

  std::optional<CifWord> next() {
    for (;;) {
      while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
      if (!rest_.empty() && rest_.front() != '#') return word_of_line();
      if (!lines_.next(rest_)) return std::nullopt;
      if (rest_.starts_with(';')) return text_field();
    }
  }
  [[nodiscard]] LinePlace place() const { return lines_.place(); }

 private:
  CifWord word_of_line() {
    const char first = rest_.front();
    if (first != '\'' && first != '"') {
      const auto end = std::ranges::find_if(rest_, is_blank);
      const auto size = static_cast<std::size_t>(end - rest_.begin());
      return {std::exchange(rest_, rest_.substr(size)).substr(0, size)};
    }
    // A quote ends where a blank follows it.
    for (std::size_t k = 1; k < rest_.size(); ++k) {
      if (rest_[k] != first || (k + 1 < rest_.size() && !is_blank(rest_[k + 1]))) continue;
      return {std::exchange(rest_, rest_.substr(k + 1)).substr(1, k - 1), true};
    }
    place().reject("a quote that does not end in its line");
  }
  CifWord text_field() {
    const LinePlace start = place();
    do {
      if (!lines_.next(rest_)) start.reject("a text field that does not end");
    } while (!rest_.starts_with(';'));
    rest_.remove_prefix(1);
    return {"text", true};  // no text is of interest
  }

  LineReader lines_;
  std::string_view rest_;
};

class CifReader {
 public:
  CifReader(std::string_view text, PointRows& rows)
      : words_(text, rows.file()), rows_(rows), selection_(rows.options(), rows.file(), true) {}

  void read() {
    std::optional<CifWord> word = words_.next();
    while (word) {
      const std::string name = word->is_quoted ? "" : lower_case(word->text);
      if (name.starts_with("data_")) {
        end_block();
        word = words_.next();
      } else if (name == "loop_") {
        word = read_loop();
      } else if (name.starts_with('_')) {
        word = read_item(name);
      } else {
        word = words_.next();
      }
    }
    end_block();
    if (!has_table_) reject_file(rows_.file(), "there is no table _atom_site with coordinates");
    selection_.finish(rows_);
  }

 private:
  using Row = std::vector<std::string_view>;

  static bool is_name(const CifWord& word) { return !word.is_quoted && word.text.starts_with('_'); }
  static bool is_end(const CifWord& word) {
    if (word.is_quoted) return false;
    const std::string text = lower_case(word.text);
    return text.starts_with('_') || text == "loop_" || text.starts_with("data_") || text.starts_with("save_");
  }

  // A name and its value. Returns the word after it.
  std::optional<CifWord> read_item(const std::string& name) {
    const std::optional<CifWord> value = words_.next();
    if (!value || is_end(*value)) return value;
    cell_.see_item(name, value->text, words_.place());
    if (in_atom_site(name) && is_coordinate(column_name(name))) {
      words_.place().reject("an atom that is not in a table loop_: " + in_quotes(name));
    }
    return words_.next();
  }

  // Returns the first word after the table.
  std::optional<CifWord> read_loop() {
    std::vector<std::string> names;
    std::optional<CifWord> word = words_.next();
    for (; word && is_name(*word); word = words_.next()) names.push_back(lower_case(word->text));
    if (!begin_table(names)) {
      for (std::size_t k = 0; word && !is_end(*word); word = words_.next(), ++k) {
        if (!names.empty()) cell_.see_item(names[k % names.size()], word->text, words_.place());
      }
      return word;
    }
    Row row;
    for (; word && !is_end(*word); word = words_.next()) {
      const bool is_unknown = !word->is_quoted && (word->text == "." || word->text == "?");
      row.push_back(is_unknown ? std::string_view() : word->text);
      if (row.size() < names.size()) continue;
      read_row(row);
      row.clear();
    }
    if (!row.empty()) words_.place().reject("the last row of the table _atom_site is not complete");
    return word;
  }

  // mmCIF writes _atom_site.id, and CIF _atom_site_label. Categories with longer names are others.
  static bool in_atom_site(const std::string& name) {
    return name.starts_with("_atom_site.") ||
           (name.starts_with("_atom_site_") && !name.starts_with("_atom_site_aniso"));
  }
  static std::string column_name(const std::string& name) {
    return name.substr(std::string_view("_atom_site.").size());
  }
  static bool is_coordinate(const std::string& column) {
    return column.starts_with("cartn_") || column.starts_with("fract_");
  }

  // Whether these are the columns of the atoms.
  bool begin_table(const std::vector<std::string>& names) {
    columns_.clear();
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (in_atom_site(names[k])) columns_[column_name(names[k])] = k;
    }
    const bool is_mmcif = std::ranges::any_of(names, [](const auto& name) { return name.starts_with("_atom_site."); });
    const bool has_coordinates =
        std::ranges::any_of(columns_, [](const auto& column) { return is_coordinate(column.first); });
    if (!is_mmcif && !has_coordinates) return false;
    is_small_ = !is_mmcif;
    for (const std::string& name : names) {
      if (!in_atom_site(name)) words_.place().reject("a column of another table: " + in_quotes(name));
    }
    if (std::exchange(block_has_table_, true)) words_.place().reject("a second table _atom_site");
    has_table_ = true;
    is_fractional_ = !columns_.contains("cartn_x") && columns_.contains("fract_x");
    for (const char* axis : {"x", "y", "z"}) {
      const std::string column = (is_fractional_ ? "fract_" : "cartn_") + std::string(axis);
      if (!columns_.contains(column))
        words_.place().reject(fmt::format("the table _atom_site has no column {}", column));
    }
    ++blocks_;
    if (!columns_.contains("pdbx_pdb_model_num")) is_taken_ = selection_.takes_model(std::to_string(blocks_));
    return true;
  }

  [[nodiscard]] std::string_view value(const Row& row, const char* name) const {
    const auto column = columns_.find(name);
    return column == columns_.end() ? std::string_view() : row[column->second];
  }
  // As the authors say, or else as the label does.
  [[nodiscard]] std::string_view value(const Row& row, const char* name, const char* other) const {
    const std::string_view first = value(row, name);
    return first.empty() ? value(row, other) : first;
  }

  // mmCIF's names, or the label of CIF of small molecules.
  [[nodiscard]] std::string_view atom_name(const Row& row) const {
    const std::string_view name = value(row, "auth_atom_id", "label_atom_id");
    return name.empty() ? value(row, "label") : name;
  }

  [[nodiscard]] ElementText element_text(const Row& row) const {
    const std::string_view symbol = value(row, "type_symbol");
    if (!symbol.empty()) return {symbol};
    const std::string_view label = value(row, "label");
    return label.empty() ? ElementText{atom_name(row), ElementSource::kName}
                         : ElementText{label, ElementSource::kLabel};
  }

  void see_model(const Row& row) {
    if (!columns_.contains("pdbx_pdb_model_num")) return;
    // A second data block's models are other models.
    const std::string model(value(row, "pdbx_pdb_model_num"));
    if (model_ && *model_ == std::pair(blocks_, model)) return;
    model_ = std::pair(blocks_, model);
    const auto [known, is_new] = models_.try_emplace(*model_, false);
    if (is_new) known->second = selection_.takes_model(blocks_ == 1 ? model : fmt::format("{}.{}", blocks_, model));
    is_taken_ = known->second;
  }

  [[nodiscard]] std::string residue_place(const Row& row) const {
    std::string place = fmt::format("{} {} ", blocks_, model_ ? model_->second : "");
    for (const char* name : {"label_asym_id", "label_seq_id", "auth_seq_id", "pdbx_pdb_ins_code"}) {
      place += std::string(value(row, name)) + ' ';
    }
    return place;
  }
  // In CIF of small molecules the groups of one assembly exclude each other.
  [[nodiscard]] std::string atom_place(const Row& row) const {
    const char* const name = value(row, "disorder_group").empty() ? "label_atom_id" : "disorder_assembly";
    return residue_place(row) + std::string(value(row, name));
  }

  // Without assemblies three groups, or one that excludes its own images, do not say what excludes what.
  void see_group(const Row& row) {
    const std::string_view group = value(row, "disorder_group");
    if (group.empty() || !value(row, "disorder_assembly").empty()) return;
    groups_.emplace(group);
    if (groups_.size() < 3 && !group.starts_with('-')) return;
    if (selection_.chooses_locations()) return;
    words_.place().reject(
        "disorder groups without assemblies: --atoms \"altloc N\" or \"altloc all\" says which are read");
  }

  void read_row(const Row& row) {
    see_model(row);
    if (!is_taken_) return;
    const ElementText element = element_text(row);
    const Atom atom{.chain = value(row, "auth_asym_id", "label_asym_id"),
                    .residue = value(row, "auth_comp_id", "label_comp_id"),
                    .element = element.source == ElementSource::kName ? "" : element_of_label(element.text),
                    .is_hetatm = value(row, "group_pdb") == "HETATM",
                    .location = value(row, "label_alt_id", "disorder_group"),
                    .residue_place = residue_place(row),
                    .place = atom_place(row)};
    see_group(row);
    if (!selection_.takes(atom)) return;
    std::array<std::string_view, 3> position;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string column = fmt::format("{}_{}", is_fractional_ ? "fract" : "cartn", "xyz"[axis]);
      position[axis] = without_uncertainty(value(row, column.c_str()));
      if (position[axis].empty()) words_.place().reject("an atom without " + column);
    }
    const std::string number =
        std::string(value(row, "auth_seq_id", "label_seq_id")) + std::string(value(row, "pdbx_pdb_ins_code"));
    const AtomName name{atom.chain, atom.residue, number, atom_name(row), atom.element};
    if (is_fractional_) {
      fractional_.push_back({position, words_.place(), element});
      fractional_names_.add(name);
    } else if (rows_.add(position, words_.place())) {
      rows_.name(name, element);
    }
  }

  // A cell may be said after the atoms, so fractional coordinates wait for the block's end.
  void end_block() {
    if (rows_.balls() != nullptr) see_periodic();
    if (!fractional_.empty()) {
      const CartesianAxes axes = cell_.cartesian_axes(rows_.file());
      if (rows_.balls() != nullptr && !axes.are_right()) rows_.note(0, std::string(kRoundedNote));
      for (std::size_t k = 0; k < fractional_.size(); ++k) {
        const auto& [position, place, element] = fractional_[k];
        if (rows_.balls() != nullptr) rows_.balls()->see_centre(axes.exact_position(position, place), place);
        if (rows_.add(axes.position(position, place))) rows_.name(fractional_names_[static_cast<PointId>(k)], element);
      }
      fractional_.clear();
      fractional_names_ = {};
    }
    cell_ = {};
    groups_.clear();
    block_has_table_ = false;
    rows_before_ = rows_.count();
  }

  // Files of macromolecules have a cell where others have none, and are read as those in PDB are.
  void see_periodic() {
    const bool is_crystal = !fractional_.empty() || (rows_.count() > rows_before_ && cell_.has_lengths());
    if (!is_crystal) return;
    if (is_small_ || !fractional_.empty()) rows_.balls()->see_crystal(0);
    rows_.note(0, std::string(kCellNote));
  }

  struct FractionalAtom {
    std::array<std::string_view, 3> position;
    LinePlace place;
    ElementText element;
  };

  CifWords words_;
  PointRows& rows_;
  AtomSelection selection_;
  CrystalCell cell_;
  std::map<std::string, std::size_t> columns_;
  bool has_table_ = false, block_has_table_ = false, is_fractional_ = false, is_taken_ = false;
  bool is_small_ = false;        // no mmCIF
  std::size_t rows_before_ = 0;  // before this block
  std::size_t blocks_ = 0;
  std::set<std::string> groups_;  // of disorder, in this block
  std::optional<std::pair<std::size_t, std::string>> model_;
  std::map<std::pair<std::size_t, std::string>, bool> models_;
  std::vector<FractionalAtom> fractional_;
  AtomNames fractional_names_;
};

}  // namespace

void read_cif(std::string_view text, PointRows& rows) { CifReader(text, rows).read(); }

}  // namespace flowcert::io
