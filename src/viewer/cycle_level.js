// The level at which the loop or the void of the picked pair is drawn: a slider from birth to death, and what is drawn.
// Where there is none, nothing of it is seen.

import { picked_cycle } from './cycles.js';
import { count_text } from './words.js';

export class CycleLevel {
  constructor({ root, slider, line }, complex, state) {
    Object.assign(this, { root, slider, line, complex, state });
    slider.addEventListener('input', () => state.change({ level: Number(slider.value) }));
  }

  update() {
    const { complex, state, slider } = this;
    const cycle = picked_cycle(complex, state);
    this.root.hidden = !cycle;
    if (!cycle) return;
    const { pair, level, least } = cycle;
    const [birth, death] = [complex.birth_squared(pair), complex.death_squared(pair)];
    const distance = complex.length_text(Math.sqrt(birth + (level / 100) * (death - birth)));
    Object.assign(slider, { min: least, value: level });
    slider.setAttribute('aria-valuetext', `${level}%, distance ${distance}`);
    const surfaces = cycle.pieces.length === 1 ? '1 surface' : `${count_text(cycle.pieces.length)} surfaces`;
    const what =
      complex.pairs.dimension[pair] === 1
        ? `a loop of ${count_text(cycle.edges.length)} edges, filled by ${surfaces}`
        : `a void within ${surfaces}`;
    this.line.textContent = `Level ${level}%, distance ${distance} input units: ${what}`;
  }
}
