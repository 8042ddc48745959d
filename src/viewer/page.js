// The page itself: state, parts, and what happens on each action. Parts do not know each other; they call actions, and
// are told when the state has changed.
// The first frame of a crowded input is a shape: S2 below a typical radius, thinned. That of a molecule is its atoms.
// Where there are pockets, the deepest one is picked at first.

import { fills_space } from './atoms.js';
import { copy_text } from './clipboard.js';
import { CycleLevel } from './cycle_level.js';
import { Details } from './details.js';
import { element, fill, glyph } from './element.js';
import { FactsTable } from './facts_table.js';
import { Findings } from './findings.js';
import { Histogram } from './histogram.js';
import { key_list, listen_to_keys } from './keyboard.js';
import { LayersBar } from './layers_bar.js';
import { palettes } from './palette.js';
import { PersistenceDiagram } from './persistence_diagram.js';
import { save_picture } from './picture_file.js';
import { PocketTable } from './pocket_facts.js';
import { deepest_peak } from './pockets.js';
import { none } from './point_numbers.js';
import { ComplexScene } from './scene.js';
import { State } from './state.js';
import { about_lines, notice_lines, shown_name, summary } from './statements.js';
import { Tabs } from './tabs.js';
import { Threshold, no_limit } from './threshold.js';
import { typical_radius } from './typical_radius.js';
import { count_text, point_name } from './words.js';

export const by_id = (id) => document.getElementById(id);
const calm = () => matchMedia('(prefers-reduced-motion: reduce)').matches;
const night = () => matchMedia('(prefers-color-scheme: dark)');
const of_picked = ['s3', 'u1', 'pockets'];
const layer_names = [
  ...['atoms', 'samples', 'index1', 'index2', 'index3', 'regular'],
  ...['s1', 's2', 'u2', 'infinity', ...of_picked],
];
// What hides the rest, or is all over the view, is off at first.
const first_layers = layer_names.filter((name) => !['atoms', 'infinity'].includes(name));
const crowded_layers = ['regular', 's2', ...of_picked];
const atom_layers = ['atoms', ...of_picked];
const crowd = 600; // surfaces

const layers = (names) => Object.fromEntries(layer_names.map((name) => [name, names.includes(name)]));

export class Page {
  constructor(complex, timings) {
    Object.assign(this, { complex, timings });
    this.crowded = complex.set_count > crowd;
    this.of_atoms = Boolean(complex.data.atoms || complex.pores) || (complex.has_balls && fills_space(complex));
    this.state = new State(layers(this.of_atoms ? atom_layers : this.crowded ? crowded_layers : first_layers));
    this.state.see_through = this.of_atoms || !this.crowded;
    if (this.crowded && !this.of_atoms) this.state.limit = typical_radius(complex.set_radius);
    this.actions = this.make_actions();
    this.ready = new Promise((resolve) => (this.is_ready = resolve));
  }

  async begin(full) {
    if (full) Object.assign(this.state, { full: true, limit: Infinity, layers: layers(layer_names) });
    const lines_first = this.state.layers.u2;
    if (lines_first) await this.complex.load_lines();
    this.set_theme(night().matches ? 'dark' : 'light', false);
    this.make_scene();
    this.make_parts();
    this.state.on_change((values) => this.changed(values));
    this.resize();
    await this.draw_first_frame();
    new ResizeObserver(() => this.resize()).observe(by_id('stage'));
    new ResizeObserver(() => this.draw_plots()).observe(by_id('diagram'));
    night().addEventListener('change', (event) => this.set_theme(event.matches ? 'dark' : 'light'));
    if (!lines_first) await this.load_lines();
    this.pick_deepest();
    this.timings.ready_ms = performance.now();
    this.is_ready(true);
  }

  async load_lines() {
    await this.complex.load_lines();
    if (this.state.layers.u2 || this.state.layers.infinity) this.scene?.refresh();
    if (this.state.picked !== none) this.picked_changed();
    if (this.tabs?.current === 'pockets') this.pockets.open();
  }

  pick_deepest() {
    const { complex, state } = this;
    const peak = complex.pockets && state.picked === none ? deepest_peak(complex) : none;
    if (peak === none) return;
    const { current } = this.tabs;
    this.actions.pick_pocket(peak);
    this.tabs.open(complex.data.claim ? current : 'pockets');
  }

