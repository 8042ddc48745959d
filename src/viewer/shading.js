// The light on surfaces, balls and sticks, as a function of their shaders: `lit(color, n, eye)`, of unit vectors in the
// space of the camera.

export const lit = `
vec3 lit(vec3 color, vec3 n, vec3 eye) {
  float key = max(0.0, dot(n, normalize(vec3(0.35, 0.75, 0.6))));
  float fill = max(0.0, dot(n, normalize(vec3(-0.8, -0.1, 0.5))));
  float rim = pow(1.0 - max(0.0, dot(n, eye)), 3.0);
  return color * (0.34 + 0.62 * key) + color * vec3(0.10, 0.14, 0.22) * fill + vec3(0.10) * rim;
}`;
