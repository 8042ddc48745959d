#include "io/atom_selection.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "io/number_text.h"

namespace flowcert::io {

// ---- Residues ----

namespace {

// The standard amino acids, the two rare ones, and the names that the usual programs give to modified or charged ones.
constexpr auto kAminoAcids = std::to_array<std::string_view>(
    {"ALA", "ARG", "ASN", "ASP", "ASX", "CYS", "GLN", "GLU", "GLX", "GLY", "HIS", "ILE", "LEU", "LYS", "MET",
     "PHE", "PRO", "SER", "THR", "TRP", "TYR", "VAL", "SEC", "PYL", "UNK", "MSE", "CSO", "CME", "SEP", "TPO",
     "PTR", "KCX", "MLY", "LLP", "PCA", "HYP", "CGU", "OCS", "CSD", "CYX", "CYM", "HID", "HIE", "HIP", "HSD",
     "HSE", "HSP", "ASH", "GLH", "LYN", "ARN", "TYM", "ACE", "NME", "NMA", "NH2", "FME"});
constexpr auto kNucleotides = std::to_array<std::string_view>(
    {"A",   "C",   "G",   "U",   "T",   "I",   "N",   "DA",  "DC",  "DG",  "DT",  "DU",  "DI",  "DN",  "A5",
     "A3",  "C5",  "C3",  "G5",  "G3",  "U5",  "U3",  "DA5", "DA3", "DC5", "DC3", "DG5", "DG3", "DT5", "DT3",
     "ADE", "CYT", "GUA", "THY", "URA", "PSU", "5MU", "5MC", "OMC", "OMG", "2MG", "7MG", "1MA", "H2U"});
constexpr auto kWaters =
    std::to_array<std::string_view>({"HOH", "H2O", "WAT", "DOD", "D2O", "SOL", "TIP", "TIP2", "TIP3", "TIP4", "TIP5",
                                     "TP3", "TP4", "T3P", "T4P", "SPC", "HHO", "OHH", "MTO"});

bool is_in(const auto& table, std::string_view name) { return std::ranges::find(table, name) != table.end(); }

std::string upper_case(std::string_view text) {
  std::string upper(text);
  for (char& c : upper) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return upper;
}

// Deuterium and tritium, too, and names as HA and HB; He, Hf, Hg, Ho and Hs are others.
bool is_hydrogen(std::string_view element) {
  const std::string name = upper_case(element);
  if (name == "D" || name == "T") return true;
  return name.starts_with('H') && (name.size() == 1 || std::string_view("EFGOS").find(name[1]) == std::string::npos);
}

// "3 names", at most a dozen of them.
std::string listed(const auto& names) {
  constexpr std::size_t kShown = 12;
  std::vector<std::string> shown;
  for (const std::string& name : names) {
    if (shown.size() < kShown) shown.push_back(in_quotes(name));
  }
  return fmt::format("{}{}", fmt::join(shown, ", "), shown.size() < names.size() ? " and others" : "");
}

[[noreturn]] void reject_words(std::string_view text) {
  throw InvalidInput(
      fmt::format("--atoms: no word for atoms: {}; there are all, protein, nucleic, water, ligands, hydrogens, hetatm, "
                  "chain X, each also after 'no', and altloc X, model X, with commas between: --atoms \"no water,no "
                  "ligands\"",
                  in_quotes(text)));
}

}  // namespace

AtomKind kind_of_residue(std::string_view name) {
  const std::string residue = upper_case(name);
  if (is_in(kAminoAcids, residue)) return AtomKind::kProtein;
  if (is_in(kNucleotides, residue)) return AtomKind::kNucleic;
  return is_in(kWaters, residue) ? AtomKind::kWater : AtomKind::kLigand;
}

std::string_view element_of_label(std::string_view label) {
  if (label == "1") return "H";
  std::size_t size = 0;
  while (size < label.size() && is_letter(label[size])) ++size;
  return label.substr(0, size);
}

// ---- Words ----

AtomSelection::AtomSelection(const ReadingOptions& options, std::string_view file, bool has_residues)
    : file_(file), has_residues_(has_residues), chains_(options.chains.begin(), options.chains.end()) {
  for (const std::string& words : options.atoms) {
    for (const std::string_view word : split_at(words, ',')) add_word(word);
  }
  if (options.models.empty()) return;
  for (const std::string_view model : split_at(options.models, ',')) {
    if (model.empty()) throw InvalidInput("--models: the name of a model is empty: " + in_quotes(options.models));
    add_rule("model", model, false);
  }
}

void AtomSelection::add_word(std::string_view text) {
  std::vector<std::string_view> words = words_of(text);
  const bool takes_away = words.size() > 1 && lower_case(words[0]) == "no";
  if (takes_away) words.erase(words.begin());
  if (words.empty() || words.size() > 2) reject_words(text);
  add_rule(lower_case(words[0]), words.size() == 2 ? words[1] : std::string_view(), takes_away);
}

void AtomSelection::add_rule(std::string_view word, std::string_view argument, bool takes_away) {
  constexpr auto kWords = std::to_array<std::pair<std::string_view, Word>>({{"all", Word::kAll},
                                                                            {"protein", Word::kProtein},
                                                                            {"nucleic", Word::kNucleic},
                                                                            {"water", Word::kWater},
                                                                            {"waters", Word::kWater},
                                                                            {"ligand", Word::kLigands},
                                                                            {"ligands", Word::kLigands},
                                                                            {"hydrogen", Word::kHydrogens},
                                                                            {"hydrogens", Word::kHydrogens},
                                                                            {"hetatm", Word::kHetatm},
                                                                            {"chain", Word::kChain}});
  const bool is_model = word == "model" || word == "models";
  if (!takes_away && !argument.empty() && is_model) {
    if (argument == "all") takes_all_models_ = true;
    models_.emplace(argument);
    return;
  }
  if (!takes_away && !argument.empty() && word == "altloc") {
    takes_all_locations_ = argument == "all";
    location_ = argument == "all" ? "" : argument;
    return;
  }
  const auto known = std::ranges::find(kWords, word, &std::pair<std::string_view, Word>::first);
  if (known == kWords.end() || (known->second == Word::kChain) != !argument.empty()) {
    reject_words(argument.empty() ? std::string(word) : fmt::format("{} {}", word, argument));
  }
  if (!has_residues_ && known->second != Word::kAll && known->second != Word::kHydrogens) {
    reject_file(file_, fmt::format("the format has no residues, so --atoms knows 'hydrogens' alone, not '{}'", word));
  }
  rules_.push_back({known->second, std::string(argument), takes_away});
}

bool AtomSelection::is_chosen(const Atom& atom) const {
  const AtomKind kind = kind_of_residue(atom.residue);
  const auto holds = [&](const Rule& rule) {
    switch (rule.word) {
      case Word::kAll:
        return true;
      case Word::kProtein:
        return kind == AtomKind::kProtein;
      case Word::kNucleic:
        return kind == AtomKind::kNucleic;
      case Word::kWater:
        return kind == AtomKind::kWater;
      case Word::kLigands:
        return kind == AtomKind::kLigand;
      case Word::kHydrogens:
        return is_hydrogen(atom.element);
      case Word::kHetatm:
        return atom.is_hetatm;
      case Word::kChain:
        return atom.chain == rule.chain;
    }
    return false;
  };
  bool is_taken = rules_.empty() || rules_.front().takes_away;
  for (const Rule& rule : rules_) {
    if (holds(rule)) is_taken = !rule.takes_away;
  }
  return is_taken;
}

// ---- Atoms ----

bool AtomSelection::takes_model(const std::string& name) {
  const bool is_first = seen_models_.empty();
  seen_models_.push_back(name);
  const bool is_taken = takes_all_models_ || (models_.empty() ? is_first : models_.contains(name));
  if (!is_taken) ++other_models_;
  return is_taken;
}

bool AtomSelection::takes_location(const Atom& atom) {
  if (takes_all_locations_) return true;
  if (std::exchange(this_residue_, atom.residue_place) != atom.residue_place) blank_places_.clear();
  if (atom.location.empty()) {
    blank_places_.insert(atom.place);
    return true;
  }
  if (!location_.empty()) return atom.location == location_;
  // A residue may have other names in other locations, with atoms of their own.
  const bool is_first = first_residue_.try_emplace(atom.residue_place, atom.residue).first->second == atom.residue;
  return is_first && !blank_places_.contains(atom.place) &&
         first_location_.try_emplace(atom.place, atom.location).first->second == atom.location;
}

bool AtomSelection::takes(const Atom& atom) {
  seen_chains_.emplace(atom.chain);
  if (!chains_.empty() && !chains_.contains(std::string(atom.chain))) return false;
  if (!is_chosen(atom)) {
    ++not_chosen_;
    return false;
  }
  if (!takes_location(atom)) {
    ++other_locations_;
    return false;
  }
  ++atoms_;
  if (is_hydrogen(atom.element)) ++hydrogens_;
  if (atom.residue.empty()) return true;
  if (kind_of_residue(atom.residue) == AtomKind::kWater) ++waters_;
  if (kind_of_residue(atom.residue) == AtomKind::kLigand) ++ligands_;
  return true;
}

void AtomSelection::finish(PointRows& rows) {
  const bool has_atoms = atoms_ + not_chosen_ + other_locations_ > 0 || !seen_chains_.empty();
  for (const Rule& rule : rules_) {
    if (rule.word == Word::kChain) chains_.insert(rule.chain);
  }
  for (const std::string& chain : chains_) {
    if (seen_chains_.contains(chain)) continue;
    reject_file(file_, fmt::format("there is no chain {}; there are {}", in_quotes(chain),
                                   has_atoms ? listed(seen_chains_) : "no atoms"));
  }
  for (const std::string& model : models_) {
    if (model == "all" || std::ranges::find(seen_models_, model) != seen_models_.end()) continue;
    reject_file(file_, fmt::format("there is no model {}; there are {}", in_quotes(model), listed(seen_models_)));
  }
  if (!has_atoms) reject_file(file_, "there are no atoms");
  if (atoms_ == 0) reject_file(file_, "no atom is chosen");
  if (other_models_ > 0) {
    const char* const which = models_.empty() ? "only the first model is read" : "not all models are read";
    rows.note(0, fmt::format("{}; {} other{} left out", which, with_commas(other_models_),
                             other_models_ == 1 ? " is" : "s are"));
  }
  if (other_locations_ > 0) {
    rows.note(0, fmt::format("of an atom with alternate locations {} is read; {} other{} left out",
                             location_.empty() ? "the first" : in_quotes(location_), with_commas(other_locations_),
                             other_locations_ == 1 ? " is" : "s are"));
  }
  if (not_chosen_ > 0) {
    rows.note(0, fmt::format("{} atom{} not chosen by --atoms", with_commas(not_chosen_),
                             not_chosen_ == 1 ? " is" : "s are"));
  }
  if (rules_.empty()) tell_kinds(rows);
}

void AtomSelection::tell_kinds(PointRows& rows) const {
  std::vector<std::string> kinds, words;
  const auto tell = [&](std::size_t count, const char* kind, const char* word) {
    if (count == 0) return;
    kinds.push_back(fmt::format("{} {}", with_commas(count), kind));
    words.push_back(fmt::format("no {}", word));
  };
  tell(hydrogens_, hydrogens_ == 1 ? "hydrogen" : "hydrogens", "hydrogens");
  tell(ligands_, "of ligands", "ligands");
  tell(waters_, "of water", "water");
  if (kinds.empty()) return;
  rows.note(0, fmt::format("the {} atoms include {}; --atoms \"{}\" leaves {} out", with_commas(atoms_),
                           fmt::join(kinds, ", "), fmt::join(words, ","), kinds.size() == 1 ? "such" : "all of these"));
}

}  // namespace flowcert::io
