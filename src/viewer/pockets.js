// What a page with pockets has of them: which points are in them, their mouths, and their closed surfaces.
// Points come by their numbers in the program's list, pockets by their places in the page. Lengths and volumes are in
// input units.

import { decode_all } from './blobs.js';
import { triangles_of } from './cells.js';
import { none } from './complex.js';

const lists = ['peaks', 'maxima', 'cell', 'mouths', 'neighbours'];
const mesh = ['triangle_offsets', 'triangles', 'vertices'];

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

  // A neighbour by its place in the page; none for the outside, undefined where the page does not have it.
  place_of_neighbour(number) {
    return number === none ? none : this.place_of.get(number);
  }
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
