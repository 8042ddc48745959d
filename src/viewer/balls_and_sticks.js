// Atoms as small balls, and sticks between them. Each is two triangles on which the fragment shader draws it round, so
// that large molecules can be turned. What is far away fades into the background.

import {
  BufferAttribute,
  DoubleSide,
  Group,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  Mesh,
  ShaderMaterial,
  Vector2,
  Vector3,
} from 'three';
import { ball_radii, joined_atoms } from './atoms.js';
import { components } from './palette.js';
import { lit } from './shading.js';

const fade = `
uniform vec3 haze;
uniform vec2 reach;
vec3 faded(vec3 color, float away) {
  return mix(color, haze, 0.62 * clamp((away - reach.x) / (reach.y - reach.x), 0.0, 1.0));
}`;

const ball_vertex = `
attribute vec3 center;
attribute float radius;
attribute vec3 tint;
varying vec3 v_center;
varying vec3 v_place;
varying vec3 v_tint;
varying float v_radius;
void main() {
  vec3 c = (modelViewMatrix * vec4(center, 1.0)).xyz;
  vec3 toward = normalize(-c);
  vec3 right = normalize(cross(vec3(0.0, 1.0, 0.0), toward));
  float away = dot(c, c);
  float outline = radius * sqrt(away / max(away - radius * radius, 1e-6 * away));
  v_place = c + outline * (position.x * right + position.y * cross(toward, right));
  v_center = c;
  v_radius = radius;
  v_tint = tint;
  gl_Position = projectionMatrix * vec4(v_place, 1.0);
}`;

const ball_fragment = `
uniform mat4 projectionMatrix;
varying vec3 v_center;
varying vec3 v_place;
varying vec3 v_tint;
varying float v_radius;
${fade}
${lit}
void main() {
  vec3 ray = normalize(v_place);
  float along = dot(ray, v_center);
  float inside = v_radius * v_radius - dot(v_center, v_center) + along * along;
  if (inside < 0.0) discard;
  vec3 at = ray * (along - sqrt(inside));
  vec4 clip = projectionMatrix * vec4(at, 1.0);
  gl_FragDepth = clamp(0.5 * clip.z / clip.w + 0.5, 0.0, 1.0);
  gl_FragColor = vec4(faded(lit(v_tint, (at - v_center) / v_radius, -ray), -at.z), 1.0);
}`;

const stick_vertex = `
attribute vec3 from;
attribute vec3 to;
attribute vec3 tint;
attribute vec3 far_tint;
uniform float thickness;
varying vec3 v_place;
varying vec3 v_side;
varying vec3 v_front;
varying vec3 v_tint;
varying vec3 v_far_tint;
varying vec2 v_at;
void main() {
  vec3 a = (modelViewMatrix * vec4(from, 1.0)).xyz;
  vec3 b = (modelViewMatrix * vec4(to, 1.0)).xyz;
  vec3 axis = normalize(b - a);
  vec3 p = mix(a, b, 0.5 + 0.5 * position.y);
  v_side = normalize(cross(axis, p) + vec3(1e-7, 0.0, 0.0));
  v_front = cross(v_side, axis);
  if (dot(v_front, p) > 0.0) v_front = -v_front;
  v_at = position.xy;
  v_tint = tint;
  v_far_tint = far_tint;
  v_place = p + thickness * position.x * v_side;
  gl_Position = projectionMatrix * vec4(v_place, 1.0);
}`;

const stick_fragment = `
varying vec3 v_place;
varying vec3 v_side;
varying vec3 v_front;
varying vec3 v_tint;
varying vec3 v_far_tint;
varying vec2 v_at;
${fade}
${lit}
void main() {
  vec3 n = normalize(v_side * v_at.x + v_front * sqrt(max(0.0, 1.0 - v_at.x * v_at.x)));
  vec3 color = v_at.y < 0.0 ? v_tint : v_far_tint;
  gl_FragColor = vec4(faded(lit(color, n, normalize(-v_place)), -v_place.z), 1.0);
}`;

const corners = Float32Array.of(-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0);

function squares(attributes, material, count) {
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(corners, 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  for (const [name, [numbers, size]] of Object.entries(attributes))
    geometry.setAttribute(name, new InstancedBufferAttribute(numbers, size));
  geometry.instanceCount = count;
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}

export class BallsAndSticks {
  constructor(complex) {
    const { sticks, near } = joined_atoms(complex);
    Object.assign(this, { complex, sticks, count: complex.sample_count, stick_count: sticks.length / 2 });
    this.radii = ball_radii(complex, near);
    this.uniforms = { haze: { value: new Vector3() }, reach: { value: new Vector2(1, 2) } };
    const material = (vertexShader, fragmentShader, uniforms = {}) =>
      new ShaderMaterial({
        vertexShader,
        fragmentShader,
        side: DoubleSide,
        uniforms: { ...this.uniforms, ...uniforms },
      });
    this.balls = squares(this.of_balls(), material(ball_vertex, ball_fragment), this.count);
    const thickness = { thickness: { value: 0.09 * near } };
    this.rods = squares(this.of_sticks(), material(stick_vertex, stick_fragment, thickness), this.stick_count);
    this.object = new Group();
    this.object.add(this.balls, this.rods);
  }

  of_balls() {
    const { complex, count } = this;
    return {
      center: [complex.positions.subarray(0, 3 * count), 3],
      radius: [this.radii, 1],
      tint: [new Float32Array(3 * count), 3],
    };
  }

  of_sticks() {
    const { positions } = this.complex;
    const ends = (side) =>
      new Float32Array(
        Array.from({ length: this.stick_count }, (_, i) => this.sticks[2 * i + side]).flatMap((sample) => [
          ...positions.subarray(3 * sample, 3 * sample + 3),
        ]),
      );
    const tints = () => [new Float32Array(3 * this.stick_count), 3];
    return { from: [ends(0), 3], to: [ends(1), 3], tint: tints(), far_tint: tints() };
  }

  paint(palette) {
    const { complex, sticks } = this;
    const colors = new Map();
    const tint_of = (sample) => {
      const symbol = complex.atoms?.symbol(sample) ?? '';
      if (!colors.has(symbol)) colors.set(symbol, components(palette.elements[symbol] ?? palette.elements.other));
      return colors.get(symbol);
    };
    const fill = (mesh, name, sample_of) => {
      const attribute = mesh.geometry.attributes[name];
      for (let i = 0; i < attribute.count; ++i) attribute.setXYZ(i, ...tint_of(sample_of(i)));
      attribute.needsUpdate = true;
    };
    fill(this.balls, 'tint', (i) => i);
    fill(this.rods, 'tint', (i) => sticks[2 * i]);
    fill(this.rods, 'far_tint', (i) => sticks[2 * i + 1]);
    this.uniforms.haze.value.set(...components(palette.haze));
  }

  // away: how far the camera is from where it looks.
  set_distance(away) {
    this.uniforms.reach.value.set(away - 0.5, away + 1.1);
  }

  // The first ball along a ray: {sample, distance} or null.
  hit(origin, direction) {
    const { positions } = this.complex;
    let best = null;
    for (let sample = 0; sample < this.count; ++sample) {
      const [x, y, z] = [0, 1, 2].map((axis) => positions[3 * sample + axis] - origin.getComponent(axis));
      const along = x * direction.x + y * direction.y + z * direction.z;
      const inside = this.radii[sample] ** 2 - (x * x + y * y + z * z) + along * along;
      if (inside < 0 || along <= 0) continue;
      const distance = along - Math.sqrt(inside);
      if (!best || distance < best.distance) best = { sample, distance };
    }
    return best;
  }
}
