// The namespace of this layer, the merged Voronoi diagram, sees those of the layers below. Public types are
// in flowcert.
#pragma once

namespace flowcert::geometry {}
namespace flowcert::voronoi {
using namespace geometry;
}  // namespace flowcert::voronoi
