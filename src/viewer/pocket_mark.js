// Pockets as they are drawn where they are picked: solid where they are seen, and through what is before them as well.
// Mouths that are at least half as wide as the widest one of the pocket stand out, with lines around them.
// The depth is cleared between the two, so that of the pocket itself only the nearest wall is seen through the rest.

import { Group, Mesh } from 'three';
import { LineLayer } from './line_layer.js';
import { mouths_by_radius } from './pockets.js';
import { mesh_of_positions } from './surface_mesh.js';

const orders = { depth: 5, through: 6, mouths: 7, outlines: 8 };

export class PocketMark {
  constructor(complex, pockets, palette) {
    Object.assign(this, { complex, palette, object: new Group(), triangles: 0, mouths: 0, outlines: 0 });
    const { pockets: all } = complex;
    this.add_walls(pockets.map((pocket) => all.surface(pocket)));
    for (const pocket of pockets) {
      const { wide, narrow } = mouths_by_radius(complex, pocket);
      this.add_mouths(all.mouth_triangles(wide), 0.5);
      this.add_mouths(all.mouth_triangles(narrow), 0.08);
      this.add_outlines(all.mouth_outlines(wide));
    }
  }

  add_walls(surfaces) {
    const walls = this.mesh(joined(surfaces), 'pockets');
    if (!walls) return;
    this.triangles = walls.count;
    const again = (order, opacity) => {
      const material = walls.material.clone();
      Object.assign(material, { transparent: true, depthWrite: order === orders.depth });
      material.uniforms.opacity.value = opacity;
      const mesh = new Mesh(walls.geometry, material);
      Object.assign(mesh, { renderOrder: order, frustumCulled: false });
      this.object.add(mesh);
      return mesh;
    };
    const depth = again(orders.depth, 0);
    depth.material.colorWrite = false;
    depth.onBeforeRender = (renderer) => renderer.clearDepth();
    again(orders.through, 0.6);
  }

  add_mouths(positions, opacity) {
    const mouths = this.mesh(positions, 'mouths');
    if (!mouths) return;
    this.mouths += mouths.count;
    mouths.set_opacity(opacity);
    mouths.object.renderOrder = orders.mouths;
    Object.assign(mouths.material, { polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -8 });
  }

  // What the pocket itself hides of the lines is thin and faint.
  add_outlines(segments) {
    this.outlines += segments.length / 6;
    const { outlines: order } = orders;
    for (const options of [
      { width: 3, lifted: true, order },
      { width: 1, on_top: true, faint: true, order },
    ]) {
      const lines = new LineLayer(options);
      lines.paint(this.palette.outline);
      lines.show(segments);
      this.object.add(lines.object);
    }
  }

  mesh(positions, color) {
    if (positions.length === 0) return null;
    const mesh = mesh_of_positions(positions);
    mesh.paint(this.palette[color]);
    mesh.set_glow(0.45);
    this.object.add(mesh.object);
    return mesh;
  }
}

function joined(arrays) {
  const all = new Float32Array(arrays.reduce((sum, array) => sum + array.length, 0));
  let place = 0;
  for (const array of arrays) {
    all.set(array, place);
    place += array.length;
  }
  return all;
}
