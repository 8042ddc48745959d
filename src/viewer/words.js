// Numbers and names as people read them, and the clauses of the specification that the page quotes.

import { none, regular_kind } from './point_numbers.js';

export const count_text = (count) => count.toLocaleString('en-US');

// Four significant digits; exponents only where they help.
export function short_number(value) {
  if (value === Infinity) return '∞';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) return value.toExponential(2).replace('e+', 'e');
  return String(Number(value.toPrecision(4)));
}

// What a number of the frame is in input units, to a power: factor * 10^exponent, as squares may be no doubles.
export function in_input_units(unit, power) {
  const whole = unit ** power;
  if (whole > 1e-290 && whole < 1e290) return { factor: whole, exponent: 0 };
  const [digits, exponent] = unit.toExponential().split('e').map(Number);
  return { factor: digits ** power, exponent: exponent * power };
}

export function short_scaled(value, { factor, exponent }) {
  const size = value * factor;
  if (exponent === 0 || size === 0 || size === Infinity) return short_number(size);
  const [digits, power] = size.toExponential(2).split('e');
  return `${digits}e${Number(power) + exponent}`;
}

// Long fractions are shortened in the middle of numerator and denominator.
export function shortened(text, most = 28) {
  const digits = (part) =>
    part.length <= most ? part : `${part.slice(0, most / 2 - 1)}…${part.slice(2 - most / 2)}`;
  return text.split('/').map(digits).join('/');
}

export const digits_of = (text) => Math.max(...text.split('/').map((part) => part.replace('-', '').length));

export function kind_name(complex, point) {
  const kind = complex.kind[point];
  if (kind !== regular_kind)
    return ['Sample, index 0', 'Saddle, index 1', 'Saddle, index 2', 'Maximum, index 3'][kind];
  return `Regular stationary, kind ${kind_of(complex, point)}`;
}

export function kind_of(complex, point) {
  const { face, hull } = complex.records;
  const record = point - complex.sample_count;
  return face[record] === hull[record] ? `${face[record]}` : `${face[record]}-${hull[record]}`;
}

export const short_kind = (complex, point) => (complex.is_sample(point) ? '0' : kind_of(complex, point));

// The first row of a sample, with the name of the atom.
export function row_text(complex, sample) {
  const atom = complex.atom_name(sample);
  return atom ? `${complex.sample_rows[sample]} · ${atom}` : String(complex.sample_rows[sample]);
}

// A name that tells the point apart: its row, or its number in the program's list.
export function point_name(complex, point) {
  if (point === none) return 'infinity';
  if (complex.is_sample(point)) return `row ${row_text(complex, point)}`;
  const kind =
    complex.kind[point] === regular_kind ? `kind ${kind_of(complex, point)}` : `index ${kind_of(complex, point)}`;
  return `record ${complex.number(point)} (${kind})`;
}

const hulls = ['point', 'edge', 'polygon', 'polytope'];

// [clause, sentence] pairs: what makes the point what it is.
export function clauses(complex, point) {
  if (complex.is_sample(point))
    return [
      [
        'FC-CRIT-04',
        'The critical points of index 0 are exactly the points of the input, each with itself as contact set.',
      ],
    ];
  const record = point - complex.sample_count;
  const [face, hull] = [complex.records.face[record], complex.records.hull[record]];
  const size = complex.contacts(point).length;
  const sphere = [
    'FC-CRIT-05',
    `Its ${size} contact points lie on one sphere around it, no sample lies inside, and no further one on it.`,
  ];
  if (face === hull)
    return [
      [
        'FC-CRIT-02',
        'Critical: it lies in the relative interior of the hull of its contact set, ' +
          `which has dimension ${face}, the index.`,
      ],
      sphere,
    ];
  return [
    [
      'FC-CRIT-03',
      `Regular stationary: it lies inside a face of dimension ${face} (${hulls[face]}) ` +
        'of the hull of its contact set, ' +
        `which has dimension ${hull} (${hulls[hull]}). Critical points of neighbouring index collide here.`,
    ],
    sphere,
  ];
}