  // Plots are drawn while the GPU draws the scene. The first frame is there when both are.
  async draw_first_frame() {
    this.scene?.draw();
    const drawn = this.scene?.finished();
    this.draw_plots();
    await drawn;
    this.timings.first_frame_ms = performance.now();
  }

  make_scene() {
    const say = (text) => Object.assign(by_id('stage-message'), { hidden: false, textContent: text });
    try {
      this.scene = new ComplexScene(by_id('scene'), this.complex, this.state, this.palette);
      this.scene.on_view = (view) => this.view_changed(view);
    } catch (error) {
      this.scene = null;
      by_id('scene').hidden = true;
      return say(
        'WebGL is not available here, so the scene cannot be drawn. The diagram, the table and the details still work.',
      );
    }
    if (this.complex.point_count === 0) say('No points: this input is empty, and so is its flow complex.');
  }

  make_head() {
    const { complex, state } = this;
    by_id('name').textContent = shown_name(complex.data.name);
    by_id('name').title = complex.data.name;
    by_id('summary').textContent = summary(complex);
    this.make_tools();
    this.make_tabs();
    this.layers = new LayersBar(by_id('layers'), complex, state);
    key_list(by_id('keys'));
    this.listen_to_scene();
  }

  make_parts() {
    const { complex, state, actions } = this;
    this.make_head();
    this.diagram = new PersistenceDiagram(by_id('diagram'), complex, state, actions);
    this.histogram = new Histogram(by_id('histogram'), complex, state, actions);
    const parts = { choice: by_id('modes'), slider: by_id('threshold'), line: by_id('threshold-line') };
    this.threshold = new Threshold(parts, complex, state, actions, this.histogram);
    const level = { root: by_id('cycle'), slider: by_id('level'), line: by_id('level-line') };
    this.level = new CycleLevel(level, complex, state);
    by_id('threshold-card').hidden = complex.set_count === 0;
    const signs = [0, 1, 2].map((dimension) => element('span', {}, glyph(dimension), String(dimension)));
    fill(by_id('diagram-legend'), 'dimension', signs);
    this.brush_changed();
    if (!this.scene) this.view_changed(null);
  }

  make_tools() {
    const { actions, state, scene } = this;
    const tool = (id, text, click, title, pressed = null) =>
      element(
        'button',
        { id: `tool-${id}`, title, click, 'aria-pressed': pressed === null ? null : `${pressed}` },
        text,
      );
    fill(by_id('tools'), [
      scene && this.crowded ? tool('full', 'Full detail', actions.full, 'F', state.full) : null,
      scene && !this.complex.pores ? tool('through', 'See through', actions.see_through, 'S', state.see_through) : null,
      scene ? tool('reset', 'Show all', actions.reset, 'Home') : null,
      scene ? tool('picture', 'PNG', actions.picture, 'G: save a picture') : null,
      tool('theme', 'Dark', actions.theme, 'T: dark or light', this.theme === 'dark'),
      tool('keys', 'Keys', actions.keys, '?'),
    ]);
  }

  make_tabs() {
    const { complex, actions } = this;
    const { claim } = complex.data;
    const findings = claim ? [['findings', 'Findings']] : [];
    const pages = [
      ['details', 'Point'],
      ...findings,
      ['table', 'Table', () => this.table?.open()],
      ...(complex.data.pockets ? [['pockets', 'Pockets', () => this.pockets?.open()]] : []),
      ['about', 'About'],
    ];
    this.tabs = new Tabs(by_id('tabs'), by_id('pages'), pages);
    this.details = new Details(this.tabs.page('details'), complex, actions);
    this.table = new FactsTable(this.tabs.page('table'), complex, actions);
    if (complex.data.pockets) this.pockets = new PocketTable(this.tabs.page('pockets'), complex, actions);
    if (claim) this.findings = new Findings(this.tabs.page('findings'), complex, this.scene, actions);
    const about = about_lines(complex).map((line) => element('p', {}, line));
    fill(this.tabs.page('about'), element('div', { class: 'about' }, about));
    this.details.show(none);
    this.tabs.open(claim ? 'findings' : 'details');
  }

  listen_to_scene() {
    const { scene, actions } = this;
    const canvas = by_id('scene');
    listen_to_keys(canvas, actions);
    if (!scene) return;
    let down = null;
    canvas.addEventListener('pointerdown', (event) => {
      if (event.isPrimary) down = event.button === 0 ? [event.clientX, event.clientY] : null;
    });
    canvas.addEventListener('pointerup', (event) => {
      if (!down || !event.isPrimary || event.button !== 0) return;
      if (Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) return;
      const box = canvas.getBoundingClientRect();
      actions.pick(scene.pick_at(event.clientX - box.left, event.clientY - box.top));
    });
  }

