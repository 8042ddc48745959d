// What the page of a molecule has of its atoms: names, elements, and the sticks between them. Points of other pages are
// drawn as atoms of no element where pockets lie between them.
// A stick is a Gabriel edge that is no longer than a bond, so that no search is needed: nearest atoms have such an
// edge.

import { decode } from './blobs.js';

// In Angstrom, the unit of files of molecules.
const covalent = {
  C: 0.76, N: 0.71, O: 0.66, H: 0.31, D: 0.31, S: 1.05, P: 1.07,
  F: 0.57, Cl: 1.02, Br: 1.2, I: 1.39, Se: 1.2, Si: 1.11, B: 0.84,
};
const of_others = 1.5;

const symbol_of = (text) => text.slice(0, 1).toUpperCase() + text.slice(1).toLowerCase();

export async function load_atoms(data) {
  return new Atoms(data.elements.map(symbol_of), await decode(data.element), data.names);
}

class Atoms {
  // symbols: "C", "Cl", or empty; element: of each sample, its place there; names: of each sample.
  constructor(symbols, element, names) {
    Object.assign(this, { symbols, element, names });
  }

  symbol(sample) {
    return this.symbols[this.element[sample]];
  }

  // The symbols that occur, the most frequent first.
  by_frequency() {
    const counts = new Map();
    for (const place of this.element) counts.set(place, (counts.get(place) ?? 0) + 1);
    return [...counts].sort((a, b) => b[1] - a[1]).map(([place]) => this.symbols[place]);
  }
}

const radius_of = (complex, sample) => covalent[complex.atoms?.symbol(sample)] ?? of_others;

// Atoms fill space, and points of a scan do not: these have few maxima.
export function fills_space({ sample_count, kind_counts }) {
  return 4 * kind_counts[3] >= sample_count;
}

// Pairs of samples, two numbers each, for which `is_near(a, b, length)` holds; lengths are in the frame.
function edges_where(complex, is_near) {
  const pairs = [];
  for (let point = complex.sample_count; point < complex.point_count; ++point) {
    if (complex.kind[point] !== 1) continue;
    const [a, b] = complex.edge(point);
    if (is_near(a, b, 2 * complex.frame_radius(point))) pairs.push(a, b);
  }
  return Uint32Array.from(pairs);
}

// The median of the distances to the nearest sample, in the frame; 0 for less than two samples.
function median_nearest(complex) {
  const nearest = new Float64Array(complex.sample_count).fill(Infinity);
  edges_where(complex, (a, b, length) => {
    nearest[a] = Math.min(nearest[a], length);
    nearest[b] = Math.min(nearest[b], length);
    return false;
  });
  const known = nearest.filter((length) => length < Infinity).sort();
  return known.length > 0 ? known[known.length >> 1] : 0;
}

// {sticks, near}: pairs of samples, and the median distance to a nearest one. Atoms without elements, and those of a
// trace of a chain, are joined where they are neighbours.
export function joined_atoms(complex) {
  const near = median_nearest(complex);
  const { unit } = complex.data;
  const is_bond = (a, b, length) => length * unit <= 1.2 * (radius_of(complex, a) + radius_of(complex, b));
  const bonds = complex.atoms?.symbols.some((symbol) => symbol in covalent) ? edges_where(complex, is_bond) : [];
  if (2 * new Set(bonds).size >= complex.sample_count && bonds.length > 0) return { sticks: bonds, near };
  return { sticks: edges_where(complex, (_a, _b, length) => length <= 1.25 * near), near };
}

// Of balls, in the frame: their own, or else larger elements have somewhat larger ones.
export function ball_radii(complex, near) {
  if (complex.radii) return Float32Array.from(complex.radii, (radius) => radius / complex.data.unit);
  return Float32Array.from({ length: complex.sample_count }, (_, sample) => {
    const radius = covalent[complex.atoms?.symbol(sample)] ?? covalent.C;
    return 0.27 * (near || 0.2) * Math.min(1.25, Math.sqrt(radius / covalent.C));
  });
}
