// Writes stationary points as JSON Lines: a header, then one record for each point. A record has the centre and, if
// wanted, what flows out of the point and into it (spec/formats/stationary_points.md).
//
// Guarantees: rationals are exact, and doubles are the nearest ones.
#pragma once

#include <cstdint>
#include <ostream>

#include "flowcert/flow_complex.h"
#include "flowcert/progress.h"

namespace flowcert {

// What a record says of its centre and squared distance: the exact numbers and the doubles beside them, the nearest
// doubles alone, or nothing.
enum class WrittenCenters : std::uint8_t { kExact, kDouble, kNone };

// What a record says of a volume: the nearest double; also the doubles nearest to its shares; or also exact numbers.
enum class WrittenVolumes : std::uint8_t { kDouble, kShares, kExact };

// u2 adds the samples of index-1 points and the limits of index-2 points. polylines adds the orbits of index-2 points
// as exact polylines. s2 adds the size and boundary of stable sets. skeletons adds their exact skeletons.
// all adds λ-lists, connections and volumes. sheets adds the unstable sets of dimension 2, exactly. all and skeletons
// add a last line with the skeleton of infinity.
struct RecordsToWrite {
  bool u2 = false;
  bool polylines = false;
  bool s2 = false;
  bool skeletons = false;
  WrittenCenters centers = WrittenCenters::kExact;
  bool all = false;
  WrittenVolumes volumes = WrittenVolumes::kDouble;
  bool sheets = false;
};

// progress, if given, is called now and then with how many records are written. The stream's state says whether all was
// written. Each record takes a few microseconds for its rationals. Polylines, skeletons, λ-lists,
// exact volumes and sheets take the time for all their exact numbers. Each thread has one unstable set in memory.
void write_stationary_points(std::ostream& out, const FlowComplex& complex, const RecordsToWrite& wanted = {},
                             const Progress& progress = {});

// Writes a certificate (spec/formats/certificates.md): the Delaunay cells, two to three bytes each, from which a checker
// that knows nothing of this library proves a list of stationary points. The stream's state says whether all was
// written. O(cells).
void write_certificate(std::ostream& out, const FlowComplex& complex);

}  // namespace flowcert
