// Line segments of one colour: a few of them two pixels wide, many of them as thin lines, which are drawn faster.
// `show` takes an array of segments, six coordinates each. Lines with an `order` come after what can be seen through.

import { BufferAttribute, BufferGeometry, Color, Group, LineBasicMaterial, LineSegments } from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';

const most_wide = 6000;

export class LineLayer {
  // dash: the length of one, or 0; faint: with an order, what is behind is seen; lifted: drawn before what is in the
  // same place.
  constructor({ width = 2, dash = 0, on_top = false, lifted = false, order = 0, faint = false } = {}) {
    this.options = { width, dash, on_top, lifted, order, faint };
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
    this.object.renderOrder = this.options.order || (this.options.on_top ? 10 : 0);
  }

  wide(segments) {
    const { width, dash, on_top, lifted, order, faint } = this.options;
    const material = new LineMaterial({ linewidth: width, dashed: dash > 0, dashSize: dash, gapSize: dash * 0.75 });
    material.color.copy(this.color);
    material.depthTest = !on_top;
    Object.assign(material, { transparent: order > 0, opacity: faint ? 0.3 : 1 });
    if (lifted) Object.assign(material, { polygonOffset: true, polygonOffsetFactor: -4, polygonOffsetUnits: -16 });
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(segments);
    const line = new LineSegments2(geometry, material);
    if (dash > 0) line.computeLineDistances();
    line.frustumCulled = false;
    line.renderOrder = order || (on_top ? 10 : 0);
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
