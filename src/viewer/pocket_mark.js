// Pockets as they are drawn where they are picked, seen through the rest. Mouths that are at least half as wide as the
// widest one of the pocket stand out, with lines around them.

import { joined } from './joined_arrays.js';
import { mouths_by_radius } from './pockets.js';
import { SeenThrough } from './seen_through.js';
import { mesh_of_positions } from './surface_mesh.js';

export class PocketMark extends SeenThrough {
  constructor(complex, pockets, palette) {
    super(palette);
    const { pockets: all } = complex;
    this.add_walls(mesh_of_positions(joined(pockets.map((pocket) => all.surface(pocket)))), 'pockets');
    for (const pocket of pockets) {
      const { wide, narrow } = mouths_by_radius(complex, pocket);
      this.add_mouths(all.mouth_triangles(wide), 0.5);
      this.add_mouths(all.mouth_triangles(narrow), 0.08);
      this.add_outlines(all.mouth_outlines(wide), 3);
    }
  }
}
