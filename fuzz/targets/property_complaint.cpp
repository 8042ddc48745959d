#include <sstream>

#include "fuzz/properties/property.h"
#include "fuzz/targets/target.h"
#include "geometry/contract.h"

namespace flowcert::fuzz {

std::string complaint_of(std::initializer_list<const char*> properties, const property::Trial& trial) {
  for (const char* name : properties) {
    FLOWCERT_REQUIRES(property::property_named(name) != nullptr);
    const auto found = property::property_named(name)->check(trial);
    if (!found) continue;
    std::ostringstream text;
    text << name << ": " << found->kind << ' ' << found->clause << ": " << found->complaint << "\ninput:\n"
         << trial.input;
    if (!trial.input.rows.empty()) {
      const oracle::Point start = property::start_of(trial);
      text << "# start: " << start[0] << ' ' << start[1] << ' ' << start[2] << '\n';
    }
    text << found->first_name << ":\n" << found->first << '\n' << found->second_name << ":\n" << found->second;
    return text.str();
  }
  return {};
}

}  // namespace flowcert::fuzz
