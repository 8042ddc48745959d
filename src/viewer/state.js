// What the user chose: layers, threshold, brushed pairs, the picked point, how much detail. One object, one event.
// Every change goes through `change`, which tells all listeners what changed: {threshold, layers, brush, picked, ...}.

import { none } from './point_numbers.js';

export class State {
  constructor(layers) {
    this.layers = layers;
    this.mode = 'radius'; // 'radius': shown below the limit; 'persistence': shown above it
    this.limit = Infinity;
    this.brush = null; // Uint8Array by pair, or null where nothing is brushed
    this.picked = none;
    this.as_pocket = false; // the point stands for its pocket, which is what is drawn
    this.as_pair = false; // the point stands for its pair, whose loop or void is drawn
    this.chamber = none; // of a page with pores, with the one of its windows that is picked
    this.window = none;
    this.level = 25; // at which that is, in percent of the way from birth to death
    this.full = false;
    this.see_through = false;
    this.finding = -1;
    this.listeners = [];
  }

  on_change(listener) {
    this.listeners.push(listener);
  }

  change(values) {
    Object.assign(this, values);
    for (const listener of this.listeners) listener(values);
  }

  set_layer(name, on) {
    this.change({ layers: { ...this.layers, [name]: on } });
  }

  brush_where(pair_count, belongs) {
    const brush = new Uint8Array(pair_count);
    let any = false;
    for (let pair = 0; pair < pair_count; ++pair)
      if (belongs(pair)) {
        brush[pair] = 1;
        any = true;
      }
    this.change({ brush: any ? brush : null });
  }

  brushed_pairs() {
    const pairs = [];
    if (this.brush) for (let pair = 0; pair < this.brush.length; ++pair) if (this.brush[pair]) pairs.push(pair);
    return pairs;
  }
}
