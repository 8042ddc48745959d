// Orientation of S2 meshes: on inputs of every family, and of meshes that are spoilt on purpose.
//
// Guarantees: what is asked of a mesh is asked by a search of its own, triangle by triangle, which knows no sets of
// sides. That search sees a turned triangle, and orient() turns it back. A run fails too when too few components were
// met, or too few that have no orientation.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cstdio>
#include <map>
#include <utility>
#include <vector>

#include "flowcert/surface.h"
#include "fuzz/inputs/families.h"
#include "fuzz/inputs/stable_configurations.h"
#include "fuzz/properties/input_points.h"
#include "io/triangle_orientation.h"
#include "tests/cites.h"
#include "tests/property/orbit_subject.h"
#include "tests/property/property_parameters.h"

namespace flowcert::property::oriented_surfaces_test {
namespace {

using Triangles = std::vector<Triangle>;

struct Neighbour {
  std::size_t triangle = 0;
  bool has_other_way = false;  // both go along their edge in one direction
};

// What a search from triangle to triangle finds.
struct Found {
  TriangleEdges edges;
  std::size_t against = 0;               // manifold edges of components with an orientation that do not keep it
  std::vector<std::size_t> without;      // a triangle of each component without orientation
  std::vector<std::size_t> has_company;  // triangles at a manifold edge of a component with an orientation
};

Found search(const Triangles& triangles) {
  Found found;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::pair<std::size_t, bool>>> uses;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      uses[std::minmax(a, b)].emplace_back(t, a < b);
    }
  }
  std::vector<std::vector<Neighbour>> neighbours(triangles.size());
  for (const auto& [edge, at] : uses) {
    ++(at.size() == 1 ? found.edges.boundary : at.size() == 2 ? found.edges.manifold : found.edges.non_manifold);
    if (at.size() != 2) continue;
    const bool has_other_way = at[0].second == at[1].second;
    neighbours[at[0].first].push_back({at[1].first, has_other_way});
    neighbours[at[1].first].push_back({at[0].first, has_other_way});
  }
  std::vector<int> turned(triangles.size(), -1);
  for (std::size_t start = 0; start < triangles.size(); ++start) {
    if (turned[start] >= 0) continue;
    turned[start] = 0;
    std::vector<std::size_t> component{start};
    bool has_orientation = true;
    std::size_t against = 0;
    for (std::size_t next = 0; next < component.size(); ++next) {
      const std::size_t t = component[next];
      for (const auto& [other, has_other_way] : neighbours[t]) {
        const int wanted = has_other_way ? 1 - turned[t] : turned[t];
        if (turned[other] < 0) component.push_back(other);
        if (turned[other] < 0) turned[other] = wanted;
        has_orientation = has_orientation && turned[other] == wanted;
        against += has_other_way ? 1 : 0;
      }
    }
    ++found.edges.components;
    found.edges.without_orientation += has_orientation ? 0 : 1;
    if (!has_orientation) found.without.push_back(start);
    if (has_orientation) found.against += against / 2;
    if (has_orientation && component.size() > 1) {
      found.has_company.insert(found.has_company.end(), component.begin(), component.end());
    }
  }
  return found;
}

bool are_equal(const TriangleEdges& a, const TriangleEdges& b) {
  return a.boundary == b.boundary && a.manifold == b.manifold && a.non_manifold == b.non_manifold &&
         a.components == b.components && a.without_orientation == b.without_orientation;
}

struct OrientedSeen {
  std::size_t meshes = 0, components = 0, without = 0, manifold = 0, non_manifold = 0, turned_back = 0;
};

void require_oriented(const fuzz::Input& input, const SurfaceMesh& mesh, rc::Random& random, OrientedSeen& seen) {
  const Found found = search(mesh.triangles);
  require_none(input, found.against > 0 ? "a manifold edge is passed twice in one direction" : "", "");
  require_none(input, are_equal(found.edges, mesh.edges) ? "" : "edges or components are counted wrongly", "");
  Triangles again = mesh.triangles;
  (void)orient(again, mesh.vertices.size());
  require_none(input, again == mesh.triangles ? "" : "what is oriented is turned once more", "");
  ++seen.meshes;
  seen.components += mesh.edges.components;
  seen.without += mesh.edges.without_orientation;
  seen.manifold += mesh.edges.manifold;
  seen.non_manifold += mesh.edges.non_manifold;
  if (found.has_company.empty()) return;
  // One triangle the wrong way round.
  Triangles spoilt = mesh.triangles;
  const std::size_t place = found.has_company[random.next() % found.has_company.size()];
  std::swap(spoilt[place][0], spoilt[place][1]);
  require_none(input, search(spoilt).against > 0 ? "" : "the search does not see a turned triangle", "");
  const TriangleEdges edges = orient(spoilt, mesh.vertices.size());
  require_none(input, search(spoilt).against == 0 ? "" : "a turned triangle is not turned back", "");
  require_none(input, are_equal(edges, mesh.edges) ? "" : "turning a triangle changes the counts", "");
  ++seen.turned_back;
}

