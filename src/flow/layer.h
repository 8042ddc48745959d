// The flow. In goes a point in a known face. Out come its driver, the face that it crosses and the one that it comes
// to: segments, courses from one Voronoi vertex to the next, and where an orbit ends.
//
// The hard part is that a point on a long course has coordinates without end. Signs alone decide where the flow goes,
// and a sign needs no point: the direction in which the point lies is carried from facet to facet, in doubles with a
// bound on its angle. Longer precisions, and then integers, replay the course where that does not decide (cascades.md).
//
// To be read in this order: drivers.h says which way the flow goes, kernels/steering.h by which signs, kernels/kernel.h
// who decides these, facet_search.md where a ray leaves a facet. Then kernel_flow_operator.h takes a step, and
// successor_forest.h follows all orbits at once. The namespace sees those of the layers below. Public types are in
// flowcert.
#pragma once

#include "flow/kernels/layer.h"
