#include "cli/glossary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <ranges>
#include <vector>

#include "cli/wrapped_text.h"

namespace flowcert::cli {

namespace {

constexpr auto kEntries = std::to_array<GlossaryEntry>({
    {"accepted", "An outcome: the program answered an input that has to be refused."},
    {"ambiguous", "A finding: several stationary points are within the tolerance of what is claimed."},
    {"approximate", "A grade of a claim: it has decimals, which are right within the tolerance."},
    {"ball-not-empty", "A finding: another point lies inside of the sphere, so that its centre is not critical."},
    {"birth", "The distance at which a component, tunnel or void begins as balls around all points grow."},
    {"born-earlier", "A finding: a loop stands for a tunnel that is born before the claimed birth."},
    {"boundary", "Of a saddle of index 2: the saddles of index 1 around its stable surface."},
    {"cavity",
     "A pocket that a probe cannot leave: every way to infinity is narrower somewhere. Between balls: a part of the "
     "free space that is closed all around."},
    {"cell",
     "Of a pocket: all places from which the flow comes to its maxima. Of Delaunay: a simplex, or what "
     "cospherical points span."},
    {"chamber",
     "Between balls: a room apart, from where it is widest, its peak, down to its gate. For a probe it is open, closed "
     "or too small."},
    {"channel", "A pocket that a probe can leave through several mouths."},
    {"choices at ties",
     "Where several ways lead on equally, an orbit or a boundary takes one of them. Pairs do not "
     "depend on that."},
    {"claim", "What a program says a flow complex is; check judges it."},
    {"claimed-twice", "A finding: one critical point is claimed two times."},
    {"cluster", "Points of which five or more lie on one empty sphere, or four on the sphere of a saddle."},
    {"collision-as-critical",
     "A finding: a point where critical points of two indices meet and vanish is claimed as "
     "critical, in a way that no small motion of the points explains."},
    {"component", "A class of dimension 0: a part that is apart from others."},
    {"conforms", "A verdict: all that is claimed and judged is right."},
    {"contact set", "The points nearest to a place: all that lie on the largest empty ball around it."},
    {"contact-incomplete", "A finding: more points lie on the sphere than the claim names."},
    {"corner", "An end of a segment or an interval, or a vertex of a sector or a sheet; it can be at infinity."},
    {"cospherical", "Of points: on one sphere. Of five or more such points a Delaunay triangulation is not unique."},
    {"crashed", "An outcome: the program ended by a signal, or could not be started."},
    {"critical point",
     "A place where the distance to the nearest points has no direction of growth: it lies inside the "
     "hull of its contact set."},
    {"death", "The distance at which a component joins an older one, or a tunnel or a void is filled."},
    {"dependent", "A finding: a cycle is a sum of other claimed ones, so that it stands for no further pair."},
    {"depth",
     "Of a pocket: the radius of its largest ball less that of its widest mouth. Of a chamber: its peak less its "
     "gate."},
    {"diagram", "All persistence pairs, as places with birth and death."},
    {"dies-earlier", "A finding: a loop is filled before the claimed death."},
    {"dies-later", "A finding: a loop is not filled yet at the claimed death."},
    {"dimension", "Of a pair: 0 for components, 1 for tunnels, 2 for voids."},
    {"driver",
     "The point of the hull of the nearest points that is nearest to a place. The flow leads straight away "
     "from it."},
    {"edge-too-long", "A finding: half an edge of a loop is longer than the level, so that it leaves the balls."},
    {"exit", "Of a chamber: the radius of the widest probe that can leave it to the outside."},
    {"flow", "It leads from each place to where the distance to the nearest points grows fastest."},
    {"free space", "Between balls: all places where the centre of a probe can be."},
    {"gabriel",
     "Of an edge or triangle of Delaunay: its smallest sphere has no other point inside. These have the "
     "critical points of index 1 and 2."},
    {"gate",
     "A saddle of index 2 at which a way out of a pocket is narrowest. Of a chamber: the radius at which it stops "
     "being a room apart."},
    {"handle", "A narrow place with one and the same chamber at both sides."},
    {"hidden", "Of a ball: inside of another one, so that nothing changes without it."},
    {"hull", "The smallest convex set that has the points: an edge, triangle, tetrahedron, or a larger polytope."},
    {"index",
     "The dimension of the hull of a critical point's contact set: 0 for points, 1 and 2 for saddles, 3 for "
     "maxima."},
    {"kind", "Of a regular stationary point: the indices that meet in it, as 1-2. Of a finding: its reason."},
    {"largest cavity diameter", "Between balls: twice the peak of a chamber, or the greatest one of all."},
    {"largest cavity radius", "The radius of the largest ball in some pocket."},
    {"length", "Of a pair: its death less its birth, as distances that are not squared."},
    {"level", "How much of a claim is judged: its form (1), points (2, 3), incidences (4), and all else (5)."},
    {"limit", "The stationary point at which an orbit ends, or infinity."},
    {"lining",
     "Of a pocket: the points, or atoms, that are nearest to some place in it. Of a cavity between balls: those that "
     "the probe can touch there."},
    {"malformed", "A finding: the claim contradicts its input or itself."},
    {"maxima at the outside", "Maxima that are too shallow for a pocket and lead outside."},
    {"maximum", "A critical point of index 3: the centre of a ball that can grow nowhere. Several are maxima."},
    {"merged by persistence", "Maxima that are not deeper than the persistence are one pocket with a neighbour."},
    {"merged duplicate", "A row that repeats another one. Both are one point, with the first row as its name."},
    {"missed-by-cluster",
     "A finding: a critical point is missing where more points lie on one sphere than a simplex "
     "has. Programs that assume general position miss it."},
    {"missing", "A finding: a critical point that the claim does not have."},
    {"morse-smale", "Of a flow complex: all connections lead to the next index, so that no tie had to be broken."},
    {"mouth", "A saddle of index 2 that leads out of a pocket, to another one or outside."},
    {"not-a-cycle", "A finding: edges that do not close, or triangles."},
    {"not-cospherical", "A finding: the points that are named lie on no common sphere centred in their hull."},
    {"orbit", "The way of the flow from a place: straight segments, to a stationary point or to infinity."},
    {"outside", "What is open to infinity, beyond all pockets and chambers."},
    {"outside-hull", "A finding: the centre lies outside of the hull of its points, as in an obtuse triangle."},
    {"pair", "A critical point at which a component, tunnel or void begins, and the one at which it ends."},
    {"pairs of length zero", "Regular stationary points stand for them: what begins and ends at one value."},
    {"peak", "Of a chamber: the radius of the widest probe that has room in it."},
    {"persistence",
     "How long components (dimension 0), tunnels (1) and voids (2) last as balls around all points grow. Where a "
     "command takes it as a number, what does not last longer is merged or left out."},
    {"perturbed", "A verdict: right for points that are moved a little, not for these."},
    {"plain",
     "Of a distance: not squared. What people read is plain; it is the radius of balls, half the length of an edge."},
    {"pocket",
     "What flows to some maxima: a room between points. For a probe, one of three kinds: a cavity has no way out that "
     "is wide enough, a pocket has one mouth, a channel several."},
    {"pore limiting diameter", "Between balls: twice the exit of a chamber, or the greatest one of all."},
    {"pore limiting radius", "The radius of the widest ball that can leave some pocket to infinity."},
    {"probe",
     "A ball, by its centre's distance to all points. Between atoms of radius 1.7, water needs 3.1. With radii, by its "
     "distance to all balls: water needs 1.4."},
    {"profile", "The parts of a flow complex that a claim tells, such as points, U2 and S2."},
    {"radius",
     "Of a pocket: that of the largest ball in it that has no point inside. Of a mouth: of the widest ball that fits "
     "through."},
    {"record", "The place of a stationary point in the list of all, from 0, as compute -o writes it."},
    {"refused", "An outcome: the program gave no answer to an input that has one, and said so."},
    {"regular stationary point",
     "A place where critical points of neighbouring indices meet and vanish, as the midpoint "
     "of a right triangle's hypotenuse: stationary, and not critical."},
    {"residue", "A part of a molecule with a name and a number, as GLY 27 of chain A."},
    {"rounding", "A finding: wrong by no more than the rounding of decimals explains."},
    {"s1", "The stable manifold of a saddle of index 1: its edge."},
    {"s2", "The stable manifold of a saddle of index 2: a surface around it, made of what flows to it."},
    {"s3", "The stable manifold of a maximum: the volume of all that flows to it."},
    {"saddle", "A critical point of index 1 (on an edge) or 2 (in a triangle)."},
    {"sample", "A point of the input. Rows with equal coordinates are one sample."},
    {"shares", "Of a maximum: how much of its volume lies in the Voronoi cell of each sample."},
    {"signature",
     "Of an input in a campaign: how it is degenerate, such as clusters and ties. Of a complex: its counts."},
    {"skeleton", "The part of a stable manifold on Voronoi facets, edges and vertices. It tells all of it."},
    {"spacing", "The median, over all points, of the distance to the nearest other point."},
    {"spanning-part", "A permitted variation: the claim names some of the points on a sphere, which span the same."},
    {"squared",
     "Of a distance: in its square. Exact distances are roots, and their squares are rational, so files have those."},
    {"stable manifold", "All places from which the flow comes to a critical point."},
    {"stationary point", "A place that the flow does not leave: a critical or a regular stationary point."},
    {"surface-boundary", "A finding: a surface that does not end at its loop."},
    {"symbolic-perturbation", "A permitted variation: right for points that are moved a little, as many programs do."},
    {"tie",
     "Where the flow comes to a saddle, or several ways lead on equally. One is taken; pairs do not depend on it."},
    {"tie-break", "A permitted variation: where several boundaries are possible, the claim has another one."},
    {"timed-out", "An outcome: the program took longer than its time limit, and was ended."},
    {"tolerance",
     "How far a claimed decimal may be off, in parts of a radius or of itself. What is combinatorial has none."},
    {"touching", "Of balls: with one place in common, from outside. With more, they overlap."},
    {"triangle-too-large", "A finding: the smallest ball of a triangle is larger than the level."},
    {"tunnel",
     "A class of dimension 1: a way through, as through a ring or a tube. It is born as the ring closes, and dies "
     "where balls fill its narrowest place."},
    {"u1", "The unstable manifold of a saddle of index 1: a surface, all that flows from it."},
    {"u2", "The unstable manifold of a saddle of index 2: the two orbits that leave it."},
    {"unanswered", "An outcome: a case that was asked has no answer."},
    {"unreadable", "An outcome: the answer is in no form that a claim may have."},
    {"unstable manifold", "All places to which the flow comes from near a critical point."},
    {"valley", "The least bin between two heaps of a histogram. auto takes it for a threshold."},
    {"value",
     "Of a place: the square of the distance from there to the nearest sample. With radii: the distance to the nearest "
     "ball, which is not squared."},
    {"verdict", "What check says of a claim: conforms, conforms where determined, perturbed, or fails."},
    {"vestibule", "A room that is no listed chamber, and comes to two or more rooms at one radius."},
    {"void", "A class of dimension 2: a hollow that is closed all around."},
    {"volume",
     "Of a pocket: of its cell, which reaches up to the points, so that it is more than what a probe can fill."},
    {"widest", "Of a pocket: the narrowest place of its widest way to infinity."},
    {"window",
     "A narrowest place between a chamber and another room or the outside. Its radius is that of the widest probe "
     "that fits through."},
    {"wrong-components", "A finding: other components than those that come together at a death."},
    {"wrong-connections", "A finding: other numbers of orbits between stationary points."},
    {"wrong-counts", "A finding: a number of points, critical points or samples is not right, or the Euler sum."},
    {"wrong-incidence", "A finding: a saddle's orbits end, or its boundary lies, elsewhere than claimed."},
    {"wrong-index", "A finding: there is a critical point, of another index."},
    {"wrong-lambda-list", "A finding: directions from a saddle lead elsewhere, or in another order."},
    {"wrong-pair", "A finding: the persistence pairs have one more, one less, or another."},
    {"wrong-pocket", "A finding: other maxima, mouths, cells, depths, paths or radii of a pocket."},
    {"wrong-polyline", "A finding: an orbit does not go where the claim's line goes."},
    {"wrong-position", "A finding: a centre or a distance is off by more than rounding explains."},
    {"wrong-surface", "A finding: a stable surface has other pieces."},
    {"wrong-unstable-set", "A finding: an unstable surface has other parts."},
    {"wrong-void", "A finding: a void has other maxima, cells or walls at its level."},
    {"wrong-volume", "A finding: the volume of a stable manifold is another one."},
});

// Letters and digits alone, without an s at the end: "Stable-Manifolds" is "stablemanifold".
std::string key_of(std::string_view word) {
  std::string key;
  for (const char c : word) {
    if (c >= 'A' && c <= 'Z') key += static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) key += c;
  }
  if (key.size() > 3 && key.ends_with('s')) key.pop_back();
  return key;
}

}  // namespace

std::span<const GlossaryEntry> glossary() { return kEntries; }

const GlossaryEntry* entry_of(std::string_view word) {
  const std::string key = key_of(word);
  const auto found =
      std::ranges::find_if(kEntries, [&](const GlossaryEntry& entry) { return key_of(entry.word) == key; });
  return found == kEntries.end() ? nullptr : &*found;
}

std::string nearest_words(std::string_view word) {
  const std::string key = key_of(word);
  std::vector<std::string_view> words;
  for (const GlossaryEntry& entry : kEntries) {
    const std::string other = key_of(entry.word);
    const bool is_part = !key.empty() && (other.find(key) != std::string::npos || key.find(other) != std::string::npos);
    if (is_part) words.emplace_back(entry.word);
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string words_of_glossary() {
  const auto words = kEntries | std::views::transform(&GlossaryEntry::word);
  return wrapped(fmt::format("{}", fmt::join(words, ", ")), 0);
}

}  // namespace flowcert::cli
