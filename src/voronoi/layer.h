// The merged Voronoi diagram. In go samples. Out come its faces by their contact sets: clusters, polygons and rings,
// with the signs that say where each polygon's centre lies.
//
// The hard part is degeneracy: where samples are cospherical, the triangulation is one of several, and the diagram must
// not depend on which. Cells on one sphere become a cluster, and facets on one circle a polygon, by exact signs. What
// is alone is named by itself, so that a scan pays for that with a few bytes a cell.
//
// To be read in this order: delaunay_signs.h has the signs that CGAL's triangulation rests on (delaunay_kernel.h),
// compact_delaunay.h the arrays that it is copied to (delaunay.cpp), voronoi_complex.h what merges them,
// voronoi_diagram.h the faces for inputs of every dimension, voronoi_faces.h the rings. The namespace sees those of the
// layers below. Public types are in flowcert.
#pragma once

#include "geometry/layer.h"

namespace flowcert::voronoi {
using namespace geometry;
}  // namespace flowcert::voronoi
