// Tables of numbers, and PTS: a row of columns for each point.
//
// CGAL's reader takes no commas, no hexadecimal floats and no fourth column, and silently skips a leading count. Other
// libraries take what they find first for x, y, z. Here columns have to be known: by names, by --columns, or because
// the first three can be nothing else. Rows of different lengths are refused, because a number that a blank cuts in
// two moves all that follow it. Source: spec clauses FC-FILE-01, FC-FILE-38, FC-FILE-39.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "io/number_text.h"
#include "io/point_formats.h"
#include "io/table_columns.h"

namespace flowcert::io {

namespace {

// The text of a comment that takes a whole line.
std::optional<std::string_view> comment_of(std::string_view line) {
  line = trimmed(line);
  if (line.starts_with("//")) return line.substr(2);
  if (!line.starts_with('#')) return std::nullopt;
  return line.substr(std::min(line.find_first_not_of('#'), line.size()));
}

// A comma that may be a decimal point: digits on both its sides, and blanks alone between other numbers.
bool has_decimal_comma(std::string_view line, std::size_t fields) {
  const auto commas = static_cast<std::size_t>(std::ranges::count(line, ','));
  if (commas == 0 || fields <= commas + 1) return false;
  for (std::size_t k = 1; k + 1 < line.size(); ++k) {
    if (line[k] == ',' && is_digit(line[k - 1]) && is_digit(line[k + 1])) return true;
  }
  return false;
}

// Whether the first of more than three columns can only be a name of the rows: integers that are all different, while
// one of the next three has fractions.
class FirstColumn {
 public:
  void see(const std::vector<std::string_view>& fields) {
    const std::string_view first = fields[0];
    is_integer_ = is_integer_ && is_integer(first) && seen_.insert(first).second;
    if (!is_integer_) seen_.clear();
    for (std::size_t k = 1; k < 4; ++k) has_fractions_ = has_fractions_ || is_fraction(fields[k]);
  }
  [[nodiscard]] bool may_stop() const { return !is_integer_; }
  [[nodiscard]] bool names_rows() const { return is_integer_ && has_fractions_; }

 private:
  static bool is_fraction(std::string_view field) {
    const NumberText number = coordinate_of(field);
    return number.fault == nullptr && number.value != std::floor(number.value);
  }

  std::unordered_set<std::string_view> seen_;
  bool is_integer_ = true;
  bool has_fractions_ = false;
};

class TableReader {
 public:
  TableReader(std::string_view text, PointRows& rows) : lines_(text, rows.file()), rows_(rows) {
    const ReadingOptions& options = rows.options();
    if (!options.columns.empty()) chosen_.emplace(options.columns, options.z ? 2U : 3U);
    if (options.z) z_ = fmt::format("{:a}", *options.z);
  }

  void read() {
    for (std::string_view line; lines_.next(line);) {
      if (const auto comment = comment_of(line)) {
        if (first_count_ == 0) see_comment(*comment);
      } else if (line = line.substr(0, line.find('#')); !is_all_blank(line)) {
        see_line(line);
      }
    }
    if (!first_column_ || !first_column_->names_rows()) return;
    reject_file(lines_.file(),
                fmt::format("{} columns without names, of which the first may be numbers of the rows: --columns 2,3,4 "
                            "takes the next three, --columns 1,2,3 the first",
                            first_count_));
  }

  // PTS: blocks of a count and as many rows, without comments or names.
  void read_blocks() {
    std::string_view line;
    while (lines_.next_filled(line)) {
      const std::vector<std::string_view> words = words_of(line);
      if (words.size() != 1) lines_.place().reject("a count of rows is missing, or there are more rows than announced");
      const std::uint64_t count = announced_count(words[0], lines_.place());
      rows_.reserve(count, lines_.rest().size(), 6);
      for (std::uint64_t row = 0; row < count; ++row) {
        if (!lines_.next_filled(line)) reject_missing(lines_.file(), count, "points", row);
        is_pts_ = true;
        see_line(line);
      }
    }
  }

 private:
  void see_comment(std::string_view text) {
    const ColumnNames names(text);
    const bool is_asked = chosen_ && chosen_->are_names();
    // A list between blanks has to have as many names as the first row has columns, which is not known yet.
    if (!names.has_xyz() && !(is_asked && names.size() >= 2 && names.words() == names.size())) return;
    commented_.push_back(names);
  }

