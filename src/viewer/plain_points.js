// Positions and squared distances of points that the page's data leave out, because they follow from two or three
// samples: critical points of index 1 and 2 with contact sets of a simplex. In doubles, in the frame, as squares of
// input units may be too large or too small for doubles; what is exact comes from exact_sphere.js.

import { exact_sphere, nearest_double, parts_of_double } from './exact_sphere.js';

const least_normal = 2 ** -1022;

// The circumcentre of three points, relative to the first one.
function center_from_first(ax, ay, az, bx, by, bz, to) {
  const [aa, bb] = [ax * ax + ay * ay + az * az, bx * bx + by * by + bz * bz];
  const [nx, ny, nz] = [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
  const below = 2 * (nx * nx + ny * ny + nz * nz) || 1;
  const [wx, wy, wz] = [aa * bx - bb * ax, aa * by - bb * ay, aa * bz - bb * az];
  to[0] = (wy * nz - wz * ny) / below;
  to[1] = (wz * nx - wx * nz) / below;
  to[2] = (wx * ny - wy * nx) / below;
}

// A squared distance of the data, in the frame. The data's double is inf, 0 or inexact where coordinates are extreme.
function framed_square(value, unit, contact_positions) {
  if (value >= least_normal && value < Infinity) return value / unit / unit;
  const { n, d } = exact_sphere(contact_positions()).squared;
  const { mantissa, exponent } = parts_of_double(unit);
  const below = d * mantissa * mantissa;
  const power = BigInt(2 * Math.abs(exponent));
  return nearest_double(exponent < 0 ? { n: n << power, d: below } : { n, d: below << power });
}

// Fills positions (three floats each) and squared distances of all records, in the frame; those that are not plain
// are in the data, in order. Returns the samples in the frame.
export function fill_records({ samples, origin, unit, records, positions, squared }) {
  const { face, hull, contact_offsets, contacts } = records;
  // The difference is at most the unit, so it does not overflow, and far from 0 it keeps all digits.
  const framed = Float64Array.from(samples, (value, i) => (value - origin[i % 3]) / unit);
  const offset = [0, 0, 0];
  let listed = 0;
  for (let i = 0; i < face.length; ++i) {
    const from = contact_offsets[i];
    const plain =
      face[i] === hull[i] && (face[i] === 1 || face[i] === 2) && contact_offsets[i + 1] - from === face[i] + 1;
    if (!plain) {
      for (let axis = 0; axis < 3; ++axis) positions[3 * i + axis] = records.positions[3 * listed + axis];
      squared[i] = framed_square(records.squared[listed++], unit, () =>
        Array.from(contacts.subarray(from, contact_offsets[i + 1]), (sample) =>
          Array.from(samples.subarray(3 * sample, 3 * sample + 3)),
        ),
      );
      continue;
    }
    const [p, q, r] = [3 * contacts[from], 3 * contacts[from + 1], 3 * contacts[from + face[i]]];
    const [ax, ay, az] = [framed[q] - framed[p], framed[q + 1] - framed[p + 1], framed[q + 2] - framed[p + 2]];
    if (face[i] === 1) [offset[0], offset[1], offset[2]] = [ax / 2, ay / 2, az / 2];
    else {
      const [bx, by, bz] = [framed[r] - framed[p], framed[r + 1] - framed[p + 1], framed[r + 2] - framed[p + 2]];
      center_from_first(ax, ay, az, bx, by, bz, offset);
    }
    for (let axis = 0; axis < 3; ++axis) positions[3 * i + axis] = framed[p + axis] + offset[axis];
    squared[i] = offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2];
  }
  if (listed !== records.squared.length)
    throw new Error('The data of this page are damaged: some records are left over.');
  return framed;
}

// The vertices of U2, in the frame: each is its next one, or the origin, and so many steps further.
export function line_vertices({ next, step, steps }) {
  const places = new Float64Array(3 * next.length);
  const vertices = new Float32Array(3 * next.length);
  for (let i = 0; i < next.length; ++i)
    for (let axis = 0; axis < 3; ++axis) {
      const code = steps[3 * i + axis];
      const way = code % 2 === 0 ? code / 2 : -(code + 1) / 2;
      const at = (next[i] < i ? places[3 * next[i] + axis] : 0) + way;
      places[3 * i + axis] = at;
      vertices[3 * i + axis] = at * step;
    }
  return vertices;
}
