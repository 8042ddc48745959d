// The flow complex of the page's data, in typed arrays; no object for a record, as there may be hundreds of thousands.
// A *point* is a number: a sample's ordinal, or sample_count + place in the records. `none` stands for no point,
// no pair, and infinity. Squared distances, radii and persistence, a difference of distances, are in the frame;
// `length_text` and `squared_text` give them in input units. What the first frame needs is decoded by load_first, the
// lines of U2 by load_lines, with the cycles of pairs (cycles.js), with volumes, connections, cells and U1 (cells.js)
// and pockets (pockets.js), if the page has them. A page of balls has samples with radii, and pores (pores.js).

import { load_atoms } from './atoms.js';
import { decode, decode_all } from './blobs.js';
import { load_cells } from './cells.js';
import { load_cycles } from './cycles.js';
import { exact_sphere } from './exact_sphere.js';
import { fill_records, line_vertices } from './plain_points.js';
import { load_pockets } from './pockets.js';
import { none, regular_kind } from './point_numbers.js';
import { Pores, no_flow } from './pores.js';
import { in_input_units, short_scaled } from './words.js';

// sqrt(a) - sqrt(b), with the digits that a difference of near numbers loses.
const difference_of_roots = (a, b) =>
  a === Infinity ? Infinity : a === b ? 0 : (a - b) / (Math.sqrt(a) + Math.sqrt(b));

export class Complex {
  constructor(data) {
    this.data = data;
    this.length_unit = in_input_units(data.unit, 1);
    this.squared_unit = in_input_units(data.unit, 2);
    this.atoms = null;
    this.cycles = null;
    this.cells = null;
    this.pockets = null;
    if (data.pores) Object.assign(data, no_flow);
  }

  async load_first() {
    const { data } = this;
    const [samples, sample_rows, atoms, radii, records, pairs, s2, line_limits] = await Promise.all([
      decode(data.samples),
      decode(data.sample_rows),
      data.atoms ? load_atoms(data.atoms) : null,
      data.radii ? decode(data.radii) : null,
      decode_all(data.records, [
        'numbers',
        'face',
        'hull',
        'positions',
        'squared',
        'contact_offsets',
        'contacts',
        'edges',
      ]),
      decode_all(data.pairs, ['dimension', 'birth', 'death', 'birth_sample']),
      decode_all(data.s2, ['record', 'triangle_offsets', 'vertices', 'triangles', 'has_interval']),
      decode(data.u2.limits),
    ]);
    Object.assign(this, { samples, sample_rows, atoms, radii, records, pairs, s2 });
    this.infinite_line_count = line_limits.reduce((count, limit) => count + (limit === none), 0);
    this.finite_line_count = line_limits.length - this.infinite_line_count;
    this.sample_count = sample_rows.length;
    this.record_count = records.face.length;
    this.point_count = this.sample_count + this.record_count;
    this.pair_count = pairs.dimension.length;
    this.set_count = s2.record.length;
    this.lay_out_points();
    this.join_pairs();
    this.join_sets();
    this.pores = data.pores ? new Pores(data, this.positions) : null;
  }

  async load_lines() {
    const { data } = this;
    [this.u2, this.cycles, this.cells, this.pockets] = await Promise.all([
      decode_all(data.u2, ['record', 'starts', 'limits', 'next', 'steps']),
      load_cycles(data.cycles, this),
      data.cells ? load_cells(data.cells) : null,
      data.pockets ? load_pockets(data.pockets) : null,
    ]);
    this.u2.vertices = line_vertices({ ...this.u2, step: this.data.u2.step });
    this.line_of_point = new Uint32Array(this.point_count).fill(none);
    this.u2.record.forEach((record, line) => (this.line_of_point[this.sample_count + record] = line));
  }

  lay_out_points() {
    const { sample_count, records, samples } = this;
    const { origin, unit } = this.data;
    this.positions = new Float32Array(3 * this.point_count);
    this.squared = new Float64Array(this.point_count);
    const framed = fill_records({
      samples,
      origin,
      unit,
      records,
      positions: this.positions.subarray(3 * sample_count),
      squared: this.squared.subarray(sample_count),
    });
    this.positions.set(framed);
    this.kind = new Uint8Array(this.point_count);
    this.kind_counts = [sample_count, 0, 0, 0, 0];
    for (let i = 0; i < this.record_count; ++i) {
      const kind = records.face[i] === records.hull[i] ? records.face[i] : regular_kind;
      this.kind[sample_count + i] = kind;
      ++this.kind_counts[kind];
    }
    this.largest_squared = this.squared.reduce((most, value) => (value > most && value < Infinity ? value : most), 0);
  }

  join_pairs() {
    const { pairs, sample_count, pair_count } = this;
    this.birth = new Uint32Array(pair_count);
    this.death = new Uint32Array(pair_count);
    this.persistence = new Float64Array(pair_count);
    this.pair_of = new Uint32Array(this.point_count).fill(none);
    for (let i = 0; i < pair_count; ++i) {
      const birth = pairs.birth_sample[i] !== none ? pairs.birth_sample[i] : sample_count + pairs.birth[i];
      const death = pairs.death[i] === none ? none : sample_count + pairs.death[i];
      this.birth[i] = birth;
      this.death[i] = death;
      this.pair_of[birth] = i;
      if (death !== none) this.pair_of[death] = i;
      this.persistence[i] = difference_of_roots(this.death_squared(i), this.birth_squared(i));
    }
  }

