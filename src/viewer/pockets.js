// What a page with pockets has of them: which points are in them, their mouths, and their closed surfaces.
// Points come by their numbers in the program's list, pockets by their places in the page. Lengths and volumes are in
// input units.

import { decode_all } from './blobs.js';
import { positions, triangles_of } from './cells.js';
import { none } from './point_numbers.js';

const lists = ['peaks', 'maxima', 'cell', 'mouths', 'neighbours'];
const mesh = ['triangle_offsets', 'triangles', 'vertices'];

// The edges, two vertices each, that only one of the triangles in the lists has.
function outer_edges(lists) {
  const edges = new Map();
  for (const triangles of lists)
    triangles.forEach((a, i) => {
      const b = triangles[i % 3 === 2 ? i - 2 : i + 1];
      const key = `${Math.min(a, b)} ${Math.max(a, b)}`;
      edges.set(key, edges.has(key) ? null : [a, b]);
    });
  return [...edges.values()].filter(Boolean);
}

export async function load_pockets(data) {
  const [parts, surfaces, mouth_surfaces] = await Promise.all([
    decode_all(data, ['numbers', 'depth', 'volume', 'gate', 'widest', ...lists, ...lists.map((x) => `${x}_offsets`)]),
    decode_all(data.surfaces, mesh),
    decode_all(data.mouth_surfaces, ['points', ...mesh]),
  ]);
  return new Pockets(parts, surfaces, mouth_surfaces);
}

class Pockets {
  constructor(parts, surfaces, mouth_surfaces) {
    Object.assign(this, parts, { surfaces, mouth_surfaces });
    this.count = this.numbers.length;
    this.place_of = new Map(Array.from(this.numbers, (number, place) => [number, place]));
    this.mouth_place = new Map(Array.from(mouth_surfaces.points, (point, place) => [point, place]));
    this.pocket_of_point = new Map();
    this.pockets_at_mouth = new Map();
    for (let pocket = 0; pocket < this.count; ++pocket) {
      for (const point of this.list('cell', pocket)) this.pocket_of_point.set(point, pocket);
      for (const point of this.list('mouths', pocket)) {
        if (!this.pockets_at_mouth.has(point)) this.pockets_at_mouth.set(point, []);
        this.pockets_at_mouth.get(point).push(pocket);
      }
    }
    this.by_depth = Array.from(this.depth, (_, pocket) => pocket).sort((a, b) => this.depth[b] - this.depth[a]);
  }

  // name: peaks, maxima, cell, mouths or neighbours. Neighbours are pockets by their own numbers, or none.
  list(name, pocket) {
    const offsets = this[`${name}_offsets`];
    return Array.from(this[name].subarray(offsets[pocket], offsets[pocket + 1]));
  }

  // The pockets of a point of the program's list: the one that it is in, or those that it is a mouth of.
  around(number) {
    const inside = this.pocket_of_point.get(number);
    return inside !== undefined ? [inside] : (this.pockets_at_mouth.get(number) ?? []);
  }

  surface(pocket) {
    return triangles_of(this.surfaces, [pocket]);
  }

  mouth_triangles(points) {
    return triangles_of(
      this.mouth_surfaces,
      points.map((point) => this.mouth_place.get(point)),
    );
  }

  // The edges around these mouths, six coordinates for each. Mouths that are beside one another are one opening. Only
  // where openings close up, with nothing around them, each mouth has its own edges.
  mouth_outlines(points) {
    const { triangle_offsets, triangles, vertices } = this.mouth_surfaces;
    const mouths = points.map((point) => {
      const mouth = this.mouth_place.get(point);
      return triangles.subarray(3 * triangle_offsets[mouth], 3 * triangle_offsets[mouth + 1]);
    });
    const around_all = outer_edges(mouths);
    return positions(vertices, around_all.length > 0 ? around_all : mouths.flatMap((mouth) => outer_edges([mouth])));
  }

  // A neighbour by its place in the page; none for the outside, undefined where the page does not have it.
  place_of_neighbour(number) {
    return number === none ? none : this.place_of.get(number);
  }
}

// The pockets that are drawn for a picked point.
export function pockets_at(complex, point) {
  if (!complex.pockets || complex.is_sample(point)) return [];
  return complex.pockets.around(complex.number(point));
}

// The deepest pocket with a peak in the page, by its first peak; none where there is none.
export function deepest_peak(complex) {
  const { pockets } = complex;
  const peaks = pockets.by_depth.map((pocket) => complex.point_of_number(pockets.list('peaks', pocket)[0]));
  return peaks.find((point) => point !== none) ?? none;
}

// The mouths of a pocket, the widest first: those at least half as wide as the widest one, and all others.
export function mouths_by_radius(complex, pocket) {
  const radius = (number) => {
    const point = complex.point_of_number(number);
    return point === none ? 0 : complex.frame_radius(point);
  };
  const sorted = complex.pockets.list('mouths', pocket).sort((a, b) => radius(b) - radius(a));
  const least = radius(sorted[0]) / 2;
  return { wide: sorted.filter((m) => radius(m) >= least), narrow: sorted.filter((m) => radius(m) < least) };
}
