// The threshold below the histogram: of what it is, a slider on the histogram's axis, and how many surfaces it keeps.
// At one end the slider keeps all: Infinity for radii, -1 for persistence.

import { element, fill } from './element.js';
import { count_text } from './words.js';

const modes = [
  ['radius', 'Radius below'],
  ['persistence', 'Persistence above'],
];

export const no_limit = (mode) => (mode === 'radius' ? Infinity : -1);
export const keeps_all = (limit) => limit === Infinity || limit < 0;

export class Threshold {
  constructor({ choice, slider, line }, complex, state, actions, histogram) {
    Object.assign(this, { slider, line, complex, state, actions, histogram });
    this.buttons = modes.map(([mode, text]) =>
      element(
        'button',
        { role: 'radio', 'data-mode': mode, click: () => actions.mode(mode), keydown: (event) => this.key(event) },
        text,
      ),
    );
    fill(choice, this.buttons);
    slider.addEventListener('input', () => this.slide(Number(slider.value) / 1000));
    this.update();
  }

  slide(part) {
    const { mode } = this.state;
    const at_end = mode === 'radius' ? part === 1 : part === 0;
    this.actions.threshold(at_end ? no_limit(mode) : this.histogram.value_at(part));
  }

  key(event) {
    if (!event.key.startsWith('Arrow')) return;
    this.actions.mode(this.state.mode === 'radius' ? 'persistence' : 'radius');
    this.buttons.find((button) => button.dataset.mode === this.state.mode).focus();
    event.preventDefault();
  }

  update() {
    const { state, slider } = this;
    for (const button of this.buttons) {
      const chosen = button.dataset.mode === state.mode;
      button.setAttribute('aria-checked', String(chosen));
      button.tabIndex = chosen ? 0 : -1;
    }
    slider.value = Math.round(1000 * this.histogram.part_of(state.limit));
    const text = this.limit_text();
    slider.setAttribute('aria-valuetext', text);
    this.line.textContent = `${this.kept_sets()}: ${text}`;
  }

  limit_text() {
    const { mode, limit } = this.state;
    if (keeps_all(limit)) return 'all';
    if (mode === 'radius') return `distance below ${this.complex.length_text(limit)} input units`;
    return `persistence above ${this.complex.length_text(limit)} input units`;
  }

  kept_sets() {
    const { complex, state } = this;
    const values = state.mode === 'radius' ? complex.set_radius : complex.set_persistence;
    let kept = 0;
    for (const value of values)
      kept += keeps_all(state.limit) || (state.mode === 'radius' ? value < state.limit : value > state.limit);
    return `${count_text(kept)} of ${count_text(complex.set_count)} surfaces`;
  }
}
