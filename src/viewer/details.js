// What there is to know of the picked point: kind, exact position and squared distance, contact set, where its orbits
// go and which come in, its persistence pair, and the clauses of the specification that make it what it is. Pages with
// cells also have the volume of what flows there, and where all directions lead (cell_facts.js).
// Other points that are named are buttons that pick them.

import { neighbour_table, surface_line, volume_row } from './cell_facts.js';
import { element, fill, glyph } from './element.js';
import { is_normal, nearest_double, rational_text } from './exact_sphere.js';
import { chips, exact_fact, fact, section } from './fact_parts.js';
import { pocket_facts } from './pocket_facts.js';
import { none } from './point_numbers.js';
import { clauses, count_text, digits_of, kind_name, point_name, row_text, shortened } from './words.js';

const most_listed = 24;

export class Details {
  constructor(root, complex, actions) {
    Object.assign(this, { root, complex, actions });
  }

  show(point) {
    if (point === none) return this.show_nothing();
    const { complex } = this;
    fill(
      this.root,
      element(
        'header',
        { class: 'fact-head' },
        glyph(complex.kind[point]),
        element(
          'div',
          {},
          element('h3', {}, kind_name(complex, point)),
          element('p', { class: 'muted' }, this.where(point)),
        ),
        element(
          'div',
          { class: 'head-buttons' },
          element(
            'button',
            { class: 'quiet', click: () => this.actions.approach(point), title: 'Bring it near' },
            'Go to',
          ),
          element('button', { class: 'quiet', click: () => this.actions.pick(none), title: 'Escape' }, 'Close'),
        ),
      ),
      this.exact_facts(point),
      this.contact_facts(point),
      this.flow_facts(point),
      this.volume_facts(point),
      this.connection_facts(point),
      this.pocket_facts(point),
      this.pair_facts(point),
      this.clause_facts(point),
    );
  }

  show_nothing() {
    const { complex } = this;
    const text =
      complex.point_count === 0
        ? 'This input has no point, so there is nothing to show: all counts are 0.'
        : 'Pick a point or a surface in the scene, or a pair in the diagram. What it is, and why, is said here.';
    fill(this.root, element('p', { class: 'empty' }, text));
  }

  where(point) {
    const { complex } = this;
    const atom = complex.is_sample(point) && complex.atom_name(point);
    if (atom) return `${atom} · row ${complex.sample_rows[point]} of the input, counted from 0`;
    if (complex.is_sample(point)) return `row ${complex.sample_rows[point]} of the input, counted from 0`;
    return `record ${count_text(complex.number(point))} of the list`;
  }

  exact_facts(point) {
    const { center, squared } = this.complex.exact(point);
    const near = (value) => String(nearest_double(value));
    const rows = center.map((value, axis) => this.exact_row('xyz'[axis], value, near(value), 'input units'));
    const near_squared = is_normal(squared) ? near(squared) : this.complex.squared_text(this.complex.squared[point]);
    rows.push(this.exact_row('d²', squared, near_squared, 'input units, squared'));
    const radius = this.complex.length_text(this.complex.frame_radius(point));
    rows.push(fact('d', element('span', { class: 'value' }, `≈ ${radius}`), unit('input units')));
    return section('Exact position and squared distance', element('dl', { class: 'exact' }, rows));
  }

  exact_row(name, value, decimal, units) {
    const text = rational_text(value);
    const short = shortened(text);
    const digits =
      short === text ? null : element('span', { class: 'muted' }, ` ${count_text(digits_of(text))} digits`);
    const near = value.d === 1n && short === text ? null : element('span', { class: 'near' }, `≈ ${decimal}`);
    const shown = element('span', { class: 'value' }, short);
    return exact_fact(this.actions, name, text, shown, digits, near, unit(units));
  }

  contact_facts(point) {
    const { complex } = this;
    if (complex.is_sample(point)) return null;
    const contacts = Array.from(complex.contacts(point));
    const intro = `${contacts.length} samples at distance d, the rows of the input; the sphere through them is drawn.`;
    return section(
      'Contact set',
      element('p', { class: 'muted' }, intro),
      this.buttons(contacts, (sample) => row_text(complex, sample)),
    );
  }

  buttons(points, name) {
    return chips(points, (point) => this.button(point, name(point)));
  }

  button(point, text = point_name(this.complex, point)) {
    if (point === none) return element('span', { class: 'chip still' }, '∞ infinity');
    return element(
      'button',
      { class: 'chip', click: () => this.actions.pick(point) },
      glyph(this.complex.kind[point]),
      text,
    );
  }

  flow_facts(point) {
    const { complex } = this;
    const parts = [];
    const limits = complex.limits(point);
    if (limits)
      parts.push(
        ...limits.map((limit, side) =>
          element('div', { class: 'line' }, `U2, side ${side}: ends at `, this.button(limit)),
        ),
      );
    else if (complex.set_of_point[point] !== none && complex.u2)
      parts.push(element('p', { class: 'muted' }, 'Its lines of U2 are not in this page.'));
    if (complex.set_of_point[point] !== none) parts.push(this.set_facts(complex.set_of_point[point]));
    const edge = complex.kind[point] === 1 ? complex.edge(point) : null;
    if (edge)
      parts.push(
        element(
          'div',
          { class: 'line' },
          'S1, a Gabriel edge, from ',
          edge.map((end) => this.button(end)),
        ),
      );
    parts.push(surface_line(complex, point));
    if (complex.is_sample(point)) parts.push(this.sample_flow(point));
    else parts.push(this.incoming_facts(point));
    return section('Where orbits go', parts);
  }

