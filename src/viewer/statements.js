// Sentences about the whole page: the summary below the name, what made it, and what the view leaves out.

import { drawn_cells, drawn_surfaces } from './cell_facts.js';
import { pockets_line } from './pocket_facts.js';
import { count_text } from './words.js';

// A path is shown by its last part; other names as they are.
export const shown_name = (name) =>
  /^(\.{0,2}|[A-Za-z]:)[\\/]/.test(name) ? name.split(/[\\/]/).pop() || name : name;

export function summary({ data, kind_counts }) {
  if (data.pores) return `${count_text(data.points)} balls; ${pores_count(data.pores)}; radii: ${data.pores.radii}`;
  const regular = kind_counts[4] > 0 ? `, ${count_text(kind_counts[4])} regular stationary` : '';
  const merged = data.merged_duplicates > 0 ? ` (${count_text(data.merged_duplicates)} merged)` : '';
  const critical = data.critical.map(count_text).join(' + ');
  return `${count_text(data.points)} points${merged}; critical points of index 0 to 3: ${critical}${regular}`;
}

const pores_count = ({ chambers, depth }) =>
  `${count_text(chambers.length)} chamber${chambers.length === 1 ? '' : 's'} of depth ${depth} or more`;

function cells_line(complex) {
  if (!complex.data.cells) return null;
  return (
    'S3 is what flows to a maximum, a cell; U1 is what flows from a point of index 1, a surface. ' +
    'They are drawn for the picked point; U1 is cut at three times the box. ' +
    `The page has ${drawn_cells(complex)}, and ${drawn_surfaces(complex)}.`
  );
}

function atoms_line({ data, has_balls }) {
  if (!has_balls) return null;
  const sticks = 'sticks join those that are as near as a bond, or else near neighbours';
  if (!data.atoms) return `Samples may be drawn as balls; ${sticks}. They say nothing of the flow.`;
  return `Atoms are the samples, as balls in the colours of their elements; ${sticks}. Sticks say nothing of the flow.`;
}

const last_line = 'The page needs no network and sends nothing. It is under the MIT license and contains three.js.';

const pores_lines = [
  'Atoms are drawn as balls of their radii. A chamber is a room between them that is wider than its way out; the ball ' +
    'of the widest probe that has room in it is drawn, and its windows, the narrowest places of its ways to other ' +
    'rooms, as discs of the widest probe that passes.',
  'Regions are those of the centres of probes, and the atoms are a finite set. What is drawn is rounded to 32-bit ' +
    'floats. Values and places in the facts are exact, with the nearest doubles.',
];

export function about_lines(complex) {
  const { data } = complex;
  const program = `flowcert ${data.version} (commit ${data.commit}; kernel: ${data.kernel}`;
  const made_by = `Made by ${program}; compiler: ${data.compiler}; CGAL ${data.cgal}).`;
  if (data.pores) return [`Input: ${data.name}.`, made_by, ...pores_lines, last_line];
  return [
    thinned_data(data),
    `Input: ${data.name}, SHA-256 ${data.input_sha256}.`,
    made_by,
    atoms_line(complex),
    'Samples are the points of index 0. S1 is what flows to a point of index 1, a Gabriel edge; ' +
      'S2 is what flows to one of index 2, a surface. ' +
      'U2 are the two orbits that leave a point of index 2; those to infinity are a layer of their own, off at first, ' +
      'and are cut at three times the box.',
    cells_line(complex),
    pockets_line(complex),
    'Positions in the scene are 32-bit floats. Those in the facts are exact, computed here from the samples.',
    last_line,
  ].filter(Boolean);
}

function thinned_data({ thinned }) {
  if (!thinned) return null;
  const [kept, of] = [count_text(thinned.kept), count_text(thinned.of)];
  return `The program kept ${kept} of ${of} stationary points, those of the longest persistence pairs (view --most).`;
}

// What is said above the layers.
export function notice_lines(data, view) {
  const lines = [];
  const out = view?.thinned;
  if (out && view.flat) lines.push('Thinned view: each surface is drawn as the polygon that it spans.');
  else if (out) lines.push('Thinned view.');
  const parts = [
    ['sets', 'surfaces'],
    ['points', 'points'],
    ['edges', 'edges'],
    ['lines', 'pairs of U2 lines'],
  ].filter(([name]) => out?.[name] > 0);
  if (parts.length > 0) {
    const counted = parts.map(([name, text]) => `${count_text(out[name])} ${text}`).join(', ');
    lines.push(`Left out, as their persistence is shortest: ${counted}.`);
  }
  if (data.thinned) lines.push(thinned_data(data));
  return lines;
}
