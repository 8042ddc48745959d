// All points of the complex as one Points object, drawn through an index of those that are shown.
// The shape tells the kind, the size the distance: the square root of distance / largest distance.
// Sizes are in pixels of the style sheet, so that points can be seen and hit at any zoom.

import { BufferAttribute, BufferGeometry, Points, ShaderMaterial, Vector3 } from 'three';
import { components } from './palette.js';

export const vertex_shader = `
attribute float kind;
attribute float size;
uniform float pixel_ratio;
uniform float enlarged;
uniform float reference;
varying float v_kind;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * seen;
  gl_Position.z -= 0.0006 * gl_Position.w;
  float near = clamp(reference / max(0.001, -seen.z), 0.6, 2.5);
  gl_PointSize = (size * sqrt(near) + enlarged) * pixel_ratio;
  v_kind = kind;
}`;

const fragment_shader = `
uniform vec3 colors[5];
uniform vec3 outline;
uniform float ring;
uniform float dashed;
varying float v_kind;
float shape(vec2 p, int kind) {
  vec2 a = abs(p);
  if (kind == 1) return max(a.x, a.y) - 0.72;
  if (kind == 2) return max(a.x * 0.866 + (p.y + 0.2) * 0.5, -p.y - 0.2) - 0.48;
  if (kind == 3) return length(p) * (1.0 + 0.22 * cos(5.0 * atan(p.x, p.y) + 3.14159)) - 0.78;
  if (kind == 4) return a.x + a.y - 0.95;
  return length(p) - 0.85;
}
void main() {
  vec2 p = vec2(2.0, -2.0) * (gl_PointCoord - 0.5);
  int kind = int(v_kind + 0.5);
  float d = ring > 0.5 ? abs(length(p) - 0.82) - 0.13 : shape(p, kind);
  if (d > 0.0 || (dashed > 0.5 && fract(atan(p.y, p.x) * 1.2732) > 0.6)) discard;
  vec3 color = kind == 0 ? colors[0] : kind == 1 ? colors[1] : kind == 2 ? colors[2] : colors[3];
  if (kind == 4) color = colors[4];
  gl_FragColor = vec4(ring < 0.5 && d > -0.16 && kind > 0 ? mix(color, outline, 0.75) : color, 1.0);
}`;

export function point_material() {
  return new ShaderMaterial({
    vertexShader: vertex_shader,
    fragmentShader: fragment_shader,
    uniforms: {
      colors: { value: [0, 1, 2, 3, 4].map(() => new Vector3()) },
      outline: { value: new Vector3() },
      pixel_ratio: { value: 1 },
      enlarged: { value: 0 },
      reference: { value: 3 },
      ring: { value: 0 },
      dashed: { value: 0 },
    },
  });
}

export function paint_points(material, palette) {
  palette.kinds.forEach((color, kind) => material.uniforms.colors.value[kind].set(...components(color)));
  material.uniforms.outline.value.set(...components(palette.paper));
}

export class PointCloud {
  constructor(complex) {
    const sizes = new Float32Array(complex.point_count);
    const largest = complex.largest_squared || 1;
    const few = complex.point_count < 2000;
    for (let i = 0; i < sizes.length; ++i) {
      const part = Math.sqrt(Math.sqrt(Math.min(1, complex.squared[i] / largest)));
      sizes[i] = complex.is_sample(i) ? (few ? 9 : 2.5) : (few ? 9 : 4) + 12 * part;
    }
    this.positions = new BufferAttribute(complex.positions, 3);
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute('position', this.positions);
    this.geometry.setAttribute('kind', new BufferAttribute(complex.kind, 1));
    this.geometry.setAttribute('size', new BufferAttribute(sizes, 1));
    this.material = point_material();
    this.object = new Points(this.geometry, this.material);
    this.object.frustumCulled = false;
    this.show(new Uint32Array(0));
  }

  show(points) {
    this.shown = points;
    this.geometry.setIndex(new BufferAttribute(points, 1));
    this.object.visible = points.length > 0;
  }
}
