// What a page with cells says of a point: the volume of what flows to it, the cells that share a face with its cell S3,
// and what is drawn of its surface U1. Each fact is an element, or null where there is nothing to say.

import { area_of } from './cells.js';
import { clickable_row } from './clickable_row.js';
import { element } from './element.js';
import { none } from './point_numbers.js';
import { count_text } from './words.js';

const most_listed = 24;

export function volume_row(complex, point) {
  const volume = complex.volume(point);
  if (!volume && !complex.cell(point)) return null;
  const is_double = volume > 0 && volume < Infinity;
  const beyond = volume > 0 ? 'beyond the largest double' : 'below the least double';
  return element(
    'dl',
    { class: 'exact' },
    element(
      'div',
      { class: 'row' },
      element('dt', {}, 'V'),
      element(
        'dd',
        { 'data-volume': String(volume) },
        element('span', { class: 'value' }, is_double ? `≈ ${volume}` : beyond),
        is_double ? element('span', { class: 'unit' }, 'input units, cubed') : null,
      ),
    ),
  );
}

// `button` makes what picks a point by its number in the program's list, `pick` picks a point.
export function neighbour_table(complex, point, button, pick) {
  const faces = complex.cell(point);
  if (!faces) {
    if (!complex.volume(point)) return null;
    return element('p', { class: 'muted' }, `Its cell S3 is not in this page, which has ${drawn_cells(complex)}.`);
  }
  const rows = faces
    .map(({ face, beyond }) => ({ beyond, area: area_of(complex.cells.triangles([face])) }))
    .sort((a, b) => b.area - a.area);
  const rest = rows.length - most_listed;
  const pick_of = (number) => {
    const beyond = number === none ? none : complex.point_of_number(number);
    return beyond === none ? null : () => pick(beyond);
  };
  return [
    element(
      'table',
      { class: 'neighbours' },
      element('caption', {}, "Cells that its cell S3 shares a face with, by the face's area (input units, squared)"),
      element(
        'tbody',
        {},
        rows
          .slice(0, most_listed)
          .map(({ beyond, area }) =>
            clickable_row(
              pick_of(beyond),
              {},
              element('th', { scope: 'row' }, button(beyond)),
              element('td', {}, `≈ ${complex.squared_text(area)}`),
            ),
          ),
      ),
    ),
    rest > 0 ? element('p', { class: 'muted' }, `and ${count_text(rest)} more`) : null,
  ];
}

export function surface_line(complex, point) {
  if (!complex.cells || !complex.edge(point)) return null;
  const surface = complex.unstable_surface(point);
  if (!surface)
    return element('p', { class: 'muted' }, `Its U1 is not in this page, which has ${drawn_surfaces(complex)}.`);
  const lines = surface.lines.length / 6;
  const of_lines = lines > 0 ? ` and ${count_text(lines)} lines` : '';
  return element(
    'p',
    { class: 'line', 'data-sheets': String(surface.sheet_count) },
    `U1, what flows from here: ${count_text(surface.sheet_count)} sheets${of_lines}, cut at three times the box.`,
  );
}

const part_text = (count, of) => (count === of ? `all ${count_text(of)}` : `${count_text(count)} of ${count_text(of)}`);

export function drawn_cells({ data }) {
  const { drawn, of } = data.cells;
  const chosen = drawn.count < of ? ', the largest (view --most-cells)' : '';
  return `${part_text(drawn.count, of)} cells${chosen}`;
}

export function drawn_surfaces({ data }) {
  const { record, of } = data.cells.u1;
  const chosen = record.count < of ? ', of regular points and of the longest pairs (view --most-unstable)' : '';
  return `${part_text(record.count, of)} surfaces${chosen}`;
}
