// Which atoms of a molecule are points: by chains, by models, by alternate locations, and by words that people know.
//
// Guarantees: an atom is one of protein, nucleic acid, water or ligand by the name of its residue alone, from tables in
// atom_selection.cpp; it is a hydrogen by its element. Without words all atoms are taken (src/cli/manual/atoms.md).
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "io/layer.h"
#include "io/point_rows.h"

namespace flowcert::io {

enum class AtomKind { kProtein, kNucleic, kWater, kLigand };

// By the name of a residue, in any case; whatever no table has is a ligand.
[[nodiscard]] AtomKind kind_of_residue(std::string_view name);

struct Atom {
  std::string_view chain = {};
  std::string_view residue = {};
  std::string_view element = {};  // as "C" or "FE"; empty where it is not known
  bool is_hetatm = false;
  // The name of an alternate location, or empty; what the locations of one residue have in common, and of one atom.
  std::string_view location = {};
  std::string residue_place = {}, place = {};
};

// The element at the front of a label, as "C" of "C12"; "H" of the atomic number 1.
[[nodiscard]] std::string_view element_of_label(std::string_view label);

class AtomSelection {
 public:
  // has_residues: not in chemical XYZ, where only words for elements mean something. Throws InvalidInput for words that
  // are none.
  AtomSelection(const ReadingOptions& options, std::string_view file, bool has_residues);

  // Whether the atoms of this model are read; `name` as the file has it. Called once for each model.
  [[nodiscard]] bool takes_model(const std::string& name);
  // Whether the user said which alternate locations are read.
  [[nodiscard]] bool chooses_locations() const { return takes_all_locations_ || !location_.empty(); }
  // Whether the atom is a point.
  [[nodiscard]] bool takes(const Atom& atom);
  // Notes what was left out and what is among the atoms. Throws InvalidInput where a chain or a model that was asked
  // for is not there, or where there are no atoms.
  void finish(PointRows& rows);

 private:
  enum class Word { kAll, kProtein, kNucleic, kWater, kLigands, kHydrogens, kHetatm, kChain };
  struct Rule {
    Word word = Word::kAll;
    std::string chain = {};
    bool takes_away = false;
  };

  void add_word(std::string_view text);
  void add_rule(std::string_view word, std::string_view argument, bool takes_away);
  [[nodiscard]] bool is_chosen(const Atom& atom) const;
  [[nodiscard]] bool takes_location(const Atom& atom);
  void tell_kinds(PointRows& rows) const;

  std::string_view file_;
  bool has_residues_;
  std::vector<Rule> rules_;
  std::set<std::string> chains_, seen_chains_, models_;
  std::vector<std::string> seen_models_;
  bool takes_all_models_ = false, takes_all_locations_ = false;
  std::string location_;  // the one to read; empty: the first
  std::map<std::string, std::string> first_location_, first_residue_;
  std::set<std::string> blank_places_;  // of this residue's atoms without a location
  std::string this_residue_;
  std::size_t atoms_ = 0, other_models_ = 0, other_locations_ = 0, not_chosen_ = 0;
  std::size_t waters_ = 0, ligands_ = 0, hydrogens_ = 0;
};

}  // namespace flowcert::io