  set_facts(set) {
    const { triangle_offsets, has_interval } = this.complex.s2;
    const count = triangle_offsets[set + 1] - triangle_offsets[set];
    const solid = has_interval[set] ? ' It also has parts of dimension 3, which no surface shows.' : '';
    return element('p', { class: 'line' }, `S2, what flows here: ${count_text(count)} triangles.${solid}`);
  }

  // Behind a number of what a thinned page may lack.
  in_this_page() {
    return this.complex.data.thinned ? ' in this page' : '';
  }

  sample_flow(point) {
    const edges = this.complex.edges_at(point);
    const here = this.in_this_page();
    const no_edge = here ? 'No S1 in this page ends at it.' : 'It is an end of no S1.';
    return element(
      'div',
      { class: 'line' },
      'Orbits leave it in all directions. ',
      edges.length > 0 ? `It is an end of S1 of ${count_text(edges.length)}${here}: ` : no_edge,
      edges.length > 0 ? this.buttons(edges, (p) => `record ${this.complex.number(p)}`) : null,
    );
  }

  incoming_facts(point) {
    const incoming = this.complex.incoming(point);
    const here = this.in_this_page();
    if (incoming.length === 0)
      return here && this.complex.u2
        ? element('p', { class: 'muted' }, 'No orbit of U2 in this page ends here.')
        : null;
    const sides = new Map();
    for (const { point: from, side } of incoming) sides.set(from, [...(sides.get(from) ?? []), side]);
    const named = (from) => (sides.get(from).length === 2 ? 'sides 0 and 1' : `side ${sides.get(from)[0]}`);
    return element(
      'div',
      { class: 'line' },
      `Orbits of U2 come in from ${count_text(sides.size)} saddles of index 2${here}: `,
      this.buttons([...sides.keys()], (from) => `record ${this.complex.number(from)}, ${named(from)}`),
    );
  }

  volume_facts(point) {
    const row = volume_row(this.complex, point);
    if (!row) return null;
    const table = neighbour_table(this.complex, point, (number) => this.limit_button(number), this.actions.pick);
    return section('Volume of what flows here', row, table);
  }

  pocket_facts(point) {
    const button = (number, text) => this.limit_button(number, text);
    const facts = pocket_facts(this.complex, point, button);
    return facts && section('Pocket', facts);
  }

  connection_facts(point) {
    const connections = this.complex.connections(point);
    if (connections.length === 0) return null;
    const shown = connections.slice(0, most_listed);
    const rest = connections.length - shown.length;
    return section(
      'Where all directions lead',
      shown.map(({ number, orbits, families }) =>
        element(
          'div',
          { class: 'line', 'data-to': number === none ? 'infinity' : String(number) },
          this.limit_button(number),
          ` ${ways_text(orbits, families)}`,
        ),
      ),
      rest > 0 ? element('p', { class: 'muted' }, `and ${count_text(rest)} more`) : null,
    );
  }

  limit_button(number, text) {
    const point = number === none ? none : this.complex.point_of_number(number);
    if (point !== none || number === none) return this.button(point, text);
    return element('span', { class: 'chip still' }, `record ${count_text(number)}, not in this page`);
  }

  pair_facts(point) {
    const { complex } = this;
    const pair = complex.pair_of[point];
    if (pair === none) {
      const text = complex.lacks_pair(point)
        ? 'Its pair is not in this page.'
        : 'It is in no pair: only critical points are.';
      return section('Persistence', element('p', { class: 'muted' }, text));
    }
    const distance = (squared) => complex.length_text(Math.sqrt(squared));
    return section(
      'Persistence pair',
      element(
        'div',
        { class: 'line' },
        `dimension ${complex.pairs.dimension[pair]}, born at `,
        this.button(complex.birth[pair]),
        ', dies at ',
        this.button(complex.death[pair]),
      ),
      element(
        'p',
        { class: 'line' },
        `distance ${distance(complex.birth_squared(pair))} to ${distance(complex.death_squared(pair))}; ` +
          `length ${complex.length_text(complex.persistence[pair])}, input units`,
      ),
      element(
        'button',
        { class: 'quiet', click: () => this.actions.brush((i) => i === pair) },
        'Show this pair alone',
      ),
      this.cycle_facts(pair),
    );
  }

  cycle_facts(pair) {
    const { cycles, pairs } = this.complex;
    const dimension = pairs.dimension[pair];
    if (!cycles || dimension === 0) return null;
    const what = dimension === 1 ? 'loop' : 'void';
    if (cycles.place_of.has(pair))
      return element('button', { class: 'quiet', click: () => this.actions.pick_pair(pair) }, `Draw its ${what}`);
    const text = `Its ${what} is not in this page, which has those of ${cycles.count(dimension)} of the longest pairs.`;
    return element('p', { class: 'muted' }, text);
  }

  clause_facts(point) {
    return section(
      'Why',
      clauses(this.complex, point).map(([id, text]) =>
        element('p', { class: 'clause' }, element('b', {}, id), ' ', text),
      ),
    );
  }
}

// "1 orbit, 2 families of orbits"
function ways_text(orbits, families) {
  const parts = [];
  if (orbits > 0) parts.push(orbits === 1 ? '1 orbit' : `${count_text(orbits)} orbits`);
  if (families > 0) parts.push(families === 1 ? '1 family of orbits' : `${count_text(families)} families of orbits`);
  return parts.join(', ');
}

const unit = (text) => element('span', { class: 'unit' }, text);
