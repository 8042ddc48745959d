// What is drawn, computed from the complex and the state: points, S1, S2, U2, and samples as balls.
// Brushed pairs show exactly their points and the S2 of these, whatever the threshold is. It does not touch balls.
// Otherwise the threshold decides: distance below it, or persistence above it.
// The thinned view, unless pairs are brushed, keeps at most `most` of each. What has the shortest persistence is left
// out first, and is counted.

import { none, regular_kind } from './point_numbers.js';

export const most = { triangles: 100000, points: 20000, lines: 5000 };

const layer_of_kind = ['samples', 'index1', 'index2', 'index3', 'regular'];

// Whether the threshold, or the brush, keeps a point.
function keeper(complex, state) {
  if (state.brush) return (point) => complex.pair_of[point] !== none && state.brush[complex.pair_of[point]] === 1;
  if (state.mode === 'persistence') return (point) => complex.persistence_of(point) > state.limit || state.limit < 0;
  const squared = state.limit * state.limit;
  return (point) => state.limit === Infinity || complex.squared[point] < squared;
}

// The `count` items of largest weight, in their old order.
function heaviest(items, count, weight) {
  if (items.length <= count) return items;
  const order = Float64Array.from(items, weight).sort();
  const limit = order[items.length - count];
  let ties = count - order.reduce((sum, value) => sum + (value > limit), 0);
  return items.filter((item) => {
    const w = weight(item);
    return w > limit || (w === limit && ties-- > 0);
  });
}

function shown_points(complex, state, keeps) {
  const points = new Uint32Array(complex.point_count);
  const on = layer_of_kind.map((layer) => state.brush !== null || state.layers[layer]);
  let count = 0;
  for (let point = 0; point < complex.point_count; ++point)
    if (on[complex.kind[point]] && keeps(point)) points[count++] = point;
  return points.slice(0, count);
}

function shown_edges(complex, state, keeps) {
  if (!state.layers.s1) return new Uint32Array(0);
  const points = new Uint32Array(complex.kind_counts[1]);
  let count = 0;
  for (let point = complex.sample_count; point < complex.point_count; ++point)
    if (complex.kind[point] === 1 && keeps(point)) points[count++] = point;
  return points.slice(0, count);
}

function kept_sets(complex, keeps) {
  const sets = new Uint32Array(complex.set_count);
  let count = 0;
  for (let set = 0; set < complex.set_count; ++set) if (keeps(complex.set_point[set])) sets[count++] = set;
  return sets.slice(0, count);
}

export function triangle_count(offsets, sets) {
  let count = 0;
  for (const set of sets) count += offsets[set + 1] - offsets[set];
  return count;
}

// Drops the sets of shortest persistence until the triangles fit.
export function fitting_sets(complex, offsets, sets) {
  if (triangle_count(offsets, sets) <= most.triangles) return sets;
  const order = Array.from(sets).sort((a, b) => complex.set_persistence[b] - complex.set_persistence[a]);
  let left = most.triangles;
  const kept = order.filter((set) => {
    const size = offsets[set + 1] - offsets[set];
    if (size > left) return false;
    left -= size;
    return true;
  });
  return Uint32Array.from(kept).sort();
}

// {points, edges, sets, flat, line_sets, balls, thinned}: `flat` says that sets are drawn as polygons.
export function shown(complex, state, polygons) {
  const keeps = keeper(complex, state);
  const all = {
    points: shown_points(complex, state, keeps),
    edges: shown_edges(complex, state, keeps),
    sets: state.layers.s2 || state.brush ? kept_sets(complex, keeps) : new Uint32Array(0),
  };
  const lines = state.layers.u2 || state.layers.infinity ? kept_sets(complex, keeps) : new Uint32Array(0);
  const balls = complex.has_balls && state.layers.atoms && !state.brush;
  const result = { ...all, flat: false, line_sets: lines, balls, thinned: null };
  const triangles = triangle_count(complex.s2.triangle_offsets, all.sets);
  if (state.full || state.brush) return { ...result, triangles };
  const weight = (point) => complex.persistence_of(point);
  result.points = heaviest(all.points, most.points, weight);
  result.edges = heaviest(all.edges, most.points, weight);
  result.line_sets = heaviest(lines, most.lines, (set) => complex.set_persistence[set]);
  result.flat = triangles > most.triangles;
  if (result.flat) result.sets = fitting_sets(complex, polygons().offsets, all.sets);
  const dropped = {
    points: all.points.length - result.points.length,
    edges: all.edges.length - result.edges.length,
    sets: all.sets.length - result.sets.length,
    lines: lines.length - result.line_sets.length,
  };
  const thinned = result.flat || Object.values(dropped).some((count) => count > 0);
  return { ...result, triangles, thinned: thinned ? { ...dropped, of: all } : null };
}

// The points that belong to a set of records, for counts by kind.
export function counts_by_kind(complex, points) {
  const counts = new Array(regular_kind + 1).fill(0);
  for (const point of points) ++counts[complex.kind[point]];
  return counts;
}
