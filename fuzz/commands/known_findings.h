// Findings that are known already, and which other findings they explain.
//
// Guarantees: a known finding explains another one iff both are of the same property and kind, and what is
// combinatorial of their signatures is equal: their small inputs are degenerate in the same way
// (degeneracy_signature.h).
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/campaign/campaign.h"
#include "fuzz/campaign/degeneracy_signature.h"
#include "fuzz/commands/layer.h"

namespace flowcert::commands {

class KnownFindings {
 public:
  // Paths of files of findings, of folders with such files, and of campaigns' folders. Throws InvalidInput, also for a
  // point file that names no property and kind, and fuzz::UnusableFolder.
  explicit KnownFindings(const std::vector<std::string>& paths);

  [[nodiscard]] bool is_empty() const { return known_.empty(); }
  [[nodiscard]] bool explain(const fuzz::Counterexample& finding) const;
  [[nodiscard]] std::size_t explained_of(const fuzz::Campaign& campaign) const;

 private:
  using Way = std::pair<std::string, fuzz::DegeneracySignature>;

  void add_folder(const std::string& path);
  static Way way_of(const fuzz::Counterexample& finding);

  std::set<Way> known_;
};

}  // namespace flowcert::commands
