// Tables of numbers, and PTS: a row of columns for each point.
//
// CGAL's reader takes no commas, no hexadecimal floats and no fourth column, and silently skips a leading count. Other
// libraries take what they find first for x, y, z. Here columns have to be known: by names, by --columns, or because
// the first three can be nothing else. Rows of different lengths are refused, because a number that a blank cuts in
// two moves all that follow it. Source: spec clauses FC-FILE-01, FC-FILE-38, FC-FILE-39.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
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

// A comma that may be a decimal point: digits on both its sides, and others or blanks alone between three numbers.
bool has_decimal_comma(std::string_view line, std::size_t fields) {
  const auto commas = static_cast<std::size_t>(std::ranges::count(line, ','));
  if (commas == 0) return false;
  std::size_t between_digits = 0, before_blanks = 0;
  for (std::size_t k = 1; k + 1 < line.size(); ++k) {
    if (line[k] != ',') continue;
    before_blanks += is_blank(line[k + 1]) ? 1 : 0;
    between_digits += is_digit(line[k - 1]) && is_digit(line[k + 1]) ? 1 : 0;
  }
  if (between_digits == 0) return false;
  return fields > commas + 1 || (before_blanks > 0 && fields >= between_digits + 3);
}

// Whether the first of more than three columns can only be a name of the rows: integers that are all different, while
// one of the next three is written with a point. Above them a line may have their number, as in TetGen's files.
class FirstColumn {
 public:
  void see(const std::vector<std::string_view>& fields) {
    const std::string_view first = fields[0];
    if (rows_++ == 0) above_ = first;
    is_integer_ = is_integer_ && is_integer(first);
    if (is_integer_ && !seen_.insert(first).second) is_integer_ = !std::exchange(is_repeated_, true) && first == above_;
    if (!is_integer_) seen_.clear();
    for (std::size_t k = 1; k < 4; ++k) has_fractions_ = has_fractions_ || fields[k].find('.') != std::string::npos;
  }
  [[nodiscard]] bool may_stop() const { return !is_integer_; }
  [[nodiscard]] bool names_rows() const {
    return is_integer_ && has_fractions_ && (!is_repeated_ || above_ == std::to_string(rows_ - 1));
  }

 private:
  std::unordered_set<std::string_view> seen_;
  std::string_view above_;
  std::size_t rows_ = 0;
  bool is_integer_ = true, is_repeated_ = false, has_fractions_ = false;
};

class TableReader {
 public:
  TableReader(std::string_view text, PointRows& rows) : lines_(text, rows.file()), rows_(rows) {
    const ReadingOptions& options = rows.options();
    if (!options.columns.empty()) chosen_.emplace(options.columns, options.z ? 2U : 3U);
    if (options.z) z_ = fmt::format("{:a}", *options.z);
    if (rows.balls() != nullptr && rows.balls()->radii().source() == AtomRadii::Source::kColumn) {
      radius_ = rows.balls()->radii().column() - 1;
    }
  }

  void read() {
    for (std::string_view line; lines_.next(line);) {
      if (const auto comment = comment_of(line)) {
        if (first_count_ == 0) see_comment(*comment);
      } else if (line = without_comment(line); !is_all_blank(line)) {
        see_line(line);
      }
    }
    finish();
  }

  // PTS: blocks of a count and as many rows.
  void read_blocks() {
    is_pts_ = true;
    for (std::string_view line; next_of_block(line);) {
      const std::vector<std::string_view> words = words_of(line);
      if (words.size() != 1) lines_.place().reject("a count of rows is missing, or there are more rows than announced");
      const std::uint64_t count = written_count(words[0], lines_.place());
      rows_.reserve(count, lines_.rest().size(), 6);
      for (std::uint64_t row = 0; row < count; ++row) {
        if (!next_of_block(line)) reject_missing(lines_.file(), count, "points", row);
        see_line(line);
      }
    }
    finish();
  }

 private:
  bool next_of_block(std::string_view& line) {
    while (lines_.next_filled(line)) {
      const auto comment = comment_of(line);
      if (!comment) return true;
      if (first_count_ == 0) see_comment(*comment);
    }
    return false;
  }

  void finish() const {
    if (first_column_ && first_column_->names_rows()) {
      reject_file(lines_.file(),
                  fmt::format("{} columns without names, of which the first may be numbers of the rows: --columns "
                              "2,3,4 takes the next three, --columns 1,2,3 the first",
                              first_count_));
    }
    if (rows_.count() > 1 && begins_with_numbers_) {
      reject_file(lines_.file(),
                  "the first row is 0,1,2, as some programs name columns: leave it out if it is no point");
    }
  }

  void see_comment(std::string_view text) { commented_.push_back({text, lines_.place()}); }

