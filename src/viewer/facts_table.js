// The same facts as the scene's, as a table: all points in the order of the program's list, or those that are shown,
// some rows a page. Positions are those of the exact centres, rounded to the nearest doubles.
// A row picks its point, wherever it is clicked.

import { clickable_row, mark_rows } from './clickable_row.js';
import { element, fill } from './element.js';
import { nearest_double } from './exact_sphere.js';
import { none } from './point_numbers.js';
import { count_text, point_name, row_text, short_kind } from './words.js';

const rows_a_page = 20;

export class FactsTable {
  constructor(root, complex, actions) {
    Object.assign(this, { root, complex, actions, page: 0, filter: 'all' });
    this.shown = new Uint32Array(0);
    this.pages = element('span', { class: 'muted', role: 'status' });
    this.body = element('tbody');
    this.build();
  }

  build() {
    const heads = ['point', 'index or kind', 'x', 'y', 'z', 'd', 'contact rows', 'pair with'];
    const filter = element(
      'select',
      { 'aria-label': 'Which points', change: (event) => this.choose(event.target.value) },
      [
        ['all', this.complex.data.thinned ? 'all points of this page' : 'all points'],
        ['shown', 'points that are drawn'],
        ['0', 'samples (index 0)'],
        ['1', 'index 1'],
        ['2', 'index 2'],
        ['3', 'index 3'],
        ['4', 'regular stationary'],
      ].map(([value, text]) => element('option', { value }, text)),
    );
    const step = (text, label, to) =>
      element('button', { class: 'quiet', 'aria-label': label, click: () => this.turn(to()) }, text);
    fill(
      this.root,
      element(
        'div',
        { class: 'table-bar' },
        filter,
        step('«', 'First page', () => 0),
        step('‹', 'Page before', () => this.page - 1),
        this.pages,
        step('›', 'Next page', () => this.page + 1),
        step('»', 'Last page', () => Infinity),
      ),
      element(
        'div',
        { class: 'table-scroll', tabindex: 0, role: 'region', 'aria-label': 'Table of points' },
        element(
          'table',
          {},
          element('caption', {}, 'Positions and distances d in input units; rows count from 0.'),
          element(
            'thead',
            {},
            element(
              'tr',
              {},
              heads.map((head) => element('th', { scope: 'col' }, head)),
            ),
          ),
          this.body,
        ),
      ),
    );
  }

  choose(filter) {
    this.filter = filter;
    this.page = 0;
    this.points = null;
    this.draw();
  }

  open() {
    this.draw();
  }

  // The points that the scene draws now.
  set_shown(points) {
    this.shown = points;
    if (this.filter === 'shown') this.points = null;
    if (!this.root.hidden) this.draw();
  }

  list() {
    const { complex, filter } = this;
    if (this.points) return this.points;
    if (filter === 'shown') return (this.points = this.shown);
    const all = new Uint32Array(complex.point_count);
    let count = 0;
    for (let point = 0; point < all.length; ++point)
      if (filter === 'all' || complex.kind[point] === Number(filter)) all[count++] = point;
    return (this.points = all.subarray(0, count));
  }

  turn(page) {
    this.page = page;
    this.draw();
  }

  set_picked(point) {
    this.picked = point;
    mark_rows(this.body.children, (row) => Number(row.dataset.point) === point);
  }

  draw() {
    const points = this.list();
    const last = Math.max(0, Math.ceil(points.length / rows_a_page) - 1);
    this.page = Math.max(0, Math.min(this.page, last));
    const from = this.page * rows_a_page;
    const here = points.slice(from, from + rows_a_page);
    this.pages.textContent =
      points.length === 0
        ? 'no such point'
        : `${count_text(from + 1)} to ${count_text(from + here.length)} of ${count_text(points.length)}`;
    fill(
      this.body,
      Array.from(here, (point) => this.row(point)),
    );
  }

  contact_text(point) {
    const { complex } = this;
    const contacts = Array.from(complex.contacts(point));
    const [most, gap] = complex.atoms ? [4, ', '] : [8, ' '];
    const text = contacts
      .slice(0, most)
      .map((sample) => row_text(complex, sample))
      .join(gap);
    return contacts.length > most ? `${text} … (${contacts.length})` : text;
  }

  row(point) {
    const { complex } = this;
    const { center } = complex.exact(point);
    const pair = complex.pair_of[point];
    const other =
      pair === none
        ? complex.lacks_pair(point)
          ? 'not in this page'
          : ''
        : point_name(complex, complex.birth[pair] === point ? complex.death[pair] : complex.birth[pair]);
    const name = complex.is_sample(point) ? point_name(complex, point) : `record ${complex.number(point)}`;
    const pick = () => this.actions.pick(point);
    return clickable_row(
      pick,
      { 'data-point': point, 'aria-current': point === this.picked ? 'true' : false },
      element(
        'th',
        { scope: 'row' },
        element('button', { class: 'link', tabindex: -1, click: pick }, name),
      ),
      [
        short_kind(complex, point),
        ...center.map((value) => String(nearest_double(value))),
        complex.length_text(complex.frame_radius(point)),
        this.contact_text(point),
        other,
      ].map((text) => element('td', {}, text)),
    );
  }
}
