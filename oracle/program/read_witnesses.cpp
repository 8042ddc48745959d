// Whether a contact set is one is left to the judge.
#include "oracle/program/read_witnesses.h"

#include <nlohmann/json.hpp>

#include "oracle/program/read_points.h"

namespace oracle {

namespace {

using nlohmann::json;

Contact contact_of(const json& value) {
  for (const json& name : value) {
    if (!name.is_number_unsigned()) throw UnusableInput("a point id is no natural number");
  }
  return value.get<Contact>();
}

std::vector<Contact> contacts_of(const json& list) {
  std::vector<Contact> contacts;
  for (const json& contact : list) contacts.push_back(contact_of(contact));
  return contacts;
}

}  // namespace

std::vector<Witness> read_witnesses(std::istream& in, const std::string& name) {
  try {
    const json file = json::parse(in);
    if (file.at("format") != "flowcert-cycles" || file.at("format_version") != 1) {
      throw UnusableInput("no flowcert-cycles of format_version 1");
    }
    std::vector<Witness> witnesses;
    for (const json& cycle : file.at("cycles")) {
      const json& parts = cycle.at("witness");
      witnesses.push_back({contact_of(cycle.at("birth").at("contact")), contact_of(cycle.at("death").at("contact")),
                           contacts_of(parts.at("loop")), contacts_of(parts.at("surface")),
                           contacts_of(parts.at("cocycle")), contacts_of(parts.at("met"))});
    }
    return witnesses;
  } catch (const std::exception& error) {
    throw UnusableInput(name + ": " + error.what());
  }
}

}  // namespace oracle
