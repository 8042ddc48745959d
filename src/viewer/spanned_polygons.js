// Each S2 as the polygon that its boundary spans, cut into triangles: what is drawn in place of S2 where there are too
// many triangles. Boundaries run along Gabriel edges, so neighbours still fit together without gaps.
// An S2 of three segments is that polygon, and keeps its form.
// Where the boundary is not one closed walk (ties, parts of dimension 3), the triangles of the S2 stay as they are.

// The closed walk along the edges that lie on one triangle only, mod 2; null where it is not one cycle.
function boundary_walk(triangles) {
  const next = new Map();
  const toggle = (a, b) => {
    const list = next.get(a);
    if (!list) next.set(a, [b]);
    else if (list.includes(b)) list.splice(list.indexOf(b), 1);
    else list.push(b);
  };
  for (let i = 0; i < triangles.length; i += 3)
    for (let k = 0; k < 3; ++k) {
      toggle(triangles[i + k], triangles[i + ((k + 1) % 3)]);
      toggle(triangles[i + ((k + 1) % 3)], triangles[i + k]);
    }
  const corners = [...next].filter(([, list]) => list.length > 0);
  if (corners.length < 3 || corners.some(([, list]) => list.length !== 2)) return null;
  const walk = [corners[0][0]];
  for (let before = -1; ;) {
    const here = walk[walk.length - 1];
    const [a, b] = next.get(here);
    const after = a === before ? b : a;
    if (after === walk[0] && walk.length > 1) break;
    if (walk.length > corners.length) return null;
    walk.push(after);
    before = here;
  }
  return walk.length === corners.length ? walk : null;
}

// Whether b is the middle of a and c, but for rounding: the index-1 point of a boundary edge.
function is_middle(p, a, b, c) {
  let [off, size] = [0, 0];
  for (let axis = 0; axis < 3; ++axis) {
    off += Math.abs(p[3 * a + axis] + p[3 * c + axis] - 2 * p[3 * b + axis]);
    size += Math.abs(p[3 * a + axis] - p[3 * c + axis]);
  }
  return off <= 1e-3 * size;
}

function samples_of(walk, p) {
  const n = walk.length;
  for (const start of [0, 1]) {
    const middles = walk.every(
      (corner, i) => i % 2 === start || is_middle(p, walk[(i + n - 1) % n], corner, walk[(i + 1) % n]),
    );
    if (n % 2 === 0 && middles) return walk.filter((_, i) => i % 2 === start);
  }
  return null;
}

function distance(p, a, b) {
  return Math.hypot(p[3 * a] - p[3 * b], p[3 * a + 1] - p[3 * b + 1], p[3 * a + 2] - p[3 * b + 2]);
}

// The corner from which the diagonals of the fan are shortest.
function best_corner(ring, p) {
  if (ring.length < 4) return 0;
  let [best, least] = [0, Infinity];
  for (let i = 0; i < ring.length; ++i) {
    let sum = 0;
    for (const corner of ring) sum += distance(p, ring[i], corner);
    if (sum < least) [best, least] = [i, sum];
  }
  return best;
}

function push_fan(triangles, ring, p) {
  const start = best_corner(ring, p);
  const at = (i) => ring[(start + i) % ring.length];
  for (let i = 2; i < ring.length; ++i) triangles.push(at(0), at(i - 1), at(i));
}

// {offsets, triangles}, of the vertices of S2: the triangles of set i are offsets[i] to offsets[i + 1].
export function spanned_polygons({ vertices, triangle_offsets, triangles }) {
  const count = triangle_offsets.length - 1;
  const offsets = new Uint32Array(Math.max(1, count + 1));
  const made = [];
  for (let set = 0; set < count; ++set) {
    const own = triangles.subarray(3 * triangle_offsets[set], 3 * triangle_offsets[set + 1]);
    const walk = boundary_walk(own);
    const ring = walk && samples_of(walk, vertices);
    if (ring && ring.length > 2) push_fan(made, ring, vertices);
    else for (const vertex of own) made.push(vertex);
    offsets[set + 1] = made.length / 3;
  }
  return { offsets, triangles: Uint32Array.from(made) };
}
