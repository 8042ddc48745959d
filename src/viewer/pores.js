// What a page of balls has of the chambers between them: what `pores --json` says, and places in the frame.

import { Vector3 } from 'three';

const nothing = { type: 'f32', count: 0, data: '' };
const empty = new Proxy({}, { get: () => nothing });

// Such a page has no flow complex: these parts of its data are empty.
export const no_flow = { records: empty, pairs: empty, s2: empty, u2: empty, cycles: empty };

const steps = 96;

export class Pores {
  // positions: of the centres of the balls, in the frame.
  constructor({ pores, origin, unit }, positions) {
    Object.assign(this, pores, { origin, unit, positions });
  }

  // A length or a radius, in the frame. An exact number beyond the doubles has none.
  framed(number) {
    return (number.double ?? 0) / this.unit;
  }

  place({ center }) {
    return center.map((number, axis) => ((number.double ?? 0) - this.origin[axis]) / this.unit);
  }

  // The circle of a window, in the plane of the centres of its contacts: {center, rim}, of which the last is the first.
  disc(window) {
    const [first, ...ways] = window.contact.map((ball) => new Vector3().fromArray(this.positions, 3 * ball));
    for (const way of ways) way.sub(first);
    const longest = (all) => all.reduce((a, b) => (b.lengthSq() > a.lengthSq() ? b : a));
    const across = longest(ways);
    const up = longest(ways.map((way) => across.clone().cross(way))).cross(across);
    for (const axis of [across, up]) axis.setLength(this.framed(window.value));
    const center = new Vector3(...this.place(window));
    const rim = Array.from({ length: steps + 1 }, (_, k) => {
      const angle = (2 * Math.PI * (k % steps)) / steps;
      return center.clone().addScaledVector(across, Math.cos(angle)).addScaledVector(up, Math.sin(angle));
    });
    return { center, rim };
  }

  room_name(room) {
    if (room < 0) return 'the outside';
    const chambers = this.chambers.length;
    return room < chambers ? `chamber ${room}` : `vestibule ${room - chambers}`;
  }

  // What stands for a chamber, or for one of its windows: where it is, how wide, and the balls that it touches.
  witness({ chamber, window }) {
    const { peak } = this.chambers[chamber];
    const point = this.windows[window] ?? peak.points[0];
    return { place: this.place(point), radius: this.framed(point.value ?? peak.value), contact: point.contact };
  }
}
