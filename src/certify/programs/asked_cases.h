// The cases that `generate` prints and `verify` takes answers to (src/cli/manual/cases.md): the conformance
// vectors, or those of a run that is drawn elsewhere (fuzz/judge/drawn_cases.h).
//
// Guarantees: a case is known by its number, from 0, and by its id, one word. An id that is damaged, or that was made
// of other cases than these, names no case. Cases of too many points (`--most-points`) are left out: the others keep
// their numbers, and the ids of such a run are its own.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/layer.h"
#include "certify/programs/vector_cases.h"
#include "flowcert/point_set.h"

namespace flowcert::certify {

struct AskedCase {
  std::size_t number = 0;
  std::vector<Point> rows;
};

// The shortest decimals that read back to the same doubles, or hexadecimal floats.
enum class NumberForm { kDecimal, kHexadecimal };
// A line for each row, as a point file has it.
[[nodiscard]] std::string points_text(const std::vector<Point>& rows, NumberForm form);
// A line "case ID ROWS", and the rows.
[[nodiscard]] std::string case_text(const std::string& id, const std::vector<Point>& rows, NumberForm form);

class AskedCases {
 public:
  virtual ~AskedCases() = default;

  // With those that are left out.
  [[nodiscard]] virtual std::size_t size() const = 0;
  // The most points that a case may have, if any are left out.
  [[nodiscard]] virtual std::optional<std::size_t> most_points() const = 0;
  [[nodiscard]] bool asks(const AskedCase& one) const;
  // The numbers of those that are not left out, ascending. It draws all cases. Throws InvalidInput if there is none.
  [[nodiscard]] std::vector<std::size_t> asked_numbers() const;
  // "500 cases, level 1, seed 7"
  [[nodiscard]] virtual std::string description() const = 0;

  // Throws InvalidInput, one line, if there is no such case.
  [[nodiscard]] virtual AskedCase named(const std::string& id) const = 0;
  [[nodiscard]] virtual std::string id(const AskedCase& one) const = 0;
  [[nodiscard]] virtual AskedCase numbered(std::size_t number) const = 0;

  // The name of a case's family. The family of a vector is its group.
  [[nodiscard]] virtual std::string family(std::size_t number) const = 0;
  // In the order in which reports list them.
  [[nodiscard]] virtual std::vector<std::string> families() const = 0;
  // Only vectors have flags.
  [[nodiscard]] virtual std::vector<std::string> flags(std::size_t number) const = 0;
  [[nodiscard]] virtual std::vector<std::string> flags() const = 0;

  // A name for files, without an ending.
  [[nodiscard]] virtual std::string file_name(std::size_t number) const = 0;
  // The options of generate that ask these cases: "--level 1 --seed 7".
  [[nodiscard]] virtual std::string run_options() const = 0;
  // The command that prints a case again, or all of them if there is no number.
  [[nodiscard]] std::string generate_command(std::optional<std::size_t> number) const;
  // The command that prints the points of a case as a point file.
  [[nodiscard]] std::string points_command(std::size_t number) const;

  // Whether the cases are vectors, which say what is right.
  [[nodiscard]] virtual bool is_stored() const = 0;
  // The vector, or nullptr of a case that is drawn. It must not outlive this.
  [[nodiscard]] virtual const VectorCase* stored(std::size_t number) const = 0;

 protected:
  [[noreturn]] static void reject_name(const std::string& id);
  [[noreturn]] static void reject_other_run(const std::string& id);
  // "", or ", without those of more than 8 points"
  [[nodiscard]] std::string what_is_left_out() const;
  // "", or " --most-points 8"
  [[nodiscard]] std::string most_points_option() const;
};

inline constexpr std::string_view kVectorPrefix = "vector:";  // of ids

// The cases of the drawn run to which an id belongs; null if it belongs to none.
using DrawnCasesOf = std::function<std::unique_ptr<AskedCases>(const std::string& id)>;

// All but the invalid ones, of which a point file is what is wrong. `given` is the folder, empty for the usual one.
// Throws InvalidInput if the vectors cannot be used.
[[nodiscard]] std::unique_ptr<AskedCases> vectors_to_ask(const std::string& given, const DrawnCasesOf& drawn,
                                                         std::optional<std::size_t> most_points = {});

// The cases to which the first id that is met belongs; those of the usual folder if it is a vector's. Throws
// InvalidInput, one line, if there are none.
[[nodiscard]] std::unique_ptr<AskedCases> cases_with(const std::string& id, const DrawnCasesOf& drawn);

}  // namespace flowcert::certify
