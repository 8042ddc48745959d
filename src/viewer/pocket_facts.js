// What a page with pockets says of them: of the picked point's pocket, and as a table of all that the page has.
// `button` makes what picks a point by its number in the program's list.

import { none } from './complex.js';
import { element, fill } from './element.js';
import { nearest_double } from './exact_sphere.js';
import { mouths_by_radius } from './pockets.js';
import { count_text, short_number } from './words.js';

const most_listed = 24;

const of_units = (value, unit) => [
  element('span', { class: 'value' }, `≈ ${short_number(value)}`),
  ' ',
  element('span', { class: 'unit' }, unit),
];

function fact(name, ...text) {
  return element('div', { class: 'row' }, element('dt', {}, name), element('dd', {}, text));
}

function chips(points, button) {
  const rest = points.length - most_listed;
  return element(
    'div',
    { class: 'chips' },
    points.slice(0, most_listed).map((point) => button(point)),
    rest > 0 ? element('span', { class: 'muted' }, `and ${count_text(rest)} more`) : null,
  );
}

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
      fact('depth', of_units(pockets.depth[pocket], 'input units, a difference of radii')),
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
  if (!complex.pockets || complex.is_sample(point)) return null;
  const number = complex.number(point);
  const around = complex.pockets.around(number);
  if (around.length === 0) return null;
  const is_mouth = !complex.pockets.pocket_of_point.has(number);
  const intro = is_mouth ? element('p', { class: 'line' }, 'It is a mouth of these, which are drawn:') : null;
  return [intro, around.map((pocket) => facts_of(complex, pocket, button))];
}

export function pockets_line({ data }) {
  if (!data.pockets) return null;
  const { numbers, of, persistence } = data.pockets;
  const chosen = numbers.count < of ? ', the deepest (view --most-pockets)' : '';
  const count = numbers.count < of ? `${count_text(numbers.count)} of ${count_text(of)}` : count_text(of);
  return (
    'A pocket is what flows to some maxima, merged by persistence; its mouths are points of index 2 that lead out. ' +
    'It is drawn for a picked point in it, or at a mouth. ' +
    `The page has ${count} pockets${chosen}, merged by a persistence of ${shortened_fraction(persistence)}.`
  );
}

function shortened_fraction(text) {
  if (text.length <= 24) return text;
  const [n, d] = text.split('/').map(BigInt);
  return `about ${short_number(nearest_double({ n, d: d ?? 1n }))}`;
}

// The table of all pockets, the deepest first, some rows a page.
export class PocketTable {
  constructor(root, complex, actions) {
    Object.assign(this, { root, complex, actions, shown: most_listed });
  }

  open() {
    const { pockets } = this.complex;
    if (!pockets) return fill(this.root, element('p', { class: 'empty' }, 'Loading.'));
    if (pockets.count === 0) return fill(this.root, element('p', { class: 'empty' }, 'There is no pocket here.'));
    const rest = pockets.count - this.shown;
    const heads = ['pocket', 'depth', 'volume', 'mouths', 'widest'];
    fill(
      this.root,
      element(
        'div',
        { class: 'table-scroll', tabindex: 0, role: 'region', 'aria-label': 'Table of pockets' },
        element(
          'table',
          {},
          element('caption', {}, 'In input units; a depth is a difference of radii. The deepest come first.'),
          element('thead', {}, element('tr', {}, heads.map((head) => element('th', { scope: 'col' }, head)))),
          element('tbody', {}, pockets.by_depth.slice(0, this.shown).map((pocket) => this.row(pocket))),
        ),
      ),
      rest > 0
        ? element('button', { class: 'quiet', id: 'more-pockets', click: () => this.show_more() }, `${count_text(rest)} more`)
        : null,
    );
  }

  show_more() {
    this.shown *= 4;
    this.open();
  }

  row(pocket) {
    const { pockets } = this.complex;
    const peak = this.complex.point_of_number(pockets.list('peaks', pocket)[0]);
    const name = count_text(pockets.numbers[pocket]);
    const pick = () => this.actions.pick(peak);
    const cell = (value) => element('td', {}, value);
    return element(
      'tr',
      {},
      element('th', { scope: 'row' }, peak === none ? name : element('button', { class: 'chip', click: pick }, name)),
      cell(short_number(pockets.depth[pocket])),
      cell(short_number(pockets.volume[pocket])),
      cell(count_text(pockets.list('mouths', pocket).length)),
      cell(short_number(pockets.widest[pocket])),
    );
  }
}
