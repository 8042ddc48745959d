// What is computed of the flow. In go a diagram and its flow operator. Out come stationary points, their stable and
// unstable sets, limits, volumes, persistence and pockets; FlowComplex makes each when it is asked for.
//
// The hard part is to know a set without its points. Stable sets are walked against the flow from front to front, and
// limits divide edges and facets once, after all faces that these flow to. Positions are made when somebody asks for
// them, in doubles with bounds where these suffice.
//
// To be read in this order: stationary_points.cpp and record_finder.h for the list, backward_walk.h and skeleton_walk.h
// for stable sets, limit_partition.h for limits, forward_walk.h for unstable sets, squared_distances.h and
// persistence.cpp for values and pairs, merge_trees.cpp and pockets.cpp, and flow_complex.cpp, which puts them
// together. The namespace sees those of the layers below. Public types are in flowcert.
#pragma once

#include "flow/layer.h"

namespace flowcert::morse {
using namespace flow;
}  // namespace flowcert::morse
