// What a page with cells has of the whole complex: volumes, connections, the faces of cells S3, and the surfaces U1.
// Faces are stored once, and each cell is made of those that it has a side of. What is drawn is given as positions,
// nine for a triangle and six for a line, so that nothing is shared with other layers.

import { decode_all } from './blobs.js';
import { none } from './point_numbers.js';

export async function load_cells(data) {
  const [parts, faces, u1] = await Promise.all([
    decode_all(data, ['volumes', 'offsets', 'to', 'orbits', 'families', 'drawn']),
    decode_all(data.faces, ['between', 'triangle_offsets', 'triangles', 'vertices']),
    decode_all(data.u1, ['record', 'sheet_offsets', 'corner_offsets', 'corners', 'line_offsets', 'lines', 'vertices']),
  ]);
  return new Cells(parts, faces, u1);
}

class Cells {
  constructor(parts, faces, u1) {
    Object.assign(this, parts, { faces, u1 });
    this.is_drawn = new Set(this.drawn);
    this.surface_of = new Map(Array.from(u1.record, (record, i) => [record, i]));
    this.faces_of = this.joined_faces();
  }

  // [{face, beyond}] by the number of each cell in the program's list: its faces, and what is beyond them, or none.
  joined_faces() {
    const { between } = this.faces;
    const found = new Map();
    const add = (cell, face, beyond) => {
      if (cell === none) return;
      if (!found.has(cell)) found.set(cell, []);
      found.get(cell).push({ face, beyond });
    };
    for (let face = 0; 2 * face < between.length; ++face) {
      const [a, b] = [between[2 * face], between[2 * face + 1]];
      add(a, face, b);
      add(b, face, a);
    }
    return found;
  }

  connections(record) {
    const { offsets, to, orbits, families } = this;
    const found = [];
    for (let i = offsets[record]; i < offsets[record + 1]; ++i)
      found.push({ number: to[i], orbits: orbits[i], families: families[i] });
    return found;
  }

  // The triangles of some faces.
  triangles(faces) {
    return triangles_of(this.faces, faces);
  }

  surface(record) {
    const i = this.surface_of.get(record);
    if (i === undefined) return null;
    const { sheet_offsets, corner_offsets, corners, line_offsets, lines, vertices } = this.u1;
    const [sheets, outlines] = [[], []];
    for (let sheet = sheet_offsets[i]; sheet < sheet_offsets[i + 1]; ++sheet) {
      const around = corners.subarray(corner_offsets[sheet], corner_offsets[sheet + 1]);
      for (let k = 2; k < around.length; ++k) sheets.push([around[0], around[k - 1], around[k]]);
      around.forEach((corner, k) => outlines.push([corner, around[(k + 1) % around.length]]));
    }
    return {
      sheets: positions(vertices, sheets),
      outlines: positions(vertices, outlines),
      lines: positions(vertices, [lines.subarray(2 * line_offsets[i], 2 * line_offsets[i + 1])]),
      sheet_count: sheet_offsets[i + 1] - sheet_offsets[i],
    };
  }
}

// Nine coordinates for each triangle of these parts of a mesh.
export function triangles_of({ triangle_offsets, triangles, vertices }, parts) {
  const range = (part) => triangles.subarray(3 * triangle_offsets[part], 3 * triangle_offsets[part + 1]);
  return positions(vertices, parts.map(range));
}

// Three coordinates for each vertex of the lists.
export function positions(vertices, lists) {
  const all = new Float32Array(3 * lists.reduce((sum, list) => sum + list.length, 0));
  let place = 0;
  for (const list of lists)
    for (const vertex of list) {
      all.set(vertices.subarray(3 * vertex, 3 * vertex + 3), place);
      place += 3;
    }
  return all;
}

// The area of triangles that are given by their positions.
export function area_of(triangles) {
  let twice = 0;
  for (let i = 0; i < triangles.length; i += 9) {
    const [a, b] = [3, 6].map((k) => [0, 1, 2].map((axis) => triangles[i + k + axis] - triangles[i + axis]));
    twice += Math.hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  }
  return twice / 2;
}
