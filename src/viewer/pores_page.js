// A page of balls: no flow complex, but atoms with radii, and the chambers between them with their windows. The deepest
// chamber is picked at first.

import { element, fill } from './element.js';
import { Page, by_id } from './page.js';
import { none } from './point_numbers.js';
import { PoreFacts, atom_facts } from './pore_facts.js';
import { about_lines } from './statements.js';
import { Tabs } from './tabs.js';
import { row_text } from './words.js';

export class PoresPage extends Page {
  make_parts() {
    for (const id of ['diagram-card', 'threshold-card']) by_id(id).hidden = true;
    by_id('scene').setAttribute('aria-label', 'Atoms in three dimensions, with the picked chamber');
    this.make_head();
  }

  make_tabs() {
    const names = [['pores', 'Chambers'], ['atom', 'Atom'], ['about', 'About']];
    this.tabs = new Tabs(by_id('tabs'), by_id('pages'), names);
    this.facts = new PoreFacts(this.tabs.page('pores'), this.complex, this.state, this.actions);
    const about = about_lines(this.complex).map((line) => element('p', {}, line));
    fill(this.tabs.page('about'), element('div', { class: 'about' }, about));
    this.picked_changed();
    this.tabs.open('pores');
  }

  make_actions() {
    return {
      ...super.make_actions(),
      pick_chamber: (chamber) => this.state.change({ chamber, window: none, picked: none }),
      pick_window: (window) => this.state.change({ window, picked: none }),
    };
  }

  pick_deepest() {
    this.step(1);
  }

  // Goes through the chambers.
  step(way) {
    const { chambers } = this.complex.pores;
    const next = this.state.chamber === none ? 0 : this.state.chamber + way + chambers.length;
    if (chambers.length > 0) this.actions.pick_chamber(next % chambers.length);
  }

  let_go() {
    if (this.state.picked !== none) this.actions.pick(none);
    else if (this.state.window !== none) this.actions.pick_window(none);
  }

  approach() {
    if (!this.scene || this.state.chamber === none) return;
    const { place, radius } = this.complex.pores.witness(this.state);
    this.scene.look_at(place, Math.min(8, Math.max(0.25, 6 * radius)), true);
  }

  changed(values) {
    const has = (...names) => names.some((name) => name in values);
    if (has('layers')) this.layers.update(this.state);
    if (has('chamber', 'window')) {
      this.facts.update(values);
      this.tabs.open('pores');
    }
    if (has('picked')) this.picked_changed();
    if (has('chamber', 'window', 'picked', 'layers')) this.scene?.mark_picked();
    this.scene?.refresh();
  }

  picked_changed() {
    const { complex, state } = this;
    fill(this.tabs.page('atom'), atom_facts(complex, state.picked));
    if (state.picked === none) return;
    this.tabs.open('atom');
    this.announce(`Picked ${row_text(complex, state.picked)}.`);
  }

  draw_plots() {}

  view_changed() {}
}
