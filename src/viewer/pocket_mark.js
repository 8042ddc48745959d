// Pockets as they are drawn where they are picked, seen through the rest. Mouths that are at least half as wide as the
// widest one of the pocket stand out, with lines around them.

import { joined } from './joined_arrays.js';
import { mouths_by_radius } from './pockets.js';
import { SeenThrough, orders } from './seen_through.js';
import { mesh_of_positions } from './surface_mesh.js';

export class PocketMark extends SeenThrough {
  constructor(complex, pockets, palette) {
    super(palette);
    this.mouths = 0;
    const { pockets: all } = complex;
    this.add_walls(mesh_of_positions(joined(pockets.map((pocket) => all.surface(pocket)))), 'pockets');
    for (const pocket of pockets) {
      const { wide, narrow } = mouths_by_radius(complex, pocket);
      this.add_mouths(all.mouth_triangles(wide), 0.5);
      this.add_mouths(all.mouth_triangles(narrow), 0.08);
      this.add_outlines(all.mouth_outlines(wide), 3);
    }
  }

  add_mouths(positions, opacity) {
    if (positions.length === 0) return;
    const mouths = mesh_of_positions(positions);
    this.add_mesh(mouths, 'mouths');
    this.mouths += mouths.count;
    mouths.set_opacity(opacity);
    mouths.object.renderOrder = orders.mouths;
    Object.assign(mouths.material, { polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -8 });
  }
}
