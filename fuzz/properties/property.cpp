// The table of properties; see property.h for what it guarantees.
#include "fuzz/properties/property.h"

#include <algorithm>
#include <exception>
#include <system_error>

#include "fuzz/properties/property_checks.h"
#include "geometry/contract.h"
#include "oracle/fast/point_set.h"

namespace flowcert::property {

oracle::Point start_of(const Trial& trial) {
  FLOWCERT_REQUIRES(!trial.input.rows.empty());
  if (const auto* point = std::get_if<oracle::Point>(&trial.start)) return *point;
  return start_of(oracle::fast::PointSet(trial.input.rows), std::get<StartChoice>(trial.start));
}

const std::vector<Property>& properties() {
  static const std::vector<Property> table = {
      {.name = "critical-points",
       .description = "all stationary points, fast against oracle, and the laws that either must keep",
       .check = check_critical_points},
      {.name = "orbit",
       .description = "the orbit of one start, segment by segment, fast (usual; lazy and binary) against oracle",
       .check = check_orbit},
      {.name = "unstable-manifolds",
       .description = "both orbits of every index-2 point, fast (usual; lazy and binary) against oracle",
       .one_in = 4,
       .check = check_unstable_manifolds},
      {.name = "stable-sets",
       .description =
           "the stable sets of all index-2 and regular stationary points, fast (usual; lazy and binary) against "
           "oracle",
       .most_rows = 10,
       .one_in = 8,
       .check = check_stable_sets},
      {.name = "persistence",
       .description = "persistence pairs, fast against the oracle's of the Čech filtration",
       .most_rows = 8,
       .one_in = 16,
       .check = check_persistence},
      {.name = "orbit-kernels",
       .description = "the orbit by the kernels cascade, lazy and exact, by binary and linear search",
       .one_in = 8,
       .check = check_orbit_kernels},
      {.name = "unstable-kernels",
       .description = "orbits of index-2 points, lazy against cascade and exact, shared against each alone",
       .one_in = 8,
       .check = check_unstable_kernels},
      {.name = "stable-kernels",
       .description = "stable sets and boundaries, the lazy kernel against cascade and exact",
       .one_in = 8,
       .check = check_stable_kernels},
      {.name = "threads",
       .description = "all parts of the complex, made by 2, 3 and 8 threads, against one thread",
       .one_in = 0,
       .check = check_threads},
  };
  return table;
}

const Property* property_named(std::string_view name) {
  const auto found =
      std::find_if(properties().begin(), properties().end(), [&](const Property& one) { return one.name == name; });
  return found == properties().end() ? nullptr : &*found;
}

std::optional<Disagreement> disagreement(const Property& property, const Trial& trial) {
  if (trial.input.rows.size() > property.most_rows) return std::nullopt;
  try {
    return property.check(trial);
  } catch (const MachineFailure&) {
    throw;
  } catch (const std::system_error& failure) {
    throw MachineFailure(failure.what());
  } catch (const std::exception& error) {
    return Disagreement{"throws", "FC-IN-01", error.what(), "the exception", error.what(), "", ""};
  }
}

}  // namespace flowcert::property
