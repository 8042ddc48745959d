// Two vertices with the common samples K are the ends of one Voronoi edge iff K spans a plane. Between them a sample q
// outside of K is farther away than those of K, because |x - q|^2 - |x - p|^2 is linear in x, and is not 0 at both.
#include "oracle/voronoi_graph.h"

#include <algorithm>
#include <map>
#include <set>

namespace oracle {

namespace {

std::vector<VoronoiVertex> vertices_of(const PointSet& set) {
  std::map<Places, Point> found;
  for_each_subset(set.points.size(), 4, [&](const Places& subset) {
    if (subset.size() < 4) return;
    const auto circle = circumcentre(select(set.points, subset));
    if (!circle) return;
    const Places nearest = set.nearest_places(circle->center);
    if (std::binary_search(nearest.begin(), nearest.end(), subset[0])) found.emplace(nearest, circle->center);
  });
  std::vector<VoronoiVertex> vertices;
  vertices.reserve(found.size());
  for (const auto& [contact, x] : found) {
    vertices.push_back({x, squared_distance(x, set.points[contact[0]]), select(set.names, contact)});
  }
  return vertices;
}

// Along an edge, d^2 grows with the distance from the centre of its polygon. So it is least at the centre, if that is
// ahead of `from` and behind `to`, if there is one, and else at an end.
Rational least_on(const PointSet& set, const Places& polygon, const VoronoiVertex& from, const Point& way,
                  const VoronoiVertex* to) {
  const Point centre = circumcentre(spanning_subset(select(set.points, polygon)))->center;
  const bool is_ahead = dot(minus(centre, from.position), way) >= 0;
  if (is_ahead && (to == nullptr || dot(minus(centre, to->position), way) <= 0)) {
    return squared_distance(centre, set.points[polygon[0]]);
  }
  return is_ahead ? to->squared_distance : from.squared_distance;
}

void add_bounded(const PointSet& set, VoronoiGraph& graph) {
  for (std::size_t a = 0; a < graph.vertices.size(); ++a) {
    for (std::size_t b = a + 1; b < graph.vertices.size(); ++b) {
      const VoronoiVertex &from = graph.vertices[a], &to = graph.vertices[b];
      std::vector<std::size_t> common;
      std::set_intersection(from.contact.begin(), from.contact.end(), to.contact.begin(), to.contact.end(),
                            std::back_inserter(common));
      const Places polygon = places_of(set, common);
      if (affine_dimension(select(set.points, polygon)) != 2) continue;
      graph.edges.push_back({common, a, b, least_on(set, polygon, from, minus(to.position, from.position), &to)});
    }
  }
}

// The ray from a vertex in the direction r, if no sample comes nearer than three of the vertex, which have the greatest
// inner product with r then.
void add_ray(const PointSet& set, std::size_t vertex, const Places& three, const Point& r, VoronoiGraph& graph) {
  const VoronoiVertex& from = graph.vertices[vertex];
  const Rational height = dot(r, set.points[three[0]]);
  const auto is_beyond = [&](const Point& q) { return dot(r, q) > height; };
  if (std::any_of(set.points.begin(), set.points.end(), is_beyond)) return;
  Places polygon;
  for (const std::size_t place : places_of(set, from.contact)) {
    if (dot(r, set.points[place]) == height) polygon.push_back(place);
  }
  const std::vector<std::size_t> names = select(set.names, polygon);
  const auto is_listed = [&](const VoronoiEdge& edge) { return edge.polygon == names; };
  if (std::any_of(graph.edges.begin(), graph.edges.end(), is_listed)) return;
  graph.edges.push_back({names, vertex, std::nullopt, least_on(set, polygon, from, r, nullptr)});
}

void add_rays(const PointSet& set, VoronoiGraph& graph) {
  for (std::size_t vertex = 0; vertex < graph.vertices.size(); ++vertex) {
    const Places contact = places_of(set, graph.vertices[vertex].contact);
    for_each_subset(contact.size(), 3, [&](const Places& subset) {
      if (subset.size() < 3) return;
      const Places three = select(contact, subset);
      const Point &a = set.points[three[0]], &b = set.points[three[1]], &c = set.points[three[2]];
      add_ray(set, vertex, three, cross(minus(b, a), minus(c, a)), graph);
      add_ray(set, vertex, three, cross(minus(c, a), minus(b, a)), graph);
    });
  }
}

}  // namespace

VoronoiGraph voronoi_graph(const PointSet& set) {
  VoronoiGraph graph{vertices_of(set), {}};
  add_bounded(set, graph);
  add_rays(set, graph);
  return graph;
}

std::vector<std::optional<std::size_t>> components_above(const VoronoiGraph& graph, const Rational& a) {
  std::vector<std::optional<std::size_t>> component(graph.vertices.size() + 1);
  for (std::size_t k = 0; k < graph.vertices.size(); ++k) {
    if (graph.vertices[k].squared_distance > a) component[k] = k;
  }
  component[graph.infinity()] = graph.infinity();
  for (const VoronoiEdge& edge : graph.edges) {
    if (edge.least <= a) continue;
    const auto one = component[edge.from], other = component[edge.to.value_or(graph.infinity())];
    std::replace(component.begin(), component.end(), std::max(one, other), std::min(one, other));
  }
  return component;
}

}  // namespace oracle
