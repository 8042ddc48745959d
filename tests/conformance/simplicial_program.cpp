// A program of a common sort, for tests of `flowcert fuzz`. It finds critical points by trying all
// simplices of up to four points, in floating point, with no thought for cospherical ones.
//
//   simplicial_program IN OUT [--strict | --crash ROWS | --hang ROWS | --refuse ROWS | --quit ROWS]
//   simplicial_program --cases [the same, or --stray ROWS | --other-id ROWS]   reads and answers case after case
//
// It claims, as lines of CSV, each simplex whose circumcentre is inside of it and whose open ball has no
// other point. So a square comes out as two diagonals. --strict: no other point is on the sphere either, and
// what is cospherical goes missing. The others say what becomes of an input of at least so many rows.
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Vector = std::array<double, 3>;

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

struct Sphere {
  Vector center{};
  double squared_radius = 0;
  bool is_inside = true;  // whether the centre is inside of the simplex
};

// Solves with the Gram matrix of up to three edges. There is no sphere if the matrix looks singular.
std::optional<Sphere> circumsphere(const std::vector<Vector>& simplex) {
  const std::size_t n = simplex.size() - 1;
  double gram[3][4] = {};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      gram[i][j] = 2 * dot(minus(simplex[i + 1], simplex[0]), minus(simplex[j + 1], simplex[0]));
    }
    gram[i][3] = gram[i][i] / 2;
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (std::fabs(gram[i][i]) < 1e-12) return std::nullopt;
    for (std::size_t k = 0; k < n; ++k) {
      if (k == i) continue;
      const double factor = gram[k][i] / gram[i][i];
      for (std::size_t j = 0; j < 4; ++j) gram[k][j] -= factor * gram[i][j];
    }
  }
  Sphere sphere{simplex[0], 0, true};
  double rest = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const double weight = gram[i][3] / gram[i][i];
    rest -= weight;
    sphere.is_inside = sphere.is_inside && weight > 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sphere.center.at(axis) += weight * (simplex[i + 1].at(axis) - simplex[0].at(axis));
    }
  }
  sphere.is_inside = sphere.is_inside && rest > 0;
  sphere.squared_radius = dot(minus(sphere.center, simplex[0]), minus(sphere.center, simplex[0]));
  return sphere;
}

struct Claims {
  const std::vector<Vector>& points;
  bool is_strict;
  std::ostream& out;

  void claim(const std::vector<std::size_t>& ids) const {
    std::vector<Vector> simplex;
    simplex.reserve(ids.size());
    for (const std::size_t id : ids) simplex.push_back(points[id]);
    const auto sphere = circumsphere(simplex);
    if (!sphere || !sphere->is_inside) return;
    for (std::size_t q = 0; q < points.size(); ++q) {
      bool is_own = false;
      for (const std::size_t id : ids) is_own = is_own || id == q;
      const Vector away = minus(points[q], sphere->center);
      const double reach = sphere->squared_radius * (is_strict ? 1 + 1e-9 : 1 - 1e-9);
      if (!is_own && dot(away, away) < reach) return;
    }
    out.precision(17);
    out << ids.size() - 1;
    for (const double coordinate : sphere->center) out << ',' << coordinate;
    out << ',' << sphere->squared_radius;
    for (const std::size_t id : ids) out << ',' << id;
    out << '\n';
  }

  void claim_all(std::vector<std::size_t>& ids) const {
    if (!ids.empty()) claim(ids);
    if (ids.size() == 4) return;
    for (std::size_t next = ids.empty() ? 0 : ids.back() + 1; next < points.size(); ++next) {
      ids.push_back(next);
      claim_all(ids);
      ids.pop_back();
    }
  }
};

void misbehave(const std::string& how) {
  if (how == "--crash") std::raise(SIGSEGV);
  if (how == "--hang") ::sleep(3600);
  if (how == "--quit") std::exit(0);
  if (how == "--refuse") {
    std::cerr << "too many points for me\n";
    std::exit(3);
  }
}

void claim_all(const std::vector<Vector>& points, const std::string& how, std::ostream& out) {
  std::vector<std::size_t> ids;
  Claims{points, how == "--strict", out}.claim_all(ids);
}

int answer_cases(const std::string& how, std::size_t most) {
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::string word, id;
    std::size_t count = 0;
    if (!(words >> word >> id >> count) || word != "case") continue;
    std::vector<Vector> points(count);
    for (Vector& p : points) std::cin >> p[0] >> p[1] >> p[2];
    const bool is_too_much = most <= count;
    if (is_too_much) misbehave(how);
    std::cout << "answer " << id << (is_too_much && how == "--other-id" ? "0" : "") << '\n';
    claim_all(points, how, std::cout);
    std::cout << "end\n" << (is_too_much && how == "--stray" ? "that was hard\n" : "") << std::flush;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && argv[1] == std::string("--cases")) {
    return answer_cases(argc > 2 ? argv[2] : "", argc > 3 ? std::stoul(argv[3]) : ~std::size_t{0});
  }
  if (argc < 3) return 2;
  std::ifstream in(argv[1]);
  std::vector<Vector> points;
  for (Vector p; in >> p[0] >> p[1] >> p[2];) points.push_back(p);
  const std::string how = argc > 3 ? argv[3] : "";
  if (argc > 4 && points.size() >= std::stoul(argv[4])) misbehave(how);
  std::ofstream out(argv[2]);
  claim_all(points, how, out);
  return out.flush() ? 0 : 1;
}
