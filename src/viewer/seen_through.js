// Walls that are drawn solid where they are seen, and through what is before them as well, with lines on them.
// The depth is cleared between the two, so that of the walls only the nearest one is seen through the rest.

import { Group, Mesh } from 'three';
import { LineLayer } from './line_layer.js';
import { mesh_of_positions } from './surface_mesh.js';

export const orders = { depth: 5, through: 6, mouths: 7, outlines: 8 };

export class SeenThrough {
  constructor(palette) {
    Object.assign(this, { palette, object: new Group(), triangles: 0, mouths: 0, outlines: 0 });
  }

  // Of a SurfaceMesh.
  add_walls(walls, color) {
    if (walls.count === 0) return;
    this.add_mesh(walls, color);
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

  add_mouths(positions, opacity, color = 'mouths') {
    if (positions.length === 0) return;
    const mouths = mesh_of_positions(positions);
    this.add_mesh(mouths, color);
    this.mouths += mouths.count;
    mouths.set_opacity(opacity);
    mouths.object.renderOrder = orders.mouths;
    Object.assign(mouths.material, { polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -8 });
  }

  // What the walls hide of the lines is thin and faint.
  add_outlines(segments, width) {
    this.outlines += segments.length / 6;
    const { outlines: order } = orders;
    for (const options of [
      { width, lifted: true, order },
      { width: 1, on_top: true, faint: true, order },
    ]) {
      const lines = new LineLayer(options);
      lines.paint(this.palette.outline);
      lines.show(segments);
      this.object.add(lines.object);
    }
  }

  add_mesh(mesh, color) {
    mesh.paint(this.palette[color]);
    mesh.set_glow(0.45);
    this.object.add(mesh.object);
  }
}
