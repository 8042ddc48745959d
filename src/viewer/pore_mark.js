// A chamber as it is drawn: a ball at each of its peaks, and its windows as discs, seen through the atoms. Windows that
// are at least half as wide as the widest one stand out, and the picked one does.

import { SphereGeometry } from 'three';
import { joined } from './joined_arrays.js';
import { SeenThrough } from './seen_through.js';
import { mesh_of_positions } from './surface_mesh.js';

const flat = (points) => Float32Array.from(points.flatMap((point) => point.toArray()));

export class PoreMark extends SeenThrough {
  constructor(pores, { chamber, window }, palette) {
    super(palette);
    const { peak, windows } = pores.chambers[chamber];
    const ball = new SphereGeometry(Math.max(pores.framed(peak.value), 1e-6), 64, 48).toNonIndexed();
    const balls = peak.points.map((point) => ball.clone().translate(...pores.place(point)).attributes.position.array);
    this.add_walls(mesh_of_positions(joined(balls)), 'pockets');
    const width = (place) => pores.framed(pores.windows[place].value);
    for (const place of windows) {
      const { center, rim } = pores.disc(pores.windows[place]);
      const pairs = rim.slice(1).map((point, k) => [rim[k], point]);
      const is_picked = place === window;
      const is_wide = is_picked || 2 * width(place) >= width(windows[0]);
      const triangles = flat(pairs.flatMap((pair) => [center, ...pair]));
      this.add_mouths(triangles, is_wide ? 0.6 : 0.1, is_picked ? 'highlight' : 'mouths');
      if (is_wide) this.add_outlines(flat(pairs.flat()), is_picked ? 5 : 3);
    }
  }
}
