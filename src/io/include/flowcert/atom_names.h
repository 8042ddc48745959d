// How the file of a molecule names its atoms: by chain, residue and name.
//
// Guarantees: a name is what the file says, without blanks around it, and with control characters and the like as
// \x1b; what it does not say is empty. Rows are those of PointFile, so that ids of points are places here. A name takes
// as many bytes as its text, and 13 more.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "flowcert/point_set.h"

namespace flowcert {

struct AtomName {
  std::string_view chain{}, residue{};
  std::string_view number{};  // of the residue, with its insertion code
  std::string_view atom{};
  std::string_view element{};
};

class AtomNames {
 public:
  void add(const AtomName& name);

  [[nodiscard]] std::size_t size() const { return offsets_.size() - 1; }
  [[nodiscard]] bool empty() const { return size() == 0; }
  // The views last as long as this does, and nothing is added.
  [[nodiscard]] AtomName operator[](PointId row) const;

  // "A GLY 12", and "A GLY 12 CA": the parts that are not empty. Where only the element is known, that is the text.
  [[nodiscard]] std::string residue_text(PointId row) const;
  [[nodiscard]] std::string text(PointId row) const;
  // The texts of some, each once, in the order in which they come.
  [[nodiscard]] std::vector<std::string> residue_texts(std::span<const PointId> rows) const;

 private:
  std::string fields_;  // five of each atom, each behind its length
  std::vector<std::uint64_t> offsets_ = {0};
};

}  // namespace flowcert
