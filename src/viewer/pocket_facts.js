// What a page with pockets says of them: of the picked point's pocket, and as a table of all that the page has.
// `button` makes what picks a point by its number in the program's list.

import { clickable_row, mark_rows } from './clickable_row.js';
import { element, fill } from './element.js';
import { near_root } from './exact_sphere.js';
import { chips, fact } from './fact_parts.js';
import { number_table } from './number_table.js';
import { mouths_by_radius, pockets_at } from './pockets.js';
import { none } from './point_numbers.js';
import { count_text, short_number } from './words.js';

const of_units = (value, unit) => [
  element('span', { class: 'value' }, `≈ ${short_number(value)}`),
  ' ',
  element('span', { class: 'unit' }, unit),
];

// A pocket is picked by its first peak.
function neighbour_chips(pockets, pocket, button) {
  return element(
    'div',
    { class: 'chips' },
    pockets.list('neighbours', pocket).map((number) => {
      const place = pockets.place_of_neighbour(number);
      if (place === none) return element('span', { class: 'chip still' }, 'the outside');
      if (place === undefined) return element('span', { class: 'chip still' }, `pocket ${count_text(number)}`);
      return button(pockets.list('peaks', place)[0], `pocket ${count_text(number)}`);
    }),
  );
}

const mouths_text = ({ wide, narrow }) =>
  `${count_text(wide.length + narrow.length)} mouths, the widest first; ` +
  `${count_text(wide.length)} at least half as wide stand out: `;

function facts_of(complex, pocket, button) {
  const { pockets } = complex;
  const mouths = mouths_by_radius(complex, pocket);
  const count = (name) => count_text(pockets.list(name, pocket).length);
  return element(
    'div',
    { 'data-pocket': String(pockets.numbers[pocket]) },
    element('h4', {}, `Pocket ${count_text(pockets.numbers[pocket])}`),
    element(
      'dl',
      { class: 'exact' },
      fact('depth', of_units(pockets.depth[pocket], 'input units')),
      fact('V', of_units(pockets.volume[pocket], 'input units, cubed')),
      fact('widest', of_units(pockets.widest[pocket], 'input units, the radius of its widest path to infinity')),
    ),
    element('div', { class: 'line' }, 'Its widest path leads through ', button(pockets.gate[pocket])),
    element(
      'div',
      { class: 'line' },
      `Its peak, of ${count('maxima')} maxima: `,
      chips(pockets.list('peaks', pocket), button),
    ),
    element('div', { class: 'line' }, mouths_text(mouths), chips([...mouths.wide, ...mouths.narrow], button)),
    element('div', { class: 'line' }, 'It is beside: ', neighbour_chips(pockets, pocket, button)),
  );
}

// The parts of the section on a point, or null.
export function pocket_facts(complex, point, button) {
  const around = pockets_at(complex, point);
  if (around.length === 0) return null;
  const is_mouth = !complex.pockets.pocket_of_point.has(complex.number(point));
  const intro = is_mouth ? element('p', { class: 'line' }, 'It is a mouth of these, which are drawn:') : null;
  return [intro, around.map((pocket) => facts_of(complex, pocket, button))];
}

export function pockets_line({ data }) {
  if (!data.pockets) return null;
  const { numbers, of } = data.pockets;
  const chosen = numbers.count < of ? ', the deepest (view --most-pockets)' : '';
  const count = numbers.count < of ? `${count_text(numbers.count)} of ${count_text(of)}` : count_text(of);
  return (
    'A pocket is what flows to some maxima, merged by persistence; its mouths are points of index 2 that lead out. ' +
    'It is drawn for a picked point in it, or at a mouth. ' +
    `The page has ${count} pockets deeper than ${least_depth(data.pockets)}, in input units${chosen}.`
  );
}

// Maxima are merged up to this depth; the page has its square.
function least_depth({ squared_persistence }) {
  const [n, d] = squared_persistence.split('/').map(BigInt);
  return short_number(near_root({ n, d: d ?? 1n }));
}

const caption = (pockets) =>
  `Pockets deeper than ${least_depth(pockets)}, the deepest first. Depths and widths in input units, volumes cubed.`;

// The table of all pockets, the deepest first.
export class PocketTable {
  constructor(root, complex, actions) {
    Object.assign(this, { root, complex, actions, around: [] });
  }

  // The rows of the pockets of the point stand out.
  set_picked(point) {
    const { pockets } = this.complex;
    this.around = point === none ? [] : pockets_at(this.complex, point);
    const numbers = this.around.map((pocket) => String(pockets.numbers[pocket]));
    mark_rows(this.root.querySelectorAll('tbody tr'), (row) => numbers.includes(row.dataset.pocket));
  }

  open() {
    const { pockets } = this.complex;
    if (!pockets) return fill(this.root, element('p', { class: 'empty' }, 'Loading.'));
    if (pockets.count === 0) return fill(this.root, element('p', { class: 'empty' }, 'There is no pocket here.'));
    const heads = ['pocket', 'depth', 'volume', 'mouths', 'widest'];
    const text = caption(this.complex.data.pockets);
    const words = { label: 'Table of pockets', caption: text, heads, id: 'more-pockets' };
    this.table ??= number_table(words, pockets.by_depth, (pocket) => this.row(pocket));
    fill(this.root, this.table);
  }

  row(pocket) {
    const { pockets } = this.complex;
    const peak = this.complex.point_of_number(pockets.list('peaks', pocket)[0]);
    const name = count_text(pockets.numbers[pocket]);
    const pick = peak === none ? null : () => this.actions.pick_pocket(peak);
    const cell = (value) => element('td', {}, value);
    return clickable_row(
      pick,
      { 'data-pocket': String(pockets.numbers[pocket]), 'aria-current': this.around.includes(pocket) ? 'true' : false },
      element('th', { scope: 'row' }, pick ? element('button', { class: 'chip', tabindex: -1, click: pick }, name) : name),
      cell(short_number(pockets.depth[pocket])),
      cell(short_number(pockets.volume[pocket])),
      cell(count_text(pockets.list('mouths', pocket).length)),
      cell(short_number(pockets.widest[pocket])),
    );
  }
}
