#include "morse/ball_critical_points.h"

#include <algorithm>
#include <optional>
#include <set>

#include "geometry/parallel_for.h"

namespace flowcert::morse {

namespace {

using Ids = std::vector<std::uint32_t>;
using Face = std::span<const std::uint32_t>;

// A point at a distance, exact and in doubles.
struct ExactPlace {
  QuadraticNumber s;
  Vector3<QuadraticNumber> x;
  BoundedDouble near_s;
  Vector3<BoundedDouble> near_x;
};

Vector3<QuadraticNumber> lifted(const Vector3<Rational>& v) { return {v.x, v.y, v.z}; }

template <class Number>
Number excess(const Vector3<Number>& x, const Number& s, const NumberBall<Number>& ball) {
  const Vector3<Number> way = x - ball.center;
  const Number reach = s + ball.radius;
  return dot(way, way) - reach * reach;
}

Touching<BoundedDouble> with_bounds(const Touching<SizedDouble>& made) {
  const auto vector = [](const Vector3<SizedDouble>& v) {
    return Vector3<BoundedDouble>{v.x.bounded(), v.y.bounded(), v.z.bounded()};
  };
  Touching<BoundedDouble> near{vector(made.a),    vector(made.b),   {}, {}, made.c2.bounded(),
                               made.c1.bounded(), made.c0.bounded()};
  for (std::size_t k = 0; k < 3; ++k) {
    near.u[k] = made.u[k].bounded();
    near.v[k] = made.v[k].bounded();
  }
  return near;
}

// Of coordinates, radii and what is near to them, an absolute error of this share is more than all roundings of
// x - q and s + r: they are three of 2^-53 each.
constexpr double kPlaceShare = 0x1p-51;
// The squares of |w| and of s + r, and their sum, have four roundings.
constexpr double kExcessShare = 0x1p-50;

// A point at a distance from balls, in doubles: says of many balls whether they are nearer.
class RoundedPlace {
 public:
  RoundedPlace(const Vector3<BoundedDouble>& x, const BoundedDouble& s, double greatest)
      : x_{x.x.value, x.y.value, x.z.value}, s_(s.value) {
    const double far = greatest + std::fabs(s_) + greatest_coordinate(Point{x_.x, x_.y, x_.z});
    error_ = std::max({x.x.error, x.y.error, x.z.error, s.error}) + kPlaceShare * far;
  }

  // 1 or -1 where it is certain whether the ball is farther or nearer, and 0 where it is not. w and s + r, four numbers
  // of the sum `size`, are wrong by `error_` each, and their squares by (2 size + 4 error_) error_ together.
  [[nodiscard]] int side(const std::array<double, 4>& ball) const {
    const Vector3<double> w{x_.x - ball[0], x_.y - ball[1], x_.z - ball[2]};
    const double reach = s_ + ball[3];
    const double size = std::fabs(w.x) + std::fabs(w.y) + std::fabs(w.z) + std::fabs(reach);
    const double bound = 3 * error_ * (size + 2 * error_) + kExcessShare * size * size;
    return BoundedDouble(dot(w, w) - reach * reach, bound).certain_sign();
  }

 private:
  Vector3<double> x_;
  double s_, error_;
};

class Search {
 public:
  // No coordinate and no radius is greater.
  Search(const BallDiagram& diagram, double greatest)
      : diagram_(diagram), balls_(diagram.balls()), greatest_(greatest) {}

  // The points inside of faces of which these balls are the first.
  std::vector<BallCriticalPoint> run(std::span<const std::uint32_t> ids) {
    for (const std::uint32_t id : ids) {
      see_faces<1>(id);
      if (diagram_.dimension() >= 2) see_faces<2>(id);
      if (diagram_.dimension() >= 3) see_faces<3>(id);
    }
    return std::move(found_);
  }

 private:
  // The other balls of a face, and a cell that has it, from the highest bits down.
  using FaceKey = unsigned __int128;

