// Filtration values in doubles can hold ranks. GUDHI's faster options have floats, which cannot.
#include "tests/property/gudhi_alpha.h"

#include <CGAL/Epeck_d.h>
#include <gudhi/Alpha_complex.h>
#include <gudhi/Alpha_complex_3d.h>
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>

namespace flowcert::property {

namespace {

namespace alpha = Gudhi::alpha_complex;
using Spatial = alpha::Alpha_complex_3d<alpha::complexity::EXACT, false, false>;
using FlatKernel = CGAL::Epeck_d<CGAL::Dimension_tag<3>>;
using Flat = alpha::Alpha_complex<FlatKernel>;
using Tree = Gudhi::Simplex_tree<>;
using Cohomology = Gudhi::persistent_cohomology::Persistent_cohomology<Tree, Gudhi::persistent_cohomology::Field_Zp>;

bool are_flat(std::span<const Point> points) {
  CGAL::Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel> triangulation;
  for (const Point& p : points) {
    triangulation.insert({p.x, p.y, p.z});
    if (triangulation.dimension() == 3) return false;
  }
  return true;
}

std::vector<std::size_t> add_flat(std::span<const Point> points, Tree& tree) {
  std::vector<FlatKernel::Point_d> copies;
  for (const Point& p : points) copies.emplace_back(p.x, p.y, p.z);
  Flat complex(copies);
  if (!complex.create_complex(tree, std::numeric_limits<double>::infinity(), true)) {
    throw std::runtime_error("GUDHI makes no alpha complex");
  }
  std::vector<std::size_t> places(points.size());
  for (std::size_t k = 0; k < places.size(); ++k) places[k] = k;
  return places;
}

std::vector<std::size_t> add_spatial(std::span<const Point> points, Tree& tree) {
  std::map<std::tuple<double, double, double>, std::size_t> place_of;
  std::vector<Spatial::Bare_point_3> copies;
  for (const Point& p : points) {
    place_of.emplace(std::tuple(p.x, p.y, p.z), copies.size());
    copies.emplace_back(p.x, p.y, p.z);
  }
  Spatial complex(copies);
  if (!complex.create_complex(tree)) throw std::runtime_error("GUDHI makes no alpha complex");
  // GUDHI numbers the vertices as it meets them.
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < tree.num_vertices(); ++k) {
    const auto& p = complex.get_point(k);
    const auto number = [](const auto& coordinate) { return CGAL::to_double(coordinate); };
    places.push_back(place_of.at(std::tuple(number(p.x()), number(p.y()), number(p.z()))));
  }
  return places;
}

}  // namespace

struct GudhiAlpha::Complex {
  Tree tree;
  std::vector<Tree::Simplex_handle> handles;
  std::vector<GudhiSimplex> simplices;
};

GudhiAlpha::GudhiAlpha(std::span<const Point> points) : complex_(std::make_unique<Complex>()) {
  if (points.empty()) return;
  Tree& tree = complex_->tree;
  const std::vector<std::size_t> place = are_flat(points) ? add_flat(points, tree) : add_spatial(points, tree);
  if (tree.num_vertices() != points.size()) throw std::runtime_error("GUDHI leaves points out");
  for (const Tree::Simplex_handle& handle : tree.complex_simplex_range()) complex_->handles.push_back(handle);
  std::ranges::stable_sort(complex_->handles, {}, [&](const auto& handle) { return tree.dimension(handle); });
  std::size_t next = 0;
  for (const Tree::Simplex_handle& handle : complex_->handles) {
    tree.assign_key(handle, static_cast<Tree::Simplex_key>(next++));
    GudhiSimplex simplex;
    for (const auto vertex : tree.simplex_vertex_range(handle)) {
      simplex.vertices.push_back(place.at(static_cast<std::size_t>(vertex)));
    }
    std::ranges::sort(simplex.vertices);
    for (const Tree::Simplex_handle& facet : tree.boundary_simplex_range(handle)) {
      if (facet == Tree::null_simplex()) throw std::runtime_error("GUDHI leaves a face out");
      simplex.facets.push_back(tree.key(facet));
    }
    simplex.filtration = tree.filtration(handle);
    complex_->simplices.push_back(std::move(simplex));
  }
}

GudhiAlpha::~GudhiAlpha() = default;

const std::vector<GudhiSimplex>& GudhiAlpha::simplices() const { return complex_->simplices; }

std::vector<GudhiPair> GudhiAlpha::persistence(const std::vector<std::size_t>& rank) {
  std::vector<GudhiPair> pairs;
  if (complex_->handles.empty()) return pairs;
  Tree& tree = complex_->tree;
  std::map<const void*, std::size_t> place_of;
  for (std::size_t k = 0; k < complex_->handles.size(); ++k) {
    tree.assign_filtration(complex_->handles[k], static_cast<double>(rank.at(k)));
    place_of.emplace(&complex_->handles[k]->second, k);
  }
  tree.initialize_filtration();
  Cohomology cohomology(tree, true);  // true: the top dimension as well
  cohomology.init_coefficients(2);
  cohomology.compute_persistent_cohomology(-1);
  for (const auto& [birth, death, field] : cohomology.get_persistent_pairs()) {
    GudhiPair pair{place_of.at(&birth->second), std::nullopt};
    if (death != Tree::null_simplex()) pair.death = place_of.at(&death->second);
    pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace flowcert::property
