// The cases that `generate` prints and `verify` takes answers to (src/cli/manual/cases.md): those of a run that is
// drawn (fuzz/inputs/case_stream.h), or the conformance vectors.
//
// Guarantees: a case is known by its number, from 0, and by its id, one word. An id that is damaged, or that was made
// of other cases than these, names no case. Cases of too many points (`--most-points`) are left out: the others keep
// their numbers, and the ids of such a run are its own.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flowcert/check.h"
#include "flowcert/pair_claim.h"
#include "fuzz/inputs/case_stream.h"
#include "fuzz/judge/layer.h"

namespace flowcert::judge {

struct AskedCase {
  std::size_t number = 0;
  fuzz::Input input;
};

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
  // None for cases that are drawn. It must not outlive this.
  [[nodiscard]] virtual std::unique_ptr<Truth> stored_truth(std::size_t number) const = 0;
  // The persistence pairs of a vector that has them.
  [[nodiscard]] virtual std::optional<std::vector<ListedPair>> stored_pairs(std::size_t number) const = 0;
};

[[nodiscard]] std::unique_ptr<AskedCases> drawn_cases(const fuzz::CaseRun& run);

// All but the invalid ones, of which a point file is what is wrong. `given` is the folder, empty for the usual one.
// Throws InvalidInput if the vectors cannot be used.
[[nodiscard]] std::unique_ptr<AskedCases> vectors_to_ask(const std::string& given,
                                                         std::optional<std::size_t> most_points = {});

// The cases to which the first id that is met belongs; those of the usual folder if it is a vector's. Throws
// InvalidInput, one line, if there are none.
[[nodiscard]] std::unique_ptr<AskedCases> cases_with(const std::string& id);

}  // namespace flowcert::judge
