// The Voronoi diagram of a point set, from which everything after the triangulation is computed.
//
// Guarantees: it does not change once it is made, so threads may share it. Only this library looks into it.
#pragma once

namespace flowcert {

namespace voronoi {
class VoronoiDiagram;
}  // namespace voronoi
using voronoi::VoronoiDiagram;

}  // namespace flowcert
