// Line segments of one colour: a few of them two pixels wide, many of them as thin lines, which are drawn faster.
// `show` takes an array of segments, six coordinates each.

import { BufferAttribute, BufferGeometry, Color, Group, LineBasicMaterial, LineSegments } from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';

const most_wide = 6000;

export class LineLayer {
  constructor({ width = 2, dashed = false, on_top = false } = {}) {
    this.options = { width, dashed, on_top };
    this.object = new Group();
    this.color = new Color();
    this.count = 0;
  }

  paint(color) {
    this.color.set(color);
    for (const line of this.object.children) line.material.color.copy(this.color);
  }

  show(segments) {
    for (const line of this.object.children) {
      line.geometry.dispose();
      line.material.dispose();
    }
    this.object.clear();
    this.count = segments.length / 6;
    if (this.count > 0) this.object.add(this.count <= most_wide ? this.wide(segments) : this.thin(segments));
    this.object.renderOrder = this.options.on_top ? 10 : 0;
  }

  wide(segments) {
    const { width, dashed, on_top } = this.options;
    const material = new LineMaterial({ linewidth: width, dashed, dashSize: 0.03, gapSize: 0.02 });
    material.color.copy(this.color);
    material.depthTest = !on_top;
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(segments);
    const line = new LineSegments2(geometry, material);
    if (dashed) line.computeLineDistances();
    line.frustumCulled = false;
    line.renderOrder = on_top ? 10 : 0;
    return line;
  }

  thin(segments) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(segments, 3));
    const line = new LineSegments(geometry, new LineBasicMaterial({ color: this.color }));
    line.frustumCulled = false;
    return line;
  }
}
