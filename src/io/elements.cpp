#include "io/elements.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "io/atom_selection.h"
#include "io/line_reader.h"

namespace flowcert::io {

namespace {

constexpr auto kElements = std::to_array<Element>(
    {{"H", 120, 120},  {"He", 140, 143}, {"Li", 182, 212}, {"Be", 153, 198}, {"B", 192, 191},  {"C", 170, 177},
     {"N", 155, 166},  {"O", 152, 150},  {"F", 147, 146},  {"Ne", 154, 158}, {"Na", 227, 250}, {"Mg", 173, 251},
     {"Al", 184, 225}, {"Si", 210, 219}, {"P", 180, 190},  {"S", 180, 189},  {"Cl", 175, 182}, {"Ar", 188, 183},
     {"K", 275, 273},  {"Ca", 231, 262}, {"Sc", 0, 258},   {"Ti", 0, 246},   {"V", 0, 242},    {"Cr", 0, 245},
     {"Mn", 0, 245},   {"Fe", 0, 244},   {"Co", 0, 240},   {"Ni", 163, 240}, {"Cu", 140, 238}, {"Zn", 139, 239},
     {"Ga", 187, 232}, {"Ge", 211, 229}, {"As", 185, 188}, {"Se", 190, 182}, {"Br", 185, 186}, {"Kr", 202, 225},
     {"Rb", 303, 321}, {"Sr", 249, 284}, {"Y", 0, 275},    {"Zr", 0, 252},   {"Nb", 0, 256},   {"Mo", 0, 245},
     {"Tc", 0, 244},   {"Ru", 0, 246},   {"Rh", 0, 244},   {"Pd", 163, 215}, {"Ag", 172, 253}, {"Cd", 158, 249},
     {"In", 193, 243}, {"Sn", 217, 242}, {"Sb", 206, 247}, {"Te", 206, 199}, {"I", 198, 204},  {"Xe", 216, 206},
     {"Cs", 343, 348}, {"Ba", 249, 303}, {"La", 0, 298},   {"Ce", 0, 288},   {"Pr", 0, 292},   {"Nd", 0, 295},
     {"Pm", 0, 0},     {"Sm", 0, 290},   {"Eu", 0, 287},   {"Gd", 0, 283},   {"Tb", 0, 279},   {"Dy", 0, 287},
     {"Ho", 0, 281},   {"Er", 0, 283},   {"Tm", 0, 279},   {"Yb", 0, 280},   {"Lu", 0, 274},   {"Hf", 0, 263},
     {"Ta", 0, 253},   {"W", 0, 257},    {"Re", 0, 249},   {"Os", 0, 248},   {"Ir", 0, 241},   {"Pt", 175, 229},
     {"Au", 166, 232}, {"Hg", 155, 245}, {"Tl", 196, 247}, {"Pb", 202, 260}, {"Bi", 207, 254}, {"Po", 197, 0},
     {"At", 202, 0},   {"Rn", 220, 0},   {"Fr", 348, 0},   {"Ra", 283, 0},   {"Ac", 0, 280},   {"Th", 0, 293},
     {"Pa", 0, 288},   {"U", 186, 271},  {"Np", 0, 282},   {"Pu", 0, 281},   {"Am", 0, 283},   {"Cm", 0, 305},
     {"Bk", 0, 340},   {"Cf", 0, 305},   {"Es", 0, 270},   {"Fm", 0, 0},     {"Md", 0, 0},     {"No", 0, 0},
     {"Lr", 0, 0},     {"Rf", 0, 0},     {"Db", 0, 0},     {"Sg", 0, 0},     {"Bh", 0, 0},     {"Hs", 0, 0},
     {"Mt", 0, 0},     {"Ds", 0, 0},     {"Rg", 0, 0},     {"Cn", 0, 0},     {"Nh", 0, 0},     {"Fl", 0, 0},
     {"Mc", 0, 0},     {"Lv", 0, 0},     {"Ts", 0, 0},     {"Og", 0, 0}});

bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
bool is_among(char c, std::string_view letters) { return letters.find(c) != std::string_view::npos; }

// CA may be calcium or the first carbon of a residue: names of atoms have one of eight letters behind their element.
std::string_view other_of_label(std::string_view letters) {
  const bool is_name = letters.size() == 2 && is_among(letters[0], "CHNOPS") && is_among(letters[1], "ABDEGHOZ");
  return is_name ? letters.substr(0, 1) : std::string_view();
}

MeantElement element_as_written(std::string_view label, ElementSource source) {
  if (source == ElementSource::kLabel && is_integer(label)) {
    std::size_t number = 0;
    const auto result = std::from_chars(label.data(), label.data() + label.size(), number);
    if (result.ec != std::errc() || number == 0 || number > kElements.size()) return {};
    return {kElements[number - 1].symbol};
  }
  const std::string_view letters = element_of_label(label);
  const std::string_view symbol = symbol_of(letters);
  if (source == ElementSource::kSymbol || symbol.empty()) return {symbol};
  // T1 is a place in a framework.
  if (letters == "T" && label != "T") return {};
  return {symbol, other_of_label(letters)};
}

// Residues have few elements. A ligand can have any: its name begins in column 14 where the element has one letter, and
// in column 13 where it has two, or where the name has four characters.
MeantElement element_of_name(std::string_view text, bool has_columns, std::string_view residue) {
  const std::string_view name = trimmed(text);
  const std::string_view letters = name.substr(std::min(name.find_first_not_of("0123456789"), name.size()));
  const std::string_view one = symbol_of(letters.substr(0, 1));
  const std::string_view two =
      letters.size() > 1 && is_letter(letters[1]) ? symbol_of(letters.substr(0, 2)) : std::string_view();
  const std::string kind_text = lower_case(residue);
  if (kind_of_residue(residue) != AtomKind::kLigand) {
    if (two == "Se" && (kind_text == "mse" || kind_text == "sec")) return {two};
    return {!one.empty() && is_among(one[0], "CHNOPS") ? one : std::string_view()};
  }
  if (two.empty() || one.empty()) return {two.empty() ? one : two};
  if (kind_text == lower_case(two)) return {two};
  if (has_columns && !is_letter(text.front())) return {one};
  if (has_columns && name.size() < 4) return {two};
  if (has_columns && one == "H") return {one};
  return {two, one};
}

}  // namespace

std::span<const Element> elements() { return kElements; }

std::string_view symbol_of(std::string_view letters) {
  if (letters == "D" || letters == "T") return "H";
  if (letters.empty() || !is_capital(letters[0])) return {};
  const std::string tail = lower_case(letters.substr(1));
  const auto found = std::ranges::find_if(kElements, [&](const Element& element) {
    return element.symbol[0] == letters[0] && element.symbol.substr(1) == tail;
  });
  return found == kElements.end() ? std::string_view() : found->symbol;
}

MeantElement element_of(const ElementText& text, std::string_view residue) {
  const bool is_pdb_name = text.source == ElementSource::kPdbName;
  if (is_pdb_name || text.source == ElementSource::kName) return element_of_name(text.text, is_pdb_name, residue);
  return element_as_written(text.text, text.source);
}

}  // namespace flowcert::io
