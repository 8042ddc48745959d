// See flowcert/write_stationary_points.h.
#include "flowcert/write_stationary_points.h"

#include "io/layer.h"
#include "io/stationary_records.h"

namespace flowcert {

using namespace io;

void write_stationary_points(std::ostream& out, const PointSet& points, const StationaryPoints& stationary,
                             const std::string& input_sha256,
                             const std::function<void(std::size_t, std::size_t)>& progress) {
  write_stationary_records(out, points, stationary, input_sha256, {}, progress);
}

}  // namespace flowcert
