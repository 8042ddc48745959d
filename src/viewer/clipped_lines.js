// The lines of U2 as segments, clipped to three times the input's box: orbits to infinity end where they leave it.
// The data end each line at its first vertex outside; here it is cut.
// Lines that meet share what follows, and each shared segment is drawn once.

import { none } from './point_numbers.js';

const most = 3;

// How far along the way from a coordinate inside to another one the box ends, 0 to 1; 1 if that is inside, too.
const exit = (from, to) => (to > most ? (most - from) / (to - from) : to < -most ? (-most - from) / (to - from) : 1);

export class ClippedLines {
  constructor(u2) {
    this.u2 = u2;
    this.seen = new Uint32Array(u2.next.length);
    this.turn = 0;
    this.buffer = new Float32Array(6 * u2.next.length);
  }

  // Six coordinates for each segment of the lines, on the sides that go to infinity, or not, or on all.
  segments(lines, infinite = null) {
    const { starts, limits } = this.u2;
    ++this.turn;
    this.place = 0;
    for (const line of lines)
      for (const end of [2 * line, 2 * line + 1])
        if (infinite === null || infinite === (limits[end] === none)) this.follow(starts[end]);
    return this.buffer.slice(0, this.place);
  }

  follow(start) {
    const { seen, turn, buffer } = this;
    const { vertices, next } = this.u2;
    let place = this.place;
    for (let a = start; next[a] !== none && seen[a] !== turn; a = next[a]) {
      seen[a] = turn;
      const [i, j] = [3 * a, 3 * next[a]];
      const [x, y, z] = [vertices[i], vertices[i + 1], vertices[i + 2]];
      const [u, v, w] = [vertices[j], vertices[j + 1], vertices[j + 2]];
      const t = Math.max(0, Math.min(exit(x, u), exit(y, v), exit(z, w)));
      buffer[place] = x;
      buffer[place + 1] = y;
      buffer[place + 2] = z;
      buffer[place + 3] = t < 1 ? x + t * (u - x) : u;
      buffer[place + 4] = t < 1 ? y + t * (v - y) : v;
      buffer[place + 5] = t < 1 ? z + t * (w - z) : w;
      place += 6;
      if (t < 1) break;
    }
    this.place = place;
  }
}
