// PDB and mmCIF, a section for each: the centres of atoms as points.
//
// Gemmi's readers are not used: they take "1.2.3" as 1.2 and blanks as 0, without a word, and know no line of a row.
// Atoms are those of the first model. Of several places of one atom (alternate locations) the first is taken. What is
// left out is counted, so that it can be said.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/line_reader.h"
#include "io/number_text.h"

namespace flowcert::io {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

// Takes atoms one by one, and those that are asked for as points.
class AtomCollector {
 public:
  AtomCollector(std::string_view file, const std::vector<std::string>& chains)
      : file_(file), chains_(chains.begin(), chains.end()) {}

  // Whether the atom is to be read. location: empty, or the name of an alternate location; atom: what its alternate
  // locations have in common.
  [[nodiscard]] bool takes(std::string_view chain, std::string_view location, const std::string& atom) {
    seen_.emplace(chain);
    if (!chains_.empty() && !chains_.contains(std::string(chain))) return false;
    if (location.empty()) return true;
    const auto [first, is_new] = first_location_.try_emplace(atom, location);
    if (is_new || first->second == location) return true;
    ++file_of_points_.other_locations;
    return false;
  }
  void add(const Point& point) { file_of_points_.rows.push_back(point); }
  void skip_model() { ++file_of_points_.other_models; }

  [[nodiscard]] PointFile take() {
    for (const std::string& chain : chains_) {
      if (!seen_.contains(chain))
        reject_file(file_, fmt::format("there is no chain {}; {}", in_quotes(chain), all_chains()));
    }
    if (file_of_points_.rows.empty()) reject_file(file_, "there are no atoms");
    return std::move(file_of_points_);
  }

 private:
  [[nodiscard]] std::string all_chains() const {
    if (seen_.empty()) return "there are no atoms";
    std::vector<std::string> shown;
    for (const std::string& chain : seen_) {
      if (shown.size() < kShownChains) shown.push_back(in_quotes(chain));
    }
    return fmt::format("there are {}{}", fmt::join(shown, ", "), shown.size() < seen_.size() ? " and others" : "");
  }

  static constexpr std::size_t kShownChains = 12;

  std::string_view file_;
  std::set<std::string> chains_, seen_;
  std::map<std::string, std::string> first_location_;
  PointFile file_of_points_;
};

}  // namespace

// ---- PDB ----
// Fixed columns: in a line ATOM or HETATM, x, y, z are the columns 31-38, 39-46 and 47-54, the chain is 22, and the
// alternate location 17. Names of atoms and residues are columns 13-16 and 18-27.
namespace {

constexpr std::size_t kLastColumn = 54;

bool is_record(std::string_view line, std::string_view name) { return trimmed(line.substr(0, 6)) == name; }

Point pdb_point(std::string_view line, const LinePlace& place) {
  std::array<double, 3> x{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string_view field = trimmed(line.substr(30 + 8 * axis, 8));
    if (field.empty()) place.reject(fmt::format("no coordinate {} in its columns", "xyz"[axis]));
    x[axis] = coordinate(field, place);
  }
  return {x[0], x[1], x[2]};
}

}  // namespace

bool is_pdb_record(std::string_view word) {
  static constexpr std::array<std::string_view, 14> kFirst = {"HEADER", "TITLE",  "COMPND", "SOURCE", "KEYWDS",
                                                              "EXPDTA", "AUTHOR", "REMARK", "CRYST1", "MODEL",
                                                              "ATOM",   "HETATM", "OBSLTE", "REVDAT"};
  return std::ranges::find(kFirst, word) != kFirst.end();
}

PointFile read_pdb(std::string_view text, std::string_view file, const std::vector<std::string>& chains) {
  AtomCollector atoms(file, chains);
  LineReader lines(text, file);
  std::string_view line;
  std::size_t models = 0;
  while (lines.next(line)) {
    if (is_record(line, "MODEL") && ++models > 1) atoms.skip_model();
    if (models > 1 || !(is_record(line, "ATOM") || is_record(line, "HETATM"))) continue;
    if (line.size() < kLastColumn) lines.place().reject("an atom's line ends before column 54");
    const std::string atom(line.substr(12, 4)), residue(line.substr(17, 10));
    if (!atoms.takes(trimmed(line.substr(21, 1)), trimmed(line.substr(16, 1)), atom + residue)) continue;
    atoms.add(pdb_point(line, lines.place()));
  }
  return atoms.take();
}

// ---- mmCIF ----
// A table `loop_` of the category _atom_site has a row for each atom, of words between blanks. Words in quotes and text
// between lines that begin with ';' are one word each. '#' starts a comment.
namespace {

class CifWords {
 public:
  CifWords(std::string_view text, std::string_view file) : lines_(text, file) {}

