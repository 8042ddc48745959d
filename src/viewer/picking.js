// What is under a pixel: the drawn point nearest to it, or else the ball or the S2 that is hit.
// Points behind what is hit are not seen, and are not picked. All on typed arrays, without the GPU.

import { Matrix4, Vector3 } from 'three';
import { none } from './point_numbers.js';

// The first triangle along a ray, in the frame: {set, distance} or null.
function hit_triangle(mesh, origin, direction) {
  const p = mesh.geometry.attributes.position.array;
  const { offsets, triangles } = mesh;
  let best = null;
  for (const set of mesh.sets)
    for (let i = 3 * offsets[set]; i < 3 * offsets[set + 1]; i += 3) {
      const [a, b, c] = [3 * triangles[i], 3 * triangles[i + 1], 3 * triangles[i + 2]];
      const [ux, uy, uz] = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
      const [vx, vy, vz] = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
      const [hx, hy, hz] = [
        direction.y * vz - direction.z * vy,
        direction.z * vx - direction.x * vz,
        direction.x * vy - direction.y * vx,
      ];
      const det = ux * hx + uy * hy + uz * hz;
      if (Math.abs(det) < 1e-20) continue;
      const [sx, sy, sz] = [origin.x - p[a], origin.y - p[a + 1], origin.z - p[a + 2]];
      const u = (sx * hx + sy * hy + sz * hz) / det;
      if (u < 0 || u > 1) continue;
      const [qx, qy, qz] = [sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux];
      const v = (direction.x * qx + direction.y * qy + direction.z * qz) / det;
      if (v < 0 || u + v > 1) continue;
      const distance = (vx * qx + vy * qy + vz * qz) / det;
      if (distance > 1e-6 && (best === null || distance < best.distance)) best = { set, distance };
    }
  return best;
}

// x, y: pixels of the style sheet, in the canvas; balls: null where none are drawn. Returns a point or none.
export function pick({ complex, camera, size, points, mesh, opaque, balls }, x, y, reach = 12) {
  camera.updateMatrixWorld();
  const toward = new Vector3((2 * x) / size.width - 1, 1 - (2 * y) / size.height, 0.5).unproject(camera);
  const origin = camera.position;
  const direction = toward.sub(origin).normalize();
  const surface = hit_triangle(mesh, origin, direction);
  const opaque_surface = surface && opaque ? surface.distance * 1.01 + 0.004 : Infinity;
  const any_ball = balls?.hit(origin, direction);
  const ball = any_ball && any_ball.distance < opaque_surface ? any_ball : null;
  const wall = ball ? ball.distance : opaque_surface;
  const m = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
  const p = complex.positions;
  let [best, least] = [none, Infinity];
  for (const point of points) {
    const [px, py, pz] = [p[3 * point], p[3 * point + 1], p[3 * point + 2]];
    const w = m[3] * px + m[7] * py + m[11] * pz + m[15];
    if (w <= 0) continue;
    const dx = (((m[0] * px + m[4] * py + m[8] * pz + m[12]) / w + 1) / 2) * size.width - x;
    const dy = ((1 - (m[1] * px + m[5] * py + m[9] * pz + m[13]) / w) / 2) * size.height - y;
    const off = dx * dx + dy * dy;
    if (off > reach * reach || w > wall) continue;
    // Points in front win over those behind that are about as near to the pixel.
    const cost = off + 30 * w;
    if (cost < least) [best, least] = [point, cost];
  }
  if (best !== none) return best;
  if (ball) return ball.sample;
  return surface ? complex.set_point[surface.set] : none;
}

export function pixel_of(camera, size, position) {
  camera.updateMatrixWorld();
  const v = new Vector3(...position).project(camera);
  return [((v.x + 1) / 2) * size.width, ((1 - v.y) / 2) * size.height];
}
