// The lines of U2 as segments, clipped to three times the input's box: orbits to infinity end where they leave it.
// Lines that meet share what follows, and each shared segment is drawn once.

import { none } from './complex.js';

const most = 3;

// How far along the segment from a (inside) to b the box ends, 0 to 1; 1 if b is inside.
function exit(vertices, a, b) {
  let t = 1;
  for (let axis = 0; axis < 3; ++axis) {
    const from = vertices[3 * a + axis];
    const to = vertices[3 * b + axis];
    if (to > most) t = Math.min(t, (most - from) / (to - from));
    else if (to < -most) t = Math.min(t, (-most - from) / (to - from));
  }
  return t;
}

export class ClippedLines {
  constructor(u2) {
    this.u2 = u2;
    this.seen = new Uint32Array(u2.next.length);
    this.turn = 0;
  }

  // Calls visit(a, b, t) for each segment of the lines, t telling where it is cut.
  walk(lines, visit, sides = [0, 1]) {
    const { vertices, next, starts } = this.u2;
    ++this.turn;
    for (const line of lines)
      for (const side of sides)
        for (let a = starts[2 * line + side]; next[a] !== none && this.seen[a] !== this.turn; a = next[a]) {
          this.seen[a] = this.turn;
          const t = exit(vertices, a, next[a]);
          visit(a, next[a], t);
          if (t < 1) break;
        }
  }

  segments(lines, sides) {
    const { vertices } = this.u2;
    let count = 0;
    this.walk(lines, () => ++count, sides);
    const result = new Float32Array(6 * count);
    let place = 0;
    this.walk(
      lines,
      (a, b, t) => {
        for (let axis = 0; axis < 3; ++axis) {
          const [from, to] = [vertices[3 * a + axis], vertices[3 * b + axis]];
          result[place + axis] = from;
          result[place + 3 + axis] = t < 1 ? from + t * (to - from) : to;
        }
        place += 6;
      },
      sides,
    );
    return result;
  }
}