  // The faces of which this ball is the first.
  template <std::size_t kOthers>
  void see_faces(std::uint32_t first) {
    if (diagram_.dimension() < 1) return;
    faces_.clear();
    const auto add = [&](std::uint32_t number, auto... others) {
      FaceKey key = 0;
      ((key = key << 32 | others), ...);
      faces_.push_back(key << 32 | number);
    };
    if constexpr (kOthers == 1) {
      for (const std::uint32_t id : diagram_.neighbours(first)) {
        if (id > first) add(diagram_.star(first)[0], id);
      }
    } else {
      for (const std::uint32_t number : diagram_.star(first)) add_subsets<kOthers>(first, number, add);
    }
    std::ranges::sort(faces_);
    std::array<std::uint32_t, kOthers + 1> face{};
    for (const FaceKey key : faces_) {
      std::array<std::uint32_t, kOthers + 1> next;
      next[0] = first;
      for (std::size_t k = 1; k <= kOthers; ++k) next[k] = static_cast<std::uint32_t>(key >> 32 * (kOthers + 1 - k));
      if (next == face) continue;
      face = next;
      see_face(face, diagram_.cells()[static_cast<std::uint32_t>(key)]);
    }
  }

  // A tetrahedron behind which there is a cell of a lower number is not added: it has been.
  template <std::size_t kOthers>
  void add_subsets(std::uint32_t first, std::uint32_t number, const auto& add) {
    const BallDiagram::Corners& cell = diagram_.cells()[number];
    const std::size_t corners = static_cast<std::size_t>(diagram_.dimension() + 1);
    const std::size_t place = static_cast<std::size_t>(std::ranges::find(cell, first) - cell.begin());
    for (std::size_t i = place + 1; i < corners; ++i) {
      for (std::size_t j = i + 1; j < corners; ++j) {
        if constexpr (kOthers == 2) add(number, cell[i], cell[j]);
        for (std::size_t k = j + 1; kOthers == 3 && k < corners; ++k) {
          if (corners == 4 || diagram_.adjacent()[number][10 - place - i - j - k] > number) {
            add(number, cell[i], cell[j], cell[k]);
          }
        }
      }
    }
  }

  std::uint32_t least_connected(Face face) const {
    return *std::ranges::min_element(face, {}, [&](std::uint32_t id) { return diagram_.neighbours(id).size(); });
  }

  // ---- In doubles ----

  void see_face(Face face, const BallDiagram::Corners& cell) {
    int answer = 0;
    if (const auto made = touching<SizedDouble>(balls_, face)) answer = try_face(face, cell, with_bounds(*made));
    if (answer < 0) return;
    const auto made = touching<BoundedDouble>(balls_, face);
    if (!made) return see_exactly(face);
    if (answer == 0) answer = try_face(face, cell, *made);
    if (answer < 0) return;
    const auto roots = bounded_roots(*made).both;
    if (answer == 0 || !roots) return see_exactly(face);
    add(face, Ids(face.begin(), face.end()), face.size() - 1, (*roots)[kRoot]);
  }

  // Whether a point is inside of the face: 1 or -1 where it is certain, and 0 where it is not.
  int try_face(Face face, const BallDiagram::Corners& cell, const Touching<BoundedDouble>& made) const {
    const auto [discriminant, roots] = bounded_roots(made);
    if (discriminant < 0) return -1;
    return roots ? is_critical(face, cell, made, (*roots)[kRoot]) : 0;
  }

