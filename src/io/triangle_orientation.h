// Triangles with shared vertices, turned so that neighbours have one orientation where that is possible.
//
// Guarantees: an edge of exactly two triangles is *manifold*. Triangles that manifold edges join, one by one, are a
// *component*. If there is a way to turn its triangles so that the two at each manifold edge go along it in opposite
// directions, they are turned so, and the first of them stays as it is. If there is none, all stay as they are. The
// answer depends on the triangles and their order alone.
#pragma once

#include <cstddef>
#include <span>

#include "flowcert/surface.h"

namespace flowcert {

// The vertices of a triangle are three different numbers below `vertices`. There are fewer than 2^31 triangles.
// O(n log n) for n triangles at one vertex.
TriangleEdges orient(std::span<Triangle> triangles, std::size_t vertices);

}  // namespace flowcert