TEST(OrientedSurfaces, ManifoldEdgesArePassedInBothDirections) {
  CITES("FC-STAB-04");
  OrientedSeen seen;
  bool held = true;
  for (const fuzz::Family& family : fuzz::families_and_stable_ones()) {
    const rc::Gen<fuzz::Input> generator = family.generate();
    const auto property = [&] {
      const fuzz::Input input = *generator;
      rc::Random random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000).as("dice")));
      const FlowComplex complex(point_set_of(input));
      // All sets, and about half of them.
      const std::vector<std::size_t> all = selected_sets(complex, {});
      std::vector<std::size_t> half;
      for (const std::size_t set : all) {
        if (random.next() % 2 == 0) half.push_back(set);
      }
      require_oriented(input, surface_mesh(complex, all), random, seen);
      require_oriented(input, surface_mesh(complex, half), random, seen);
    };
    held = expect_holds(family.name, parameters_of_run(120, held), property) && held;
  }
  std::printf(
      "%zu meshes, %zu components, %zu without orientation, %zu manifold edges, %zu others of several triangles, %zu "
      "turned back\n",
      seen.meshes, seen.components, seen.without, seen.manifold, seen.non_manifold, seen.turned_back);
  if (!held || scale_of_run() < 1) return;
  EXPECT_GE(seen.meshes, 8000U);
  EXPECT_GE(seen.components, 5000U);
  EXPECT_GE(seen.manifold, 100000U);
  EXPECT_GE(seen.non_manifold, 1000U);
  EXPECT_GE(seen.turned_back, 4000U);
}

// Strips of k triangles, closed with or without a twist, and fans of several triangles at one edge, all mixed.
Triangles random_soup(rc::Random& random, std::uint32_t& vertices, std::size_t& twisted) {
  Triangles soup;
  vertices = 0;
  for (std::uint64_t parts = 1 + random.next() % 4; parts > 0; --parts) {
    const auto length = static_cast<std::uint32_t>(5 + random.next() % 6);
    // The strip of 0 1 2, 1 2 3, … is closed at the end; it is twisted if the length is odd.
    for (std::uint32_t k = 0; k < length; ++k) {
      soup.push_back({vertices + k, vertices + (k + 1) % length, vertices + (k + 2) % length});
    }
    twisted += length % 2;
    // A fan, at an edge of its own.
    for (std::uint64_t k = 0; k < random.next() % 4; ++k) {
      soup.push_back({vertices + length, vertices + length + 1, vertices + length + 2 + static_cast<std::uint32_t>(k)});
    }
    vertices += length + 6;
  }
  for (Triangle& triangle : soup) {
    if (random.next() % 2 == 0) std::swap(triangle[1], triangle[2]);
  }
  for (std::size_t k = soup.size(); k > 1; --k) std::swap(soup[k - 1], soup[random.next() % k]);
  return soup;
}

TEST(OrientedSurfaces, WhatHasNoOrientationStaysAsItWas) {
  CITES("FC-STAB-04");
  std::size_t twisted = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    rc::Random random(seed);
    std::uint32_t vertices = 0;
    std::size_t twisted_here = 0;
    const Triangles before = random_soup(random, vertices, twisted_here);
    Triangles after = before;
    const TriangleEdges edges = orient(after, vertices);
    const Found found = search(after);
    EXPECT_EQ(edges.without_orientation, twisted_here) << seed;
    EXPECT_TRUE(are_equal(edges, found.edges)) << seed;
    EXPECT_EQ(found.against, 0U) << seed;
    // The first triangle of each component, and all of those without orientation, stay.
    for (const std::size_t start : found.without) EXPECT_EQ(after[start], before[start]);
    const Found same = search(before);
    EXPECT_EQ(same.without, found.without);
    std::size_t changed = 0;
    for (std::size_t t = 0; t < before.size(); ++t) {
      if (after[t] == before[t]) continue;
      ++changed;
      EXPECT_EQ(after[t], (Triangle{before[t][0], before[t][2], before[t][1]})) << "turned, and nothing else";
      EXPECT_NE(std::ranges::count(found.has_company, t), 0) << "of a component without orientation, or alone";
    }
    EXPECT_TRUE(changed > 0 || same.against == 0) << seed;
    EXPECT_EQ(after.front(), before.front());
    twisted += twisted_here;
  }
  EXPECT_GE(twisted, 100U);
}

}  // namespace
}  // namespace flowcert::property::oriented_surfaces_test