  int is_critical(Face face, const BallDiagram::Corners& cell, const Touching<BoundedDouble>& made,
                  const BoundedDouble& s) const {
    int answer = s.certain_sign();
    if (answer < 0) return -1;
    const auto take = [&answer](int sign) {
      if (sign >= 0) answer = std::min(answer, sign);
      return sign >= 0;
    };
    BoundedDouble rest(1);
    for (std::size_t k = 0; k + 1 < face.size(); ++k) {
      const BoundedDouble weight = made.u[k] + made.v[k] * s;
      if (!take(weight.certain_sign())) return -1;
      rest = rest - weight;
    }
    if (!take(rest.certain_sign())) return -1;
    const Vector3<BoundedDouble> centre = number_ball<BoundedDouble>(balls_, face[0]).center;
    const RoundedPlace place(centre + made.a + s * made.b, s, greatest_);
    const auto is_nearer = [&](std::uint32_t id) {
      return std::ranges::find(face, id) == face.end() && !take(place.side(balls_.rounded(id)));
    };
    // The cell's other corners are the nearest ones, as a rule.
    const std::size_t corners = static_cast<std::size_t>(diagram_.dimension() + 1);
    if (std::ranges::any_of(std::span(cell).first(corners), is_nearer)) return -1;
    const std::uint32_t least = least_connected(face);
    if (std::ranges::any_of(diagram_.neighbours(least), is_nearer)) return -1;
    if (answer == 0) return 0;
    // The ball with the fewest neighbours says whether another ball is nearer. One that is as near is a neighbour of
    // some ball of the face.
    for (const std::uint32_t id : face) {
      if (!balls_.tangent_inside(id).empty()) return 0;
      if (id != least && std::ranges::any_of(diagram_.neighbours(id), is_nearer)) return 0;
    }
    return answer;
  }

  // ---- Exactly ----

  void see_exactly(Face face) {
    const auto made = touching<Rational>(balls_, face);
    if (!made) return;
    const std::vector<QuadraticNumber> roots = roots_of({made->c2, made->c1, made->c0});
    if (!roots.empty()) see_root(face, *made, roots[kRoot]);
  }

  void see_root(Face face, const Touching<Rational>& made, const QuadraticNumber& s) {
    if (s.sign() < 0) return;
    QuadraticNumber rest = Rational(1);
    for (std::size_t k = 0; k + 1 < face.size(); ++k) {
      const QuadraticNumber weight = QuadraticNumber(made.u[k]) + QuadraticNumber(made.v[k]) * s;
      if (weight.sign() <= 0) return;
      rest = rest - weight;
    }
    if (rest.sign() <= 0) return;
    ExactPlace place;
    place.s = s;
    place.x = lifted(number_ball<Rational>(balls_, face[0]).center + made.a) + s * lifted(made.b);
    place.near_s = bounded(s);
    place.near_x = {bounded(place.x.x), bounded(place.x.y), bounded(place.x.z)};
    for (const std::uint32_t id : diagram_.neighbours(least_connected(face))) {
      if (side(place, id) < 0) return;
    }
    const Ids contacts = contacts_of(face, place);
    if (const std::optional<std::size_t> index = index_of(face, contacts)) {
      add(face, contacts, *index, place.near_s);
    }
  }

  int side(const ExactPlace& place, std::uint32_t id) const {
    const int sign = excess(place.near_x, place.near_s, number_ball<BoundedDouble>(balls_, id)).certain_sign();
    if (sign != 0) return sign;
    const auto& [x, y, z, r] = balls_.scaled(id);
    return excess<QuadraticNumber>(place.x, place.s, {{x, y, z}, r}).sign();
  }

  Ids contacts_of(Face face, const ExactPlace& place) const {
    Ids contacts(face.begin(), face.end()), seen = contacts;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      for (const std::uint32_t id : diagram_.neighbours(contacts[k])) {
        if (std::ranges::find(seen, id) != seen.end()) continue;
        seen.push_back(id);
        if (side(place, id) == 0) contacts.push_back(id);
      }
    }
    return with_hidden(balls_, contacts, [&](std::uint32_t id) { return side(place, id) == 0; });
  }

