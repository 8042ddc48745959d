#include "flowcert/atom_names.h"

#include <algorithm>
#include <set>

#include "io/foreign_text.h"
#include "io/layer.h"

namespace flowcert {

namespace {

// No field of a file's line is longer that is not damaged; a longer one is cut.
constexpr std::size_t kLongest = 255;

std::string joined(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) {
    if (!text.empty() && !part.empty()) text += ' ';
    text += part;
  }
  return text;
}

}  // namespace

void AtomNames::add(const AtomName& name) {
  for (const std::string_view field : {name.chain, name.residue, name.number, name.atom, name.element}) {
    const bool is_plain = std::ranges::all_of(field, [](char c) { return c >= ' ' && c <= '~' && c != '\\'; });
    const std::string escaped = is_plain ? "" : io::on_one_line(field);
    const std::string_view kept = io::front_of(is_plain ? field : escaped, kLongest);
    fields_ += static_cast<char>(static_cast<unsigned char>(kept.size()));
    fields_ += kept;
  }
  offsets_.push_back(fields_.size());
}

AtomName AtomNames::operator[](PointId row) const {
  AtomName name;
  std::string_view rest(fields_);
  rest.remove_prefix(static_cast<std::size_t>(offsets_[row]));
  for (std::string_view* field : {&name.chain, &name.residue, &name.number, &name.atom, &name.element}) {
    const std::size_t size = static_cast<unsigned char>(rest.front());
    *field = rest.substr(1, size);
    rest.remove_prefix(1 + size);
  }
  return name;
}

std::string AtomNames::residue_text(PointId row) const {
  const AtomName name = (*this)[row];
  return joined({name.chain, name.residue, name.number});
}

std::string AtomNames::text(PointId row) const {
  const AtomName name = (*this)[row];
  return joined({name.chain, name.residue, name.number, name.atom.empty() ? name.element : name.atom});
}

std::vector<std::string> AtomNames::residue_texts(std::span<const PointId> rows) const {
  std::vector<std::string> texts;
  std::set<std::string> known;
  for (const PointId row : rows) {
    std::string text = residue_text(row);
    if (!text.empty() && known.insert(text).second) texts.push_back(std::move(text));
  }
  return texts;
}

}  // namespace flowcert