  void see_line(std::string_view line) {
    const Separators separators = separators_of(line);
    fields_ = fields_of(line, separators);
    if (!fields_.empty() && first_count_ == 0 && !is_pts_ && !heading_ && is_heading()) {
      heading_ = line;
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
    see_numbers(line, row);
    if (radius_) rows_.balls()->see_radius(fields_[*radius_]);
    rows_.add(row, lines_.place());
  }

  // Whether a first row 0,1,2 is above rows that all have points.
  void see_numbers(std::string_view line, const std::array<std::string_view, 3>& row) {
    const auto has_point = [](std::string_view field) { return field.find('.') != std::string_view::npos; };
    if (rows_.count() == 0) {
      begins_with_numbers_ =
          row[0] == "0" && row[1] == "1" && row[2] == "2" && line.find_first_of(",;\t") != std::string_view::npos;
    } else if (begins_with_numbers_) {
      begins_with_numbers_ = std::ranges::all_of(row, has_point);
    }
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
      if (z_ && names->has_axes(3)) reject("--z is for two columns, and one of these is named z");
      for (const std::size_t axis : {0U, 1U, 2U}) {
        if (axis == 2 && z_) break;
        places_[axis] = *names->find({&"xyz"[axis], 1}, lines_.place());
      }
    } else {
      see_first_row_without_names();
    }
    const auto end = places_.begin() + axes();
    if (radius_ && std::find(places_.begin(), end, *radius_) != end) {
      reject(
          fmt::format("column {} is a coordinate, and --radii takes it for the radius: --columns says which are x, "
                      "y, z",
                      *radius_ + 1));
    }
    const std::size_t needed = std::max(*std::max_element(places_.begin(), end), radius_.value_or(0)) + 1;
    if (names && names->is_open) least_ = std::max(needed, names->names.size());
    if (first_count_ < needed) {
      reject(fmt::format("{} column{}, and column {} is wanted", first_count_, first_count_ == 1 ? "" : "s", needed));
    }
  }

  void see_first_row_without_names() {
    if (heading_ && !z_ && has_two_axes_) reject("columns x and y, and none named z: --z 0 makes it 0");
    if (heading_) reject("the columns above have names, and not x, y and z: --columns says which they are");
    places_ = {0, 1, 2};
    // Beside the radius.
    const std::size_t count = first_count_ - (radius_ && first_count_ > 0 ? 1 : 0);
    if (count == 2 && !z_) reject("two columns, and points have three coordinates: --z 0 makes their z 0");
    if (count != 2 && z_) reject(fmt::format("--z is for two columns, and this row has {}", count));
    if (count == 1) reject("too few numbers: 1 of 3");
    if (count <= 3) return;
    first_column_.emplace();
    const std::string also = radius_ ? fmt::format(" but for the radius in {}", *radius_ + 1) : "";
    rows_.note(lines_.place().line, fmt::format("more than three columns; those after the third are ignored{}", also));
  }

  [[nodiscard]] std::ptrdiff_t axes() const { return z_ ? 2 : 3; }

  // The list in a text that has as many names as the first row has columns, and those that are wanted.
  [[nodiscard]] std::optional<ColumnNames> names_in(std::string_view text) {
    for (const ColumnNames& list : lists_of_names(text)) {
      if (!list.fits(first_count_)) continue;
      has_two_axes_ = has_two_axes_ || list.has_axes(2);
      if (chosen_ || list.has_axes(static_cast<std::size_t>(axes()))) return list;
    }
    return std::nullopt;
  }

  // The names above the first row. Nobody needs them who says columns by numbers.
  [[nodiscard]] std::optional<ColumnNames> names_of_columns() {
    if (chosen_ && !chosen_->are_names()) return std::nullopt;
    if (heading_) {
      const std::vector<ColumnNames> lists = lists_of_names(*heading_);
      if (std::ranges::none_of(lists, [&](const ColumnNames& list) { return list.fits(first_count_); })) {
        reject(fmt::format("{} columns, and {} names above: --columns says by number which are x, y, z", first_count_,
                           lists[0].names.size()));
      }
      if (auto names = names_in(*heading_)) return names;
    }
    std::optional<ColumnNames> names;
    for (const auto& [text, place] : commented_) {
      const std::optional<ColumnNames> found = names_in(text);
      if (found && names && *names != *found) {
        place.reject("two comments above name columns: --columns says by number which are x, y, z");
      }
      if (found) names = found;
      if (found || chosen_ || !names_other_columns(text, first_count_)) continue;
      place.reject("this seems to name columns, but not all of them: --columns says by number which are x, y, z");
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
  std::optional<std::size_t> radius_;  // the column of radii, from 0
  std::optional<std::string_view> heading_;
  struct Comment {
    std::string_view text;
    LinePlace place;
  };
  std::vector<Comment> commented_;
  std::vector<std::string_view> fields_;
  bool is_pts_ = false;
  std::size_t first_count_ = 0;  // columns of the first row; 0 before it
  std::size_t least_ = 0;        // columns of a row at the least; 0: as many as the first row has
  bool has_two_axes_ = false, begins_with_numbers_ = false;
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
