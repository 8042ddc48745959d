// A sphere that can be looked through: a shell that is seen at its rim, with three great circles.
// It stands for the ball around a stationary point that holds no sample, or for a claimed one, which is dashed and
// drawn over a true one in the same place.

import { BackSide, FrontSide, Group, Mesh, ShaderMaterial, SphereGeometry, Vector3 } from 'three';
import { LineLayer } from './line_layer.js';
import { components } from './palette.js';

// Claimed things are drawn after all true ones.
export const claim_order = 30;

const vertex_shader = `
varying vec3 n;
varying vec3 seen;
void main() {
  vec4 p = modelViewMatrix * vec4(position, 1.0);
  n = normalMatrix * normal;
  seen = p.xyz;
  gl_Position = projectionMatrix * p;
}`;

const fragment_shader = `
uniform vec3 color;
varying vec3 n;
varying vec3 seen;
void main() {
  float across = 1.0 - abs(dot(normalize(n), normalize(seen)));
  gl_FragColor = vec4(color, 0.07 + 0.5 * across * across * across);
}`;

function circles() {
  const steps = 96;
  const segments = new Float32Array(3 * steps * 6);
  let place = 0;
  for (let axis = 0; axis < 3; ++axis)
    for (let i = 0; i < steps; ++i)
      for (const k of [i, i + 1]) {
        const angle = (2 * Math.PI * k) / steps;
        segments[place + ((axis + 1) % 3)] = Math.cos(angle);
        segments[place + ((axis + 2) % 3)] = Math.sin(angle);
        place += 3;
      }
  return segments;
}

const shell = new SphereGeometry(1, 48, 32);
shell.userData.is_shared = true;

export function sphere_mark(center, radius, color, dashed = false) {
  const group = new Group();
  const uniforms = { color: { value: new Vector3(...components(color)) } };
  for (const side of [BackSide, FrontSide]) {
    const material = new ShaderMaterial({
      vertexShader: vertex_shader,
      fragmentShader: fragment_shader,
      uniforms,
      side,
      transparent: true,
      depthWrite: false,
    });
    group.add(new Mesh(shell, material));
  }
  const claimed = { width: 2.6, dash: 0.09, lifted: true, order: claim_order };
  const lines = new LineLayer(dashed ? claimed : { width: 1.4 });
  lines.paint(color);
  lines.show(circles());
  group.add(lines.object);
  group.position.set(...center);
  group.scale.setScalar(Math.max(radius, 1e-6));
  return group;
}
