// What scripts and tests may call, as window.flowcert: counts, timings, what is drawn, and what a user can do.
// Points are named {sample: n} or {record: n}, by their places in the data of src/cli/manual/view.md; pairs and
// triangles by theirs. Distances, their squares and persistence are in the frame.

import { Vector3 } from 'three';
import { rational_text } from './exact_sphere.js';
import { group_of } from './findings.js';
import { none } from './point_numbers.js';
import { most } from './shown.js';

export function test_interface(page) {
  const { complex, state, actions } = page;
  const point = ({ sample, record }) => (sample !== undefined ? sample : complex.sample_count + record);
  const name = (p) =>
    p === none ? null : complex.is_sample(p) ? { sample: p } : { record: p - complex.sample_count };
  const box = (id) => document.getElementById(id).getBoundingClientRect();
  const within = (value, low, high) => value >= low && value <= high;
  return {
    ready: page.ready,
    timings: page.timings,
    most,
    counts: () => ({
      points: complex.data.points,
      samples: complex.sample_count,
      by_kind: complex.kind_counts,
      pairs: [0, 1, 2].map((d) => complex.pairs.dimension.reduce((sum, x) => sum + (x === d), 0)),
      s1: complex.kind_counts[1],
      s2_sets: complex.set_count,
      s2_triangles: complex.s2.triangles.length / 3,
      s2_vertices: complex.s2.vertices.length / 3,
      u2_points: complex.u2?.record.length ?? null,
      u2_vertices: complex.u2 ? complex.u2.next.length : null,
    }),
    drawn: () => page.scene?.drawn() ?? null,
    shown: () => {
      const { points, sets, edges } = page.scene.current_view();
      const record_of = (set) => complex.s2.record[set];
      return { points: Array.from(points, name), sets: Array.from(sets, record_of), edges: Array.from(edges, name) };
    },
    // Triangles of the picked point's cell, pocket, mouths and surface U1, lines of the latter, and those around
    // mouths; triangles of the picked pair's cycle, and edges of its loop.
    marked: () => ({ ...page.scene.marked }),
    at_rest: () => page.scene === null || page.scene.is_at_rest(),
    frames: () => page.scene.frames,
    camera: () => [...page.scene.camera.position.toArray(), ...page.scene.controls.target.toArray()],
    brush_rectangle: (birth_low, birth_high, death_low, death_high) =>
      page.brush(
        (pair) =>
          within(complex.birth_squared(pair), birth_low, birth_high) &&
          within(complex.death_squared(pair), death_low, death_high),
      ),
    brush_pairs: (pairs) => {
      const all = new Set(pairs);
      page.brush((pair) => all.has(pair));
    },
    clear_brush: () => page.brush(null),
    brushed: () => state.brushed_pairs(),
    threshold: (mode, limit) => state.change({ mode, limit, brush: null }),
    limit: () => [state.mode, state.limit],
    layers: () => ({ ...state.layers }),
    set_layer: (layer, on) => state.set_layer(layer, on),
    full_detail: (full) => state.change({ full }),
    pick: (what) => actions.pick(what === null ? none : point(what)),
    pick_pair: (pair) => actions.pick_pair(pair),
    level: (percent) => state.change({ level: percent }),
    picked: () => name(state.picked),
    // How far a point is from the camera.
    away: (what) => page.scene.camera.position.distanceTo(new Vector3(...complex.frame_position(point(what)))),
    exact: (what) => {
      const { center, squared } = complex.exact(point(what));
      return { center: center.map(rational_text), squared_distance: rational_text(squared) };
    },
    radius: (what) => complex.frame_radius(point(what)),
    pair_of: (what) => complex.pair_of[point(what)],
    pixel_of: (what) => {
      const [x, y] = page.scene.pixel_of(point(what));
      return [x + box('scene').left, y + box('scene').top];
    },
    diagram_pixel_of: (pair) => {
      const [x, y] = page.diagram.pixel_of(pair);
      return [x + box('diagram').left, y + box('diagram').top];
    },
    redraw_now: () => page.scene.draw(),
    line_ends: () => page.line_ends(),
    line_bounds: () => page.scene.line_bounds(),
    finding: (i) => actions.finding(i),
    finding_groups: () => (complex.data.claim?.findings ?? []).map(group_of),
    geometries: () => page.scene.renderer.info.memory.geometries,
    claim_marks: () => page.scene.claims.children.length,
    save_picture: () => page.picture(),
  };
}
