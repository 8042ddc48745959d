// Lists of limits come in the order of the stationary points, as the page's records do.
#include "io/viewer_cells.h"

#include <cstdint>
#include <vector>

#include "flowcert/connections.h"
#include "io/viewer_blob.h"

namespace flowcert::io {

Json viewer_cells_field(const FlowComplex& complex, const ViewerSelection& selection) {
  const FlowLimits& limits = complex.limits();
  const StableVolumes& all_volumes = complex.volumes();
  std::vector<double> volumes;
  std::vector<std::uint32_t> offsets = {0}, to, orbits, families;
  std::size_t list = 0;
  for (const std::size_t record : selection.records) {
    volumes.push_back(all_volumes.nearest(record));
    while (list < limits.size() && limits.record(list) < record) ++list;
    if (list < limits.size() && limits.record(list) == record) {
      for (const Connection& connection : connections_of(limits, list)) {
        static_assert(Connection::kInfinity == ViewerSelection::kNone);
        to.push_back(connection.to);
        orbits.push_back(connection.orbits);
        families.push_back(connection.families);
      }
    }
    offsets.push_back(static_cast<std::uint32_t>(to.size()));
  }
  return {{"volumes", viewer_blob(volumes)},
          {"offsets", viewer_blob(offsets)},
          {"to", viewer_blob(to)},
          {"orbits", viewer_blob(orbits)},
          {"families", viewer_blob(families)}};
}

}  // namespace flowcert::io