  // The index, if the point is in the relative interior of the contacts' hull. It is inside of the face. So it is, iff
  // the other contacts, projected to what is orthogonal to the face, are a linear subspace's positive span.
  std::optional<std::size_t> index_of(Face face, const Ids& contacts) const {
    const std::size_t dimension = face.size() - 1;
    const auto centre = [&](std::uint32_t id) { return number_ball<Rational>(balls_, id).center; };
    const Vector3<Rational> o = centre(face[0]);
    std::vector<Vector3<Rational>> across;
    for (const std::uint32_t id : contacts) {
      Vector3<Rational> w = centre(id) - o;
      if (dimension == 1) {
        const Vector3<Rational> e = centre(face[1]) - o;
        w = w - Rational(dot(w, e) / dot(e, e)) * e;
      } else if (dimension == 2) {
        const Vector3<Rational> n = cross(centre(face[1]) - o, centre(face[2]) - o);
        w = Rational(dot(w, n) / dot(n, n)) * n;
      } else {
        break;
      }
      if (w.x != 0 || w.y != 0 || w.z != 0) across.push_back(w);
    }
    if (across.empty()) return dimension;
    // Some vector, one that is opposite to it or not parallel, and on both sides of it something.
    const Vector3<Rational>& first = across[0];
    bool is_line = true, has_opposite = false;
    for (const Vector3<Rational>& w : across) {
      const Vector3<Rational> n = cross(first, w);
      if (n.x != 0 || n.y != 0 || n.z != 0) is_line = false;
      if (dot(first, w) < 0) has_opposite = true;
    }
    if (is_line) return has_opposite ? std::optional(dimension + 1) : std::nullopt;
    for (const Vector3<Rational>& edge : across) {
      // If all are in a half-plane, it can be turned until its line is along one of them.
      bool is_left = false, is_right = false;
      const Vector3<Rational> axis = centre(face[1]) - o;
      for (const Vector3<Rational>& w : across) {
        const Rational turn = dot(cross(edge, w), axis);
        is_left = is_left || turn > 0;
        is_right = is_right || turn < 0;
      }
      if (!(is_left && is_right)) return std::nullopt;
    }
    return 3;
  }

  // ---- Results ----

  void add(Face face, Ids contacts, std::size_t index, const BoundedDouble& near) {
    std::array<std::uint32_t, 4> carrier{};
    std::ranges::copy(face, carrier.begin());
    found_.push_back({static_cast<std::uint8_t>(index), std::move(contacts), carrier,
                      static_cast<std::uint8_t>(face.size()), BallLevel(carrier, face.size(), kRoot, near)});
  }

  // Of a point inside of a face, in roots_of(): half of the power's derivative by s is the sum of the weights times
  // -(r + s), which is negative, and at this root it is minus the root of the discriminant.
  static constexpr std::size_t kRoot = 0;

  const BallDiagram& diagram_;
  const BallSet& balls_;
  const double greatest_;
  std::vector<FaceKey> faces_;
  std::vector<BallCriticalPoint> found_;
};

}  // namespace

std::vector<BallCriticalPoint> ball_critical_points(const BallDiagram& diagram, unsigned threads) {
  constexpr std::size_t kIdsAtOnce = 64;
  const std::span<const std::uint32_t> ids = diagram.balls().visible();
  double greatest = 0;
  for (const std::uint32_t id : ids) {
    for (const double number : diagram.balls().rounded(id)) greatest = std::max(greatest, std::fabs(number));
  }
  std::vector<std::vector<BallCriticalPoint>> parts((ids.size() + kIdsAtOnce - 1) / kIdsAtOnce);
  geometry::parallel_for(parts.size(), threads, [&](std::size_t part) {
    const std::size_t first = part * kIdsAtOnce;
    parts[part] = Search(diagram, greatest).run(ids.subspan(first, std::min(kIdsAtOnce, ids.size() - first)));
  });
  // Where more balls are equally far, a point is inside of several faces.
  std::vector<BallCriticalPoint> all;
  std::set<Ids> seen;
  for (std::vector<BallCriticalPoint>& part : parts) {
    for (BallCriticalPoint& point : part) {
      if (seen.insert(point.contacts).second) all.push_back(std::move(point));
    }
  }
  return all;
}

}  // namespace flowcert::morse