  struct Word {
    std::string_view text;
    bool is_quoted = false;
  };

  std::optional<Word> next() {
    for (;;) {
      while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
      if (!rest_.empty() && rest_.front() != '#') return word_of_line();
      if (!lines_.next(rest_)) return std::nullopt;
      if (rest_.starts_with(';')) return text_field();
    }
  }
  [[nodiscard]] LinePlace place() const { return lines_.place(); }

 private:
  Word word_of_line() {
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
  Word text_field() {
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

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

constexpr std::string_view kCategory = "_atom_site.";

// A place for each column that is of interest.
class AtomSiteReader {
 public:
  AtomSiteReader(std::string_view text, std::string_view file, const std::vector<std::string>& chains)
      : words_(text, file), atoms_(file, chains), file_(file) {}

  PointFile read() {
    std::optional<CifWords::Word> word = words_.next();
    while (word) {
      const bool is_loop = !word->is_quoted && lower_case(word->text) == "loop_";
      word = words_.next();
      if (!is_loop || !word || !is_name(*word) || !lower_case(word->text).starts_with(kCategory)) continue;
      word = read_table(*word);
    }
    if (!has_table_) reject_file(file_, "there is no table _atom_site");
    return atoms_.take();
  }

 private:
  using Word = CifWords::Word;

  static bool is_name(const Word& word) { return !word.is_quoted && word.text.starts_with('_'); }
  static bool is_end(const Word& word) {
    if (word.is_quoted) return false;
    const std::string text = lower_case(word.text);
    return text.starts_with('_') || text == "loop_" || text.starts_with("data_") || text.starts_with("save_");
  }

  // Returns the first word after the table.
  std::optional<Word> read_table(Word first) {
    if (std::exchange(has_table_, true)) words_.place().reject("a second table _atom_site");
    std::optional<Word> word = first;
    for (; word && is_name(*word); word = words_.next()) {
      const std::string name = lower_case(word->text);
      if (!name.starts_with(kCategory)) words_.place().reject("a column of another table: " + in_quotes(word->text));
      columns_[name.substr(kCategory.size())] = count_++;
    }
    for (const char* name : {"cartn_x", "cartn_y", "cartn_z"}) {
      if (!columns_.contains(name)) words_.place().reject(fmt::format("the table _atom_site has no column {}", name));
    }
    std::vector<std::string_view> row;
    for (; word && !is_end(*word); word = words_.next()) {
      const bool is_unknown = !word->is_quoted && (word->text == "." || word->text == "?");
      row.push_back(is_unknown ? std::string_view() : word->text);
      if (row.size() < count_) continue;
      read_row(row);
      row.clear();
    }
    if (!row.empty()) words_.place().reject("the last row of the table _atom_site is not complete");
    return word;
  }

  [[nodiscard]] std::string_view value(const std::vector<std::string_view>& row, const char* name) const {
    const auto column = columns_.find(name);
    return column == columns_.end() ? std::string_view() : row[column->second];
  }
  // As the authors say, or else as the label does.
  [[nodiscard]] std::string_view value(const std::vector<std::string_view>& row, const char* name,
                                       const char* other) const {
    const std::string_view first = value(row, name);
    return first.empty() ? value(row, other) : first;
  }

  void read_row(const std::vector<std::string_view>& row) {
    const std::string model(value(row, "pdbx_pdb_model_num"));
    if (models_.insert(model).second && models_.size() > 1) atoms_.skip_model();
    if (!first_model_) first_model_ = model;
    if (model != *first_model_) return;
    std::string atom;
    for (const char* name :
         {"label_atom_id", "label_comp_id", "label_asym_id", "label_seq_id", "auth_seq_id", "pdbx_pdb_ins_code"}) {
      atom += std::string(value(row, name)) + ' ';
    }
    if (!atoms_.takes(value(row, "auth_asym_id", "label_asym_id"), value(row, "label_alt_id"), atom)) return;
    std::array<double, 3> x{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      static constexpr std::array<const char*, 3> kNames = {"cartn_x", "cartn_y", "cartn_z"};
      const std::string_view field = value(row, kNames[axis]);
      if (field.empty()) words_.place().reject(fmt::format("an atom without {}", kNames[axis]));
      x[axis] = coordinate(field, words_.place());
    }
    atoms_.add({x[0], x[1], x[2]});
  }

  CifWords words_;
  AtomCollector atoms_;
  std::string_view file_;
  std::map<std::string, std::size_t> columns_;
  std::size_t count_ = 0;
  bool has_table_ = false;
  std::set<std::string> models_;
  std::optional<std::string> first_model_;
};

}  // namespace

PointFile read_mmcif(std::string_view text, std::string_view file, const std::vector<std::string>& chains) {
  return AtomSiteReader(text, file, chains).read();
}

}  // namespace flowcert::io