  void see_line(std::string_view line) {
    const Separators separators = separators_of(line);
    fields_ = fields_of(line, separators);
    if (!fields_.empty() && first_count_ == 0 && !is_pts_ && !heading_ && is_heading()) {
      heading_.emplace(line);
      return;
    }
    if (first_count_ == 0) see_first_row();
    check_length();
    if (separators == Separators::kBlanksAndCommas && has_decimal_comma(line, fields_.size())) {
      reject("a comma between digits, and blanks alone between other numbers: is it a decimal point?");
    }
    if (first_column_) {
      first_column_->see(fields_);
      if (first_column_->may_stop()) first_column_.reset();
    }
    std::array<std::string_view, 3> row;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      row[axis] = axis == 2 && z_ ? std::string_view(*z_) : fields_[places_[axis]];
      if (row[axis].find(',') != std::string_view::npos)
        reject("a decimal comma: " + in_quotes(row[axis]) + "; numbers have a point");
    }
    rows_.add(row, lines_.place());
  }

  // Whether the line has names instead of numbers.
  [[nodiscard]] bool is_heading() const {
    return std::ranges::all_of(
        fields_, [](std::string_view field) { return !begins_as_number(field) && parse_number(field).is_finite; });
  }

  void see_first_row() {
    first_count_ = fields_.size();
    const std::optional<ColumnNames> names = names_of_columns();
    if (chosen_) {
      places_ = chosen_->places(names, lines_.place());
    } else if (names) {
      for (std::size_t axis = 0; axis < 3; ++axis) places_[axis] = *names->find({&"xyz"[axis], 1}, lines_.place());
    } else {
      see_first_row_without_names();
    }
    needed_ = *std::max_element(places_.begin(), places_.begin() + (z_ ? 2 : 3)) + 1;
    // COLMAP's last column is a list; the names before it are columns of every row.
    if (names && !chosen_ && names->words() < names->size()) least_ = std::max(needed_, names->words());
    if (chosen_) least_ = needed_;
    if (first_count_ < needed_) {
      reject(fmt::format("{} column{}, and column {} is wanted", first_count_, first_count_ == 1 ? "" : "s", needed_));
    }
  }

  void see_first_row_without_names() {
    if (heading_) reject("the columns above have names, and none of x, y, z: --columns says which they are");
    places_ = {0, 1, 2};
    if (first_count_ == 2 && !z_) reject("two columns, and points have three coordinates: --z 0 makes their z 0");
    if (first_count_ != 2 && z_) reject(fmt::format("--z is for two columns, and this row has {}", first_count_));
    if (first_count_ == 1) reject("too few numbers: 1 of 3");
    if (first_count_ > 3 && !is_pts_) first_column_.emplace();
    if (first_count_ > 3) rows_.note(lines_.place().line, "more than three columns; those after the third are ignored");
  }

  // The names above the first row, where there are as many as it has columns.
  [[nodiscard]] std::optional<ColumnNames> names_of_columns() const {
    if (heading_) {
      if (heading_->size() != first_count_) {
        reject(fmt::format("{} columns, and {} names above: --columns says by number which are x, y, z", first_count_,
                           heading_->size()));
      }
      if (heading_->has_xyz() || (chosen_ && chosen_->are_names())) return heading_;
      if (!chosen_) return std::nullopt;
    }
    std::optional<ColumnNames> names;
    for (const ColumnNames& candidate : commented_) {
      if (candidate.is_blank_separated() && candidate.size() != first_count_) continue;
      if (names && *names != candidate)
        reject("two comments above name columns: --columns says by number which are x, y, z");
      names = candidate;
    }
    return names;
  }

  void check_length() const {
    const bool is_right = least_ > 0 ? fields_.size() >= least_ : fields_.size() == first_count_;
    if (is_right) return;
    if (fields_.size() < 3) reject(fmt::format("too few numbers: {} of 3", fields_.size()));
    if (least_ > 0) reject(fmt::format("{} columns, and rows have {} at least", fields_.size(), least_));
    reject(fmt::format("{} columns, and the first row has {}", fields_.size(), first_count_));
  }

  [[noreturn]] void reject(const std::string& reason) const { lines_.place().reject(reason); }

  LineReader lines_;
  PointRows& rows_;
  std::optional<ChosenColumns> chosen_;
  std::optional<std::string> z_;
  std::optional<ColumnNames> heading_;
  std::vector<ColumnNames> commented_;
  std::vector<std::string_view> fields_;
  bool is_pts_ = false;
  std::size_t first_count_ = 0;  // columns of the first row; 0 before it
  // How many columns a row has to have. least_ 0: as many as the first row.
  std::size_t needed_ = 3, least_ = 0;
  ColumnPlaces places_{};
  std::optional<FirstColumn> first_column_;
};

}  // namespace

void read_table(std::string_view text, PointRows& rows) { TableReader(text, rows).read(); }

void read_pts(std::string_view text, PointRows& rows) { TableReader(text, rows).read_blocks(); }

bool is_row_of_numbers(std::string_view line) {
  const std::vector<std::string_view> fields = fields_of(line, separators_of(line));
  return fields.size() >= 3 && std::all_of(fields.begin(), fields.begin() + 3,
                                           [](std::string_view field) { return coordinate_of(field).is_number(); });
}

}  // namespace flowcert::io
