// What a page of balls says: a table of chambers, a table of the windows of the picked one, and facts of the picked
// window, chamber and atom. Numbers are the nearest doubles; their exact polynomials stand beside them.

import { clickable_row, mark_rows } from './clickable_row.js';
import { element, fill } from './element.js';
import { chips, exact_fact, fact, section } from './fact_parts.js';
import { number_table } from './number_table.js';
import { count_text, row_text, shortened } from './words.js';

const first = 8;
const in_bold = (value) => element('span', { class: 'value' }, String(value));
const facts = (title, rows, ...parts) => section(title, element('dl', { class: 'exact' }, rows), parts);
const several = ({ points }) => (points.length > 1 ? `, the first of ${count_text(points.length)},` : '');
const caption = 'The deepest first. Gate and exit are radii of probes, beyond the surfaces of the balls.';

// A millionth of an ångström can be seen; very small and very large lengths have five digits. null: beyond doubles.
function length_text(value) {
  if (value === null) return '∞';
  return value === 0 || (value >= 1e-2 && value < 1e6) ? value.toFixed(6) : value.toPrecision(5);
}

const value_text = (number) => (number ? length_text(number.double) : '< 0');

// "62/5", or "the greater root of 1000000 x² + 3400000 x - 16456891".
function exact_text({ polynomial: [leading, linear, constant], root }) {
  if (root === 0) return `${-BigInt(linear)}${leading === '1' ? '' : `/${leading}`}`;
  const sign = (factor) => (factor < '0' ? '-' : '+');
  const term = (factor, x) => (factor === '0' ? '' : ` ${sign(factor)} ${factor.replace('-', '')}${x}`);
  return `the ${root > 0 ? 'greater' : 'smaller'} root of ${leading} x²${term(linear, ' x')}${term(constant, '')}`;
}

export class PoreFacts {
  constructor(root, complex, state, actions) {
    Object.assign(this, { complex, state, actions, pores: complex.pores });
    this.parts = ['chambers', 'windows', 'window', 'chamber'].map((name) => element('div', { id: `pores-${name}` }));
    fill(root, this.parts);
    const { chambers, depth, probe } = this.pores;
    const heads = ['chamber', 'diameter', 'gate', 'exit', 'windows', ...(probe ? [`probe ${probe}`] : [])];
    const words = { label: 'Table of chambers', caption, heads, first };
    const none_text = `There is no chamber of depth ${depth} or more here.`;
    const none = element('p', { class: 'empty' }, none_text);
    const places = [...chambers.keys()];
    fill(this.parts[0], places.length > 0 ? number_table(words, places, (place) => this.chamber_row(place)) : none);
  }

  // Where another chamber is picked, its facts and windows are; and the picked window's.
  update({ chamber }) {
    const { pores, state, parts } = this;
    if (chamber !== undefined) {
      fill(parts[1], this.window_table(pores.chambers[chamber]));
      fill(parts[3], this.chamber_facts(pores.chambers[chamber]));
    }
    const window = pores.windows[state.window];
    fill(parts[2], window ? this.window_facts(window) : null);
    for (const part of parts)
      for (const kind of ['chamber', 'window'])
        mark_rows(part.querySelectorAll(`[data-${kind}]`), (row) => Number(row.dataset[kind]) === state[kind]);
  }

  chamber_row(place) {
    const { diameter, gate, exit, windows, is } = this.pores.chambers[place];
    const texts = [length_text(diameter), value_text(gate?.value), value_text(exit), count_text(windows.length), is];
    return this.row('chamber', place, this.actions.pick_chamber, texts.filter(Boolean));
  }

  window_row(place) {
    const { diameter, rooms, contact } = this.pores.windows[place];
    const others = rooms.filter((room) => room !== this.state.chamber).map((room) => this.pores.room_name(room));
    const atoms = contact.slice(0, 4).map((ball) => row_text(this.complex, ball));
    const texts = [length_text(diameter), others.join(', '), atoms.join(', ') + (contact.length > 4 ? ' …' : '')];
    return this.row('window', place, this.actions.pick_window, texts);
  }

  row(kind, place, pick, texts) {
    const click = () => pick(place);
    const name = element('button', { class: 'chip', tabindex: -1, click }, count_text(place));
    const picked = { [`data-${kind}`]: place, 'aria-current': place === this.state[kind] ? 'true' : false };
    const cells = texts.map((text) => element('td', {}, text));
    return clickable_row(click, picked, element('th', { scope: 'row' }, name), cells);
  }

  window_table({ windows }) {
    if (windows.length === 0) return element('p', { class: 'muted' }, 'It has no window.');
    const text = `The windows of chamber ${count_text(this.state.chamber)}, the widest first.`;
    const words = { label: 'Table of windows', caption: text, heads: ['window', 'diameter', 'to', 'atoms'], first };
    return number_table(words, windows, (place) => this.window_row(place));
  }

  chamber_facts({ peak, gate, exit, diameter, depth, is }) {
    const rows = [
      fact('diameter', in_bold(diameter)),
      this.exact('peak', peak.value),
      gate ? this.exact('gate', gate.value) : fact('gate', '< 0: its atoms overlap all around'),
      fact('depth', in_bold(depth)),
      exit ? this.exact('exit', exit) : fact('exit', '< 0'),
      this.place(peak.points[0]),
    ];
    return facts(
      `Chamber ${count_text(this.state.chamber)}${is ? `: ${is} for a probe of ${this.pores.probe}` : ''}`,
      rows,
      this.touched(`Its peak${several(peak)} touches: `, peak.points[0]),
      gate ? this.touched(`Its gate${several(gate)} touches: `, gate.points[0]) : null,
    );
  }

  window_facts(window) {
    const rooms = window.rooms.map((room) => this.pores.room_name(room)).join(' and ');
    const rows = [fact('diameter', in_bold(window.diameter)), this.exact('radius', window.value), this.place(window)];
    const title = `Window ${count_text(this.state.window)}, between ${rooms}`;
    return facts(title, rows, this.touched('It touches: ', window));
  }

  place({ center }) {
    return center.map((number, axis) => this.exact('xyz'[axis], number));
  }

  exact(name, number) {
    const text = exact_text(number);
    const shown = element('span', { class: 'near' }, shortened(text, 64));
    return exact_fact(this.actions, name, text, in_bold(number.double), shown);
  }

  touched(text, { contact }) {
    const chip = (ball) =>
      element('button', { class: 'chip', click: () => this.actions.pick(ball) }, row_text(this.complex, ball));
    return element('div', { class: 'line' }, text, chips(contact, chip));
  }
}

// Of the picked atom; without one, how to pick it.
export function atom_facts(complex, ball) {
  if (!complex.is_sample(ball)) return element('p', { class: 'empty' }, 'Pick an atom in the scene.');
  const place = complex.sample_position(ball).map((value, axis) => fact('xyz'[axis], in_bold(value)));
  const is_hidden = complex.pores.hidden.includes(ball);
  const hidden = is_hidden ? element('p', { class: 'line' }, 'It is inside another ball, and changes nothing.') : null;
  return facts(row_text(complex, ball), [fact('radius', in_bold(complex.radii[ball])), place], hidden);
}
