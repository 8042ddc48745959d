// What a page has of the cycles of its longest pairs: at each level the surfaces of a loop and its edges, or those
// around a void. Levels are whole percents of the way from birth to death, in squared distances. A surface is an S2, or
// a piece that the page has for cycles alone.

import { decode_all } from './blobs.js';
import { joined } from './joined_arrays.js';
import { none } from './point_numbers.js';

const lists = ['pair', 'least', 'step_offsets', 'percent', 'piece_offsets', 'pieces', 'edge_offsets', 'edges'];
const mesh = ['triangle_offsets', 'triangles', 'vertices'];

export async function load_cycles(data, complex) {
  return new Cycles(await decode_all(data, [...lists, ...mesh]), complex);
}

class Cycles {
  constructor(parts, complex) {
    Object.assign(this, parts, { complex });
    this.place_of = new Map(Array.from(this.pair, (pair, place) => [pair, place]));
  }

  // {pair, level, least, pieces, edges}, or null where the page has none of the pair. Edges are points of index 1. Below
  // the least level that the page has of the pair, it is that one.
  at(pair, wanted) {
    const place = this.place_of.get(pair);
    if (place === undefined) return null;
    const least = this.least[place];
    const level = Math.max(least, wanted);
    const [pieces, edges] = [new Set(), new Set()];
    for (let step = this.step_offsets[place]; step < this.step_offsets[place + 1]; ++step) {
      if (this.percent[step] < level) break;
      toggle(pieces, this.pieces, this.piece_offsets, step);
      toggle(edges, this.edges, this.edge_offsets, step);
    }
    const points = Array.from(edges, (record) => record + this.complex.sample_count);
    return { pair, level, least, pieces: [...pieces], edges: points };
  }

  // Three vertices for each triangle, those of S2 before those of this.
  triangles_of({ pieces }) {
    const { complex, triangle_offsets: offsets, triangles } = this;
    const parts = pieces.map((piece) => {
      const own = piece - complex.set_count;
      return own < 0 ? complex.triangles_of_set(piece) : triangles.subarray(3 * offsets[own], 3 * offsets[own + 1]);
    });
    return joined([new Uint32Array(0), ...parts]);
  }

  // Of so many pairs of a dimension the page has cycles.
  count(dimension) {
    return this.pair.reduce((sum, pair) => sum + (this.complex.pairs.dimension[pair] === dimension), 0);
  }
}

// A step has what differs from the one before.
function toggle(set, list, offsets, step) {
  for (const item of list.subarray(offsets[step], offsets[step + 1])) if (!set.delete(item)) set.add(item);
}

// Of the picked pair, at the level that is chosen.
export function picked_cycle({ cycles, pair_of }, { picked, as_pair, level }) {
  const pair = cycles && as_pair && picked !== none ? pair_of[picked] : none;
  return pair === none ? null : cycles.at(pair, level);
}
