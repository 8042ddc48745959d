// Triangles of some sets, shaded without normals: the fragment shader takes the slope of the depth.
// The index buffer has room for all triangles and is filled anew when other sets are shown, so that a slider is live.
// Triangles have no orientation, so both sides look the same.

import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, ShaderMaterial, Vector3 } from 'three';
import { components } from './palette.js';
import { lit } from './shading.js';

const vertex_shader = `
varying vec3 seen;
void main() {
  vec4 p = modelViewMatrix * vec4(position, 1.0);
  seen = p.xyz;
  gl_Position = projectionMatrix * p;
}`;

const fragment_shader = `
uniform vec3 color;
uniform float opacity;
uniform float glow;
varying vec3 seen;
${lit}
void main() {
  vec3 n = normalize(cross(dFdx(seen), dFdy(seen)));
  vec3 eye = normalize(-seen);
  if (dot(n, eye) < 0.0) n = -n;
  gl_FragColor = vec4(mix(lit(color, n, eye), color, glow), opacity);
}`;

// A mesh of triangles that are given by their positions, nine numbers each.
export function mesh_of_positions(positions) {
  const all = Uint32Array.from({ length: positions.length / 3 }, (_, i) => i);
  return mesh_of_triangles(new BufferAttribute(positions, 3), all);
}

// A mesh of all these triangles of an attribute's positions.
export function mesh_of_triangles(positions, triangles) {
  const mesh = new SurfaceMesh(positions, Uint32Array.of(0, triangles.length / 3), triangles);
  mesh.show([0]);
  return mesh;
}

export class SurfaceMesh {
  // offsets: of the triangles of each set; triangles: vertices of attribute `positions`.
  constructor(positions, offsets, triangles) {
    this.offsets = offsets;
    this.triangles = triangles;
    this.index = new BufferAttribute(new Uint32Array(triangles.length), 1);
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute('position', positions);
    this.geometry.setIndex(this.index);
    this.material = new ShaderMaterial({
      vertexShader: vertex_shader,
      fragmentShader: fragment_shader,
      side: DoubleSide,
      uniforms: { color: { value: new Vector3() }, opacity: { value: 1 }, glow: { value: 0 } },
    });
    this.object = new Mesh(this.geometry, this.material);
    this.object.frustumCulled = false;
    this.show(new Uint32Array(0));
  }

  paint(color) {
    this.material.uniforms.color.value.set(...components(color));
  }

  set_opacity(opacity) {
    this.material.uniforms.opacity.value = opacity;
    this.material.transparent = opacity < 1;
    this.material.depthWrite = opacity === 1;
  }

  // The part of the colour that no light changes.
  set_glow(glow) {
    this.material.uniforms.glow.value = glow;
  }

  show(sets) {
    let place = 0;
    const { offsets, triangles } = this;
    const all = this.index.array;
    for (const set of sets) {
      const [from, to] = [3 * offsets[set], 3 * offsets[set + 1]];
      for (let i = from; i < to; ++i) all[place++] = triangles[i];
    }
    this.sets = sets;
    this.count = place / 3;
    this.geometry.setDrawRange(0, place);
    this.index.clearUpdateRanges();
    this.index.addUpdateRange(0, place);
    this.index.needsUpdate = true;
    this.object.visible = place > 0;
  }
}