  join_sets() {
    this.set_of_point = new Uint32Array(this.point_count).fill(none);
    this.set_point = this.s2.record.map((record) => record + this.sample_count);
    this.set_point.forEach((point, set) => (this.set_of_point[point] = set));
    this.set_radius = Float64Array.from(this.set_point, (point) => Math.sqrt(this.squared[point]));
    this.set_persistence = Float64Array.from(this.set_point, (point) => this.persistence_of(point));
  }

  persistence_of(point) {
    return this.pair_of[point] === none ? 0 : this.persistence[this.pair_of[point]];
  }

  // A thinned page leaves out pairs; only regular stationary points have none.
  lacks_pair(point) {
    return this.pair_of[point] === none && this.kind[point] !== regular_kind;
  }

  birth_squared(pair) {
    return this.squared[this.birth[pair]];
  }

  death_squared(pair) {
    return this.death[pair] === none ? Infinity : this.squared[this.death[pair]];
  }

  is_sample(point) {
    return point < this.sample_count;
  }

  // The name that a molecule's file gives to the sample, or nothing.
  atom_name(sample) {
    return this.atoms?.names[sample] ?? '';
  }

  // Whether the samples are drawn as balls, if wanted: those of molecules, and those that pockets or pores lie between.
  get has_balls() {
    return this.sample_count > 0 && Boolean(this.data.atoms || this.data.pockets || this.pores);
  }

  // The samples of C(x), ascending.
  contacts(point) {
    if (this.is_sample(point)) return Uint32Array.of(point);
    const { contact_offsets, contacts } = this.records;
    const record = point - this.sample_count;
    return contacts.subarray(contact_offsets[record], contact_offsets[record + 1]);
  }

  // The two samples whose midpoint the point is, or null.
  edge(point) {
    if (this.is_sample(point)) return null;
    const record = point - this.sample_count;
    const [a, b] = this.records.edges.subarray(2 * record, 2 * record + 2);
    return a === none ? null : [a, b];
  }

  sample_position(sample) {
    return Array.from(this.samples.subarray(3 * sample, 3 * sample + 3));
  }

  frame_position(point) {
    return Array.from(this.positions.subarray(3 * point, 3 * point + 3));
  }

  frame_radius(point) {
    return Math.sqrt(this.squared[point]);
  }

  // A length, or a squared length, of the frame, as text in input units.
  length_text(length) {
    return short_scaled(length, this.length_unit);
  }

  squared_text(squared) {
    return short_scaled(squared, this.squared_unit);
  }

  // The exact position and squared distance, from the samples.
  exact(point) {
    return exact_sphere(Array.from(this.contacts(point), (sample) => this.sample_position(sample)));
  }

  // The number that the program prints as "record N"; of a sample none, as records begin with the samples in order.
  number(point) {
    return this.is_sample(point) ? point : this.records.numbers[point - this.sample_count];
  }

  // [limit on side 0, limit on side 1], points or none; null where there is no line.
  limits(point) {
    const line = this.u2 ? this.line_of_point[point] : none;
    if (line === none) return null;
    return [0, 1].map((side) => {
      const record = this.u2.limits[2 * line + side];
      return record === none ? none : record + this.sample_count;
    });
  }

  // The point with a number of the program's list; none if the page has left it out.
  point_of_number(number) {
    if (number < this.sample_count) return number;
    const { numbers } = this.records;
    let [first, last] = [0, numbers.length];
    while (first < last) {
      const middle = (first + last) >> 1;
      if (numbers[middle] < number) first = middle + 1;
      else last = middle;
    }
    return numbers[first] === number ? this.sample_count + first : none;
  }

  // The volume of what flows to the point, in input units; null where the page does not say it.
  volume(point) {
    if (!this.cells) return null;
    return this.is_sample(point) ? 0 : this.cells.volumes[point - this.sample_count];
  }

  // [{number, orbits, families}]: where the point's directions lead, by numbers of the program's list, or none.
  connections(point) {
    return this.cells && !this.is_sample(point) ? this.cells.connections(point - this.sample_count) : [];
  }

  // The faces around the point's cell, or null where the page does not draw it.
  cell(point) {
    if (!this.cells?.is_drawn.has(point - this.sample_count)) return null;
    return this.cells.faces_of.get(this.number(point));
  }

  // {sheets, lines} of the point's U1, or null where the page does not draw it.
  unstable_surface(point) {
    return this.cells && !this.is_sample(point) ? this.cells.surface(point - this.sample_count) : null;
  }

  // The index-2 points of which an orbit of U2 ends at the point, with the sides.
  incoming(point) {
    const found = [];
    if (!this.u2 || this.is_sample(point)) return found;
    const { limits, record } = this.u2;
    for (let i = 0; i < limits.length; ++i)
      if (limits[i] === point - this.sample_count)
        found.push({ point: record[i >> 1] + this.sample_count, side: i & 1 });
    return found;
  }

  // Index-1 points of which a sample is an end of S1.
  edges_at(sample) {
    const found = [];
    const { edges } = this.records;
    for (let i = 0; i < edges.length; ++i)
      if (edges[i] === sample && this.kind[this.sample_count + (i >> 1)] === 1)
        found.push(this.sample_count + (i >> 1));
    return found;
  }

  triangles_of_set(set) {
    const { triangle_offsets, triangles } = this.s2;
    return triangles.subarray(3 * triangle_offsets[set], 3 * triangle_offsets[set + 1]);
  }
}