  make_actions() {
    const { state } = this;
    const if_scene =
      (action) =>
      (...values) =>
        this.scene ? action(this.scene, ...values) : undefined;
    return {
      pick: (point) => this.pick(point),
      pick_pocket: (peak) => this.pick(peak, { as_pocket: true }),
      pick_pair: (pair) => (pair === none ? this.pick(none) : this.pick(this.end_of_pair(pair), { as_pair: true })),
      brush: (belongs, by) => this.brush(belongs, by),
      threshold: (limit) => this.let_go_of_brush({ limit }),
      mode: (mode) => this.let_go_of_brush({ mode, limit: no_limit(mode) }),
      finding: (i) => state.change({ finding: state.finding === i ? -1 : i }),
      approach: (point = state.picked) => this.approach(point),
      copy: (text, what) => copy_text(text).then(() => this.announce(`Copied ${what}.`)),
      full: if_scene(() => state.change({ full: !state.full })),
      see_through: if_scene(() => state.change({ see_through: !state.see_through })),
      theme: () => this.set_theme(this.theme === 'dark' ? 'light' : 'dark'),
      picture: if_scene(() => this.picture()),
      keys: () => by_id('keys').showModal(),
      reset: if_scene((scene) => scene.reset_camera()),
      turn: if_scene((scene, x, y) => scene.turn(-0.12 * x, -0.12 * y)),
      pan: if_scene((scene, x, y) => scene.pan(x, y)),
      zoom: if_scene((scene, factor) => scene.turn(0, 0, factor)),
      step: (way) => this.step(way),
      escape: () => this.let_go(),
    };
  }

  pick(point, as = {}) {
    this.state.change({ picked: point, as_pocket: false, as_pair: false, ...as });
  }

  let_go() {
    const { state } = this;
    if (state.picked !== none) this.actions.pick(none);
    else if (state.finding >= 0) state.change({ finding: -1 });
    else this.brush(null);
  }

  // The end of a pair that has a surface, or else its birth.
  end_of_pair(pair) {
    const { birth, death, set_of_point } = this.complex;
    return [death[pair], birth[pair]].find((point) => point !== none && set_of_point[point] !== none) ?? birth[pair];
  }

  brush(belongs, by) {
    for (const plot of [this.diagram, this.histogram]) if (plot !== by) plot.brush.rectangle = null;
    if (belongs === null) this.state.change({ brush: null });
    else this.state.brush_where(this.complex.pair_count, belongs);
  }

  let_go_of_brush(values) {
    for (const plot of [this.diagram, this.histogram]) plot.brush.rectangle = null;
    this.state.change({ ...values, brush: null });
  }

  approach(point) {
    if (point === none || !this.scene) return;
    const distance = Math.min(8, Math.max(0.25, 6 * this.complex.frame_radius(point)));
    this.scene.look_at(this.complex.frame_position(point), distance, !calm());
  }

  // Goes through the points that are drawn, or where none are, through those with a surface.
  step(way) {
    const drawn = this.scene ? this.scene.seen_points() : this.table.list();
    const list = drawn.length > 0 ? drawn : this.complex.set_point;
    if (list.length === 0) return;
    const at = list.indexOf(this.state.picked);
    const next = at < 0 ? (way > 0 ? 0 : list.length - 1) : at + way + list.length;
    this.actions.pick(list[next % list.length]);
  }

  announce(text) {
    by_id('live').textContent = text;
  }

  picture() {
    const style = getComputedStyle(document.documentElement);
    const color = (name) => style.getPropertyValue(name).trim();
    const words = {
      name: shown_name(this.complex.data.name),
      caption: ['summary', 'threshold-line'].map((id) => by_id(id).textContent).filter(Boolean).join(' · '),
      paper: color('--desk'),
      ink: color('--ink'),
      muted: color('--muted'),
    };
    return this.scene.picture((canvas) => save_picture(canvas, words));
  }

