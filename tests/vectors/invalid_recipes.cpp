// The table of recipes, third part: what has to be refused.
#include "oracle/read_points.h"
#include "tests/vectors/recipes.h"

namespace oracle::vectors {

namespace {

// Makes the group, case by case. Rows and aims are lists of words, parted by blanks.
class InvalidWriter {
 public:
  InvalidWriter(const char* name, const char* title, const char* clauses) {
    group_.name = name;
    group_.title = title;
    group_.clauses = fields(clauses);
  }

  void points(std::size_t number, const char* comment, const char* aim,
              std::initializer_list<const char*> rows) {
    InvalidRecipe& recipe = add(number, comment, aim);
    for (const char* row : rows) recipe.points.push_back(fields(row));
  }
  // A word in place of a coordinate of the second of three points.
  void word(std::size_t number, const char* comment, const char* aim, const std::string& word) {
    points(number, comment, aim,
           {"0x0p+0 0x0p+0 0x0p+0", ("0x1p+0 " + word + " 0x0p+0").c_str(), "0x0p+0 0x1p+1 0x0p+0"});
  }
  void text(std::size_t number, const char* comment, const char* aim, const char* text) {
    add(number, comment, aim).text = text;
  }
  // Of an orbit around two points.
  void start(std::size_t number, const char* comment, const std::string& aim, const char* start) {
    points(number, comment, ("bad-start " + aim).c_str(), {"0x0p+0 0x0p+0 0x0p+0", "0x1p+0 0x0p+0 0x0p+0"});
    group_.invalid_recipes.back().start = fields(start);
  }

  [[nodiscard]] const Group& group() const { return group_; }

 private:
  InvalidRecipe& add(std::size_t number, const char* comment, const char* aims) {
    InvalidRecipe& recipe = group_.invalid_recipes.emplace_back();
    recipe.id = case_id(group_.name, number);
    recipe.comment = comment;
    recipe.aims = fields(aims);
    return recipe;
  }

  Group group_;
};

Group invalid_input() {
  InvalidWriter cases("invalid-input", "What has no answer, and has to be refused as a whole",
                      "FC-IN-01 FC-IN-05");
  cases.word(1, "NaN", "not-finite", "nan");
  cases.word(2, "NaN, in capitals", "not-finite", "NaN");
  cases.word(3, "NaN with a sign", "not-finite", "-nan");
  cases.word(4, "infinity", "not-finite", "inf");
  cases.word(5, "minus infinity", "not-finite", "-inf");
  cases.word(6, "infinity, in full", "not-finite", "Infinity");
  cases.word(7, "a decimal beyond the largest double", "overflow", "1e309");
  cases.word(8, "far beyond, negative", "overflow", "-1e99999");
  cases.word(9, "the decimal halfway to the next power of two, which rounds to infinity", "overflow",
             "179769313486231580793728971405303415079934132710037826936173778980444968292764750946649017"
             "977587207096330286416692887910946555547851940402630657488671505820681908902000708383676273"
             "854845817711531764475730270069855571366959622842914819860834936475292719074168444365510704"
             "342711559699508093042880177904174497792");
  cases.word(10, "a hexadecimal float beyond the largest double", "overflow", "0x1p+1024");
  cases.word(11, "a hexadecimal float of 56 bits", "inexact-hex", "0x1.00000000000001p+0");
  cases.word(12, "a hexadecimal float below the smallest subnormal", "inexact-hex", "0x1p-1075");
  cases.word(13, "a word", "no-number", "one");
  cases.word(14, "a number with letters behind it", "no-number", "1.5m");
  cases.word(15, "two points in a number", "no-number", "1.2.3");
  cases.word(16, "an exponent without digits", "no-number", "1e");
  cases.word(17, "two signs", "no-number", "--1");
  cases.word(18, "a sign alone", "no-number", "-");
  cases.word(19, "a hexadecimal float without digits", "no-number", "0x");
  cases.word(20, "a fraction: point files have none", "no-number", "1/2");
  cases.points(21, "two numbers in the first row", "short-row", {"0x0p+0 0x0p+0", "0x1p+0 0x0p+0 0x0p+0"});
  cases.points(22, "two numbers in the last row", "short-row", {"0x1p+0 0x0p+0 0x0p+0", "0x0p+0 0x0p+0"});
  cases.points(23, "one number", "short-row", {"0x1p+0"});
  cases.points(24, "NaN in the last of many rows: no part is used", "not-finite",
               {"0 0 0", "1 0 0", "0 1 0", "0 0 1", "1 1 0", "1 0 1", "0 1 1", "1 1 nan"});
  cases.text(25, "no byte", "nothing-to-read", "");
  cases.text(26, "blanks and line ends", "nothing-to-read", " \t\n\n  \n");
  cases.text(27, "nothing between two commas", "no-number", "0,0,0\n1,,0\n");
  cases.text(28, "cut short in the last row", "short-row", "0 0 0\n1 0 0\n0 1");
  cases.start(29, "NaN", "not-finite", "nan 0 0");
  cases.start(30, "infinity", "not-finite", "0 0 inf");
  cases.start(31, "beyond the largest double", "overflow", "0 1e309 0");
  cases.start(32, "a division by zero", "not-finite", "1/0 0 0");
  cases.start(33, "two coordinates", "short-row", "1 2");
  cases.start(34, "a word", "no-number", "0 x 0");
  cases.start(35, "a fraction without a denominator", "no-number", "1/ 0 0");
  cases.start(36, "a hexadecimal float of 56 bits", "inexact-hex", "0x1.00000000000001p+0 0 0");
  return cases.group();
}

}  // namespace

void add_invalid_groups(std::vector<Group>& table) { table.push_back(invalid_input()); }

}  // namespace oracle::vectors