  set_theme(theme, redraw = true) {
    this.theme = theme;
    this.palette = palettes[theme];
    const root = document.documentElement;
    root.dataset.theme = theme;
    this.palette.kinds.forEach((color, kind) => root.style.setProperty(`--kind${kind}`, color));
    for (const [symbol, color] of Object.entries(this.palette.elements))
      root.style.setProperty(`--element-${symbol}`, color);
    for (const name of ['surface', 's1', 's3', 'u1', 'u2', 'pockets', 'cycle', 'outline', 'claimed', 'truth'])
      root.style.setProperty(`--${name}`, this.palette[name]);
    if (!redraw) return;
    by_id('tool-theme').setAttribute('aria-pressed', String(theme === 'dark'));
    this.scene?.paint(this.palette);
    this.findings?.select(this.state.finding);
    this.draw_plots();
  }

  resize() {
    const { clientWidth, clientHeight } = by_id('stage');
    this.scene?.resize(clientWidth, clientHeight, Math.min(2, devicePixelRatio));
  }

  draw_plots() {
    this.diagram.draw(this.palette, Math.min(3, devicePixelRatio));
    this.draw_histogram();
  }

  draw_histogram() {
    if (this.complex.set_count > 0) this.histogram.draw(this.palette, Math.min(3, devicePixelRatio));
  }

  changed(values) {
    const has = (...names) => names.some((name) => name in values);
    if (has('layers')) this.layers.update(this.state);
    if (has('layers', 'level')) this.scene?.mark_picked();
    if (has('level')) this.level.update();
    if (has('picked')) this.picked_changed();
    if (has('finding')) this.finding_changed();
    if (has('mode', 'limit')) this.threshold.update();
    if (has('brush')) this.brush_changed();
    if (has('full')) by_id('tool-full')?.setAttribute('aria-pressed', String(this.state.full));
    if (has('see_through')) by_id('tool-through')?.setAttribute('aria-pressed', String(this.state.see_through));
    if (has('layers', 'limit', 'mode', 'brush', 'full')) this.scene?.refresh(has('limit', 'brush'));
    if (has('see_through', 'picked', 'finding', 'layers', 'level')) this.scene?.repaint_surface();
    if (has('picked', 'brush')) this.diagram.overlay();
    if (has('picked', 'limit', 'mode', 'brush')) this.draw_histogram();
  }

  picked_changed() {
    const { picked } = this.state;
    this.details.show(picked);
    this.level.update();
    this.table.set_picked(picked);
    this.pockets?.set_picked(picked);
    const stays = this.tabs.current === 'table' || (this.tabs.current === 'pockets' && this.state.as_pocket);
    if (picked !== none && !stays) this.tabs.open('details');
    this.scene?.mark_picked();
    this.scene?.redraw();
    this.announce(picked === none ? 'Nothing is picked.' : `Picked ${point_name(this.complex, picked)}.`);
  }

  finding_changed() {
    const { finding } = this.state;
    this.findings?.select(finding);
    const place = finding < 0 ? null : this.findings.place(finding);
    if (place && this.scene) this.scene.look_at(place.position, place.distance, !calm());
  }

  brush_changed() {
    const { complex } = this;
    const pairs = this.state.brushed_pairs();
    const line = by_id('brush-line');
    if (complex.pair_count === 0) return fill(line, 'No pair: the input has no point.');
    if (pairs.length === 0) return fill(line, 'Drag over pairs to see only these.');
    const ends = pairs.flatMap((pair) => [complex.birth[pair], complex.death[pair]]);
    const sets = ends.filter((point) => point !== none && complex.set_of_point[point] !== none).length;
    const clear = element('button', { class: 'quiet', id: 'clear-brush', click: () => this.brush(null) }, 'Clear');
    fill(line, `${count_text(pairs.length)} pairs brushed, with ${count_text(sets)} surfaces`, clear);
  }

  // What the view leaves out is said above the layers, with the way to see it.
  view_changed(view) {
    const { complex, actions } = this;
    const lines = notice_lines(complex.data, view);
    if (complex.point_count > 0 && complex.set_count === 0)
      lines.push('No point of index 2, so there is no surface S2 and no line U2.');
    const button = view?.thinned ? element('button', { click: actions.full }, 'Full detail') : null;
    const text = element('span', {}, lines.join(' '));
    fill(by_id('notice'), lines.length > 0 ? element('div', {}, text, button) : null);
    if (view) this.table?.set_shown(this.scene.seen_points());
  }

  // Where the lines that are drawn end, in the frame: by line of the data and side.
  line_ends() {
    const { starts, next, vertices } = this.complex.u2;
    return Array.from(starts, (start) => {
      let end = start;
      while (next[end] !== none) end = next[end];
      return Array.from(vertices.subarray(3 * end, 3 * end + 3));
    });
  }
}
