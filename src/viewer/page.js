// The page itself: state, parts, and what happens on each action. Parts do not know each other; they call actions, and
// are told when the state has changed. `test_interface` is what scripts and tests may call, as window.flowcert.

import { none } from './complex.js';
import { Details } from './details.js';
import { element, fill, glyph } from './element.js';
import { rational_text } from './exact_sphere.js';
import { FactsTable } from './facts_table.js';
import { Findings, group_of } from './findings.js';
import { Histogram } from './histogram.js';
import { key_list, listen_to_keys } from './keyboard.js';
import { LayersBar } from './layers_bar.js';
import { palettes } from './palette.js';
import { PersistenceDiagram } from './persistence_diagram.js';
import { save_picture } from './picture_file.js';
import { ComplexScene } from './scene.js';
import { most, triangle_count } from './shown.js';
import { State } from './state.js';
import { Tabs } from './tabs.js';
import { typical_radius } from './typical_radius.js';
import { count_text, point_name, short_number } from './words.js';

const by_id = (id) => document.getElementById(id);
const calm = () => matchMedia('(prefers-reduced-motion: reduce)').matches;
const all_layers = {
  samples: true,
  index1: true,
  index2: true,
  index3: true,
  regular: true,
  s1: true,
  s2: true,
  u2: true,
};
const shape_layers = {
  samples: false,
  index1: false,
  index2: false,
  index3: false,
  regular: true,
  s1: false,
  s2: true,
  u2: false,
};

export class Page {
  constructor(complex, timings) {
    this.complex = complex;
    this.timings = timings;
    this.triangles = triangle_count(complex.s2.triangle_offsets, complex.set_point.keys());
    this.crowded = complex.set_count > 600;
    this.state = new State({ ...(this.crowded ? shape_layers : all_layers) });
    if (this.crowded) this.state.limit = typical_radius(complex.set_radius);
    else this.state.see_through = true;
    this.actions = this.make_actions();
    this.ready = new Promise((resolve) => (this.is_ready = resolve));
  }

  async begin(full) {
    if (full) Object.assign(this.state, { full: true, limit: Infinity, layers: { ...all_layers } });
    const lines_first = this.state.layers.u2;
    if (lines_first) await this.complex.load_lines();
    this.set_theme(matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light', false);
    this.make_scene();
    this.make_parts();
    this.state.on_change((values) => this.changed(values));
    this.resize();
    await this.draw_first_frame();
    new ResizeObserver(() => this.resize()).observe(by_id('stage'));
    new ResizeObserver(() => this.draw_plots()).observe(by_id('panel'));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', (event) =>
      this.set_theme(event.matches ? 'dark' : 'light'),
    );
    if (!lines_first) await this.complex.load_lines();
    this.timings.ready_ms = performance.now();
    this.is_ready(true);
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
    const message = by_id('stage-message');
    const say = (text) => Object.assign(message, { hidden: false, textContent: text });
    try {
      this.scene = new ComplexScene(by_id('scene'), this.complex, this.state, this.palette);
      this.scene.on_view = (view) => this.view_changed(view);
    } catch (error) {
      this.scene = null;
      console.warn(error.message);
      by_id('scene').hidden = true;
      say(
        'WebGL is not available here, so the scene cannot be drawn. The diagram, the table and the details still work.',
      );
      return;
    }
    if (this.complex.point_count === 0) say('No points: this input is empty, and so is its flow complex.');
    else if (this.complex.set_count === 0)
      this.small_note = 'No point of index 2, so there is no surface S2 and no line U2.';
  }

  make_parts() {
    const { complex, state, actions } = this;
    this.make_heading();
    this.make_tools();
    this.make_tabs();
    this.layers = new LayersBar(by_id('layers'), complex, state);
    this.diagram = new PersistenceDiagram(by_id('diagram'), complex, state, actions);
    this.histogram = new Histogram(by_id('histogram'), complex, state, actions);
    this.make_threshold();
    fill(
      by_id('diagram-legend'),
      'dimension',
      [0, 1, 2].map((dimension) => element('span', {}, glyph(dimension), dimension)),
    );
    key_list(by_id('keys'));
    this.listen_to_scene();
    if (!this.scene) this.view_changed(null);
    if (complex.pair_count === 0) by_id('brush-line').textContent = 'No pair: the input has no point.';
    if (complex.set_count === 0) by_id('threshold-card').hidden = true;
  }

  make_heading() {
    const { data, kind_counts } = this.complex;
    const regular = kind_counts[4] > 0 ? `, ${count_text(kind_counts[4])} regular stationary` : '';
    const merged = data.merged_duplicates > 0 ? ` (${count_text(data.merged_duplicates)} merged)` : '';
    const critical = data.critical.map(count_text).join(' + ');
    fill(
      by_id('summary'),
      `${count_text(data.points)} points${merged}; critical points of index 0 to 3: ${critical}${regular}`,
    );
  }

  make_tools() {
    const button = (id, text, action, title, pressed) =>
      element(
        'button',
        { id, title, click: action, 'aria-pressed': pressed === undefined ? null : String(pressed) },
        text,
      );
    fill(by_id('tools'), [
      this.scene && this.crowded ? button('tool-full', 'Full detail', this.actions.full, 'F', this.state.full) : null,
      this.scene
        ? button('tool-through', 'See through', this.actions.see_through, 'S', this.state.see_through)
        : null,
      this.scene ? button('tool-reset', 'Show all', this.actions.reset, 'Home') : null,
      this.scene ? button('tool-picture', 'PNG', this.actions.picture, 'G: save a picture') : null,
      button('tool-theme', 'Dark', this.actions.theme, 'T: dark or light', this.theme === 'dark'),
      button('tool-keys', 'Keys', this.actions.keys, '?'),
    ]);
  }

  make_tabs() {
    const { claim } = this.complex.data;
    this.tabs = new Tabs(by_id('tabs'), by_id('pages'), [
      ['details', 'Point'],
      ...(claim ? [['findings', 'Findings']] : []),
      ['table', 'Table', () => this.open_table()],
      ['about', 'About'],
    ]);
    this.details = new Details(this.tabs.page('details'), this.complex, this.actions);
    this.table = new FactsTable(this.tabs.page('table'), this.complex, this.actions);
    if (claim)
      this.findings = new Findings(this.tabs.page('findings'), this.complex, this.state, this.scene, this.actions);
    this.make_about();
    this.details.show(none);
    this.tabs.open(claim ? 'findings' : 'details');
  }

  open_table() {
    if (!this.table) return;
    this.table.visible = true;
    this.table.draw();
  }

  make_about() {
    const { data } = this.complex;
    const lines = [
      `Made by flowcert ${data.version} (commit ${data.commit}; kernel: ${data.kernel}; compiler: ${data.compiler}; CGAL ${data.cgal}).`,
      `Input SHA-256: ${data.input_sha256}.`,
      'Samples are the points of index 0. S1 is what flows to a point of index 1, a Gabriel edge; S2 what flows to one of index 2, a surface. ' +
        'U2 are the two orbits that leave a point of index 2; those to infinity are cut at three times the input’s box.',
      'Positions in the scene are rounded to 32-bit floats; those in the facts are exact, computed here from the samples.',
      'The page needs no network and sends nothing. It is under the MIT license and contains three.js.',
    ];
    const most_text = data.thinned
      ? `The program left out S2 and U2 of ${count_text(data.thinned.of - data.thinned.kept)} of ${count_text(data.thinned.of)} ` +
        `points of index 2, those of persistence below ${data.thinned.persistence}.`
      : null;
    fill(
      this.tabs.page('about'),
      element(
        'div',
        { class: 'about' },
        [most_text, ...lines].filter(Boolean).map((line) => element('p', {}, line)),
      ),
    );
  }

  make_threshold() {
    const { state, actions } = this;
    this.mode_buttons = [
      ['radius', 'Radius below'],
      ['persistence', 'Persistence above'],
    ].map(([mode, text]) =>
      element(
        'button',
        {
          role: 'radio',
          'data-mode': mode,
          click: () => actions.mode(mode),
          keydown: (event) => this.mode_key(event),
        },
        text,
      ),
    );
    fill(by_id('modes'), this.mode_buttons);
    by_id('threshold').addEventListener('input', (event) => {
      const part = Number(event.target.value) / 1000;
      const all = state.mode === 'radius' ? part === 1 : part === 0;
      actions.threshold(all ? (state.mode === 'radius' ? Infinity : -1) : this.histogram.value_at(part));
    });
    this.threshold_changed();
  }

  mode_key(event) {
    if (!event.key.startsWith('Arrow')) return;
    this.actions.mode(this.state.mode === 'radius' ? 'persistence' : 'radius');
    this.mode_buttons.find((button) => button.dataset.mode === this.state.mode).focus();
    event.preventDefault();
  }

  threshold_changed() {
    const { state } = this;
    for (const button of this.mode_buttons) {
      button.setAttribute('aria-checked', String(button.dataset.mode === state.mode));
      button.tabIndex = button.dataset.mode === state.mode ? 0 : -1;
    }
    const slider = by_id('threshold');
    slider.value = Math.round(1000 * this.histogram.part_of(state.limit));
    const radius = state.mode === 'radius';
    const value = short_number(state.limit);
    const text =
      state.limit === Infinity || state.limit < 0
        ? 'all'
        : radius
          ? `distance below ${value} input units`
          : `persistence above ${value} input units squared`;
    slider.setAttribute('aria-valuetext', text);
    by_id('threshold-line').textContent = this.kept_sets(text);
  }

  kept_sets(text) {
    const { complex, state } = this;
    const values = state.mode === 'radius' ? complex.set_radius : complex.set_persistence;
    let kept = 0;
    for (const value of values) kept += state.mode === 'radius' ? value < state.limit : value > state.limit;
    return `${count_text(kept)} of ${count_text(complex.set_count)} surfaces: ${text}`;
  }

  listen_to_scene() {
    const { scene, actions } = this;
    listen_to_keys(by_id('scene'), actions);
    if (!scene) return;
    const canvas = by_id('scene');
    let down = null;
    canvas.addEventListener('pointerdown', (event) => (down = [event.clientX, event.clientY]));
    canvas.addEventListener('pointerup', (event) => {
      if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) return;
      const box = canvas.getBoundingClientRect();
      actions.pick(scene.pick_at(event.clientX - box.left, event.clientY - box.top));
    });
  }

  make_actions() {
    const { complex, state } = this;
    const scene = () => this.scene;
    return {
      pick: (point) => state.change({ picked: point }),
      pick_pair: (pair) => state.change({ picked: pair === none ? none : this.face_of_pair(pair) }),
      brush: (belongs, by) => this.brush(belongs, by),
      threshold: (limit) => state.change({ limit, brush: null }),
      mode: (mode) => state.change({ mode, limit: mode === 'radius' ? Infinity : -1, brush: null }),
      finding: (i) => state.change({ finding: state.finding === i ? -1 : i }),
      approach: (point = state.picked) => this.approach(point),
      copy: (text, what) => this.copy(text, what),
      full: () => scene() && state.change({ full: !state.full }),
      see_through: () => scene() && state.change({ see_through: !state.see_through }),
      theme: () => this.set_theme(this.theme === 'dark' ? 'light' : 'dark'),
      picture: () => scene() && this.picture(),
      keys: () => by_id('keys').showModal(),
      reset: () => {
        scene()?.reset_camera();
        scene()?.move();
      },
      turn: (x, y) => scene()?.turn(-0.12 * x, -0.12 * y),
      pan: (x, y) => scene()?.pan(x, y),
      zoom: (factor) => scene()?.turn(0, 0, factor),
      step: (way) => this.step(way),
      escape: () =>
        state.change(
          state.picked !== none ? { picked: none } : state.finding >= 0 ? { finding: -1 } : { brush: null },
        ),
      complex,
    };
  }

  // Of a pair, the end that has a surface, or else its birth.
  face_of_pair(pair) {
    const { birth, death, set_of_point, is_sample } = {
      ...this.complex,
      is_sample: (p) => this.complex.is_sample(p),
    };
    const ends = [death[pair], birth[pair]].filter((point) => point !== none);
    return (
      ends.find((point) => set_of_point[point] !== none) ?? ends.find((point) => !is_sample(point)) ?? birth[pair]
    );
  }

  brush(belongs, by) {
    for (const plot of [this.diagram, this.histogram]) if (plot !== by) plot.brush.rectangle = null;
    if (belongs === null) this.state.change({ brush: null });
    else this.state.brush_where(this.complex.pair_count, belongs);
  }

  approach(point) {
    if (point === none || !this.scene) return;
    const distance = Math.min(8, Math.max(0.25, 6 * this.complex.frame_radius(point)));
    this.scene.look_at(this.complex.frame_position(point), distance, !calm());
  }

  step(way) {
    const points = this.scene ? this.scene.cloud.shown : this.table.list();
    const list = points.length > 0 ? points : this.complex.set_point;
    if (list.length === 0) return;
    const at = list.indexOf(this.state.picked);
    this.actions.pick(list[(at < 0 ? (way > 0 ? 0 : list.length - 1) : at + way + list.length) % list.length]);
  }

  async copy(text, what) {
    try {
      await navigator.clipboard.writeText(text);
    } catch {
      const area = element('textarea', { class: 'hidden', 'aria-hidden': 'true' }, text);
      document.body.append(area);
      area.select();
      document.execCommand('copy');
      area.remove();
    }
    this.announce(`Copied ${what}.`);
  }

  announce(text) {
    by_id('live').textContent = text;
  }

  picture() {
    const caption = `${by_id('summary').textContent} · ${by_id('threshold-line').textContent}`;
    const style = getComputedStyle(document.documentElement);
    const color = (name) => style.getPropertyValue(name).trim();
    return this.scene.picture((canvas) =>
      save_picture(canvas, {
        name: this.complex.data.name,
        caption,
        paper: color('--desk'),
        ink: color('--ink'),
        muted: color('--muted'),
      }),
    );
  }

  set_theme(theme, redraw = true) {
    this.theme = theme;
    this.palette = palettes[theme];
    const root = document.documentElement;
    root.dataset.theme = theme;
    this.palette.kinds.forEach((color, kind) => root.style.setProperty(`--kind${kind}`, color));
    for (const name of ['surface', 's1', 'u2', 'claimed', 'truth'])
      root.style.setProperty(`--${name}`, this.palette[name]);
    if (!redraw) return;
    by_id('tool-theme').setAttribute('aria-pressed', String(theme === 'dark'));
    this.scene?.paint(this.palette);
    if (this.findings && this.state.finding >= 0) this.findings.select(this.state.finding);
    this.draw_plots();
  }

  resize() {
    const { clientWidth, clientHeight } = by_id('stage');
    this.scene?.resize(clientWidth, clientHeight, Math.min(2, devicePixelRatio));
  }

  draw_plots() {
    const ratio = Math.min(3, devicePixelRatio);
    this.diagram.draw(this.palette, ratio);
    if (this.complex.set_count > 0) this.histogram.draw(this.palette, ratio);
  }

  changed(values) {
    const has = (...names) => names.some((name) => name in values);
    if (has('layers')) this.layers.update(this.state);
    if (has('picked')) this.picked_changed();
    if (has('finding')) this.finding_changed();
    if (has('mode', 'limit')) this.threshold_changed();
    if (has('brush')) this.brush_changed();
    if (has('full')) by_id('tool-full')?.setAttribute('aria-pressed', String(this.state.full));
    if (has('see_through')) by_id('tool-through')?.setAttribute('aria-pressed', String(this.state.see_through));
    if (has('layers', 'limit', 'mode', 'brush', 'full')) this.scene?.refresh(has('limit', 'brush'));
    if (has('see_through') && this.scene) Object.assign(this.scene, { surface_is: null }).redraw();
    if (has('picked', 'brush')) this.diagram.overlay();
    if (has('picked', 'limit', 'mode', 'brush') && this.complex.set_count > 0)
      this.histogram.draw(this.palette, Math.min(3, devicePixelRatio));
  }

  picked_changed() {
    const { picked } = this.state;
    this.details.show(picked);
    this.table.set_picked(picked);
    if (picked !== none && this.tabs.current !== 'table') this.tabs.open('details');
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
    const pairs = this.state.brushed_pairs();
    const line = by_id('brush-line');
    if (pairs.length === 0)
      return fill(line, this.complex.pair_count > 0 ? 'Drag over pairs to see only these.' : '');
    const sets = new Set(
      pairs
        .flatMap((pair) => [this.complex.birth[pair], this.complex.death[pair]])
        .filter((point) => point !== none && this.complex.set_of_point[point] !== none),
    ).size;
    fill(
      line,
      `${count_text(pairs.length)} pairs brushed, ${count_text(sets)} surfaces`,
      element('button', { class: 'quiet', id: 'clear-brush', click: () => this.actions.brush(null) }, 'Clear'),
    );
  }

  // What the view leaves out is said above the layers, with the way to see it.
  view_changed(view) {
    const notice = by_id('notice');
    const left_out = view?.thinned;
    const data_thinned = this.complex.data.thinned;
    const parts = [];
    if (left_out && view.flat)
      parts.push(
        `Thinned view: each surface is drawn as the polygon that it spans${left_out.sets > 0 ? `, ${count_text(left_out.sets)} of shortest persistence are left out` : ''}.`,
      );
    else if (left_out) parts.push('Thinned view: what has the shortest persistence is left out.');
    if (left_out?.points > 0)
      parts.push(`${count_text(left_out.points)} points of shortest persistence are left out.`);
    if (left_out?.lines > 0) parts.push(`${count_text(left_out.lines)} lines of U2 as well.`);
    if (data_thinned)
      parts.push(
        `The program kept S2 and U2 of the ${count_text(data_thinned.kept)} most persistent of ${count_text(data_thinned.of)} points of index 2.`,
      );
    if (this.small_note) parts.push(this.small_note);
    const button = left_out ? element('button', { click: this.actions.full }, 'Full detail') : null;
    fill(notice, parts.length > 0 ? element('div', {}, element('span', {}, parts.join(' ')), button) : null);
    if (view) this.table?.set_shown(view.points);
  }

  test_interface() {
    const { complex, state, actions } = this;
    const point = ({ sample, record }) => (sample !== undefined ? sample : complex.sample_count + record);
    const name = (p) =>
      p === none ? null : complex.is_sample(p) ? { sample: p } : { record: p - complex.sample_count };
    return {
      none,
      complex,
      state,
      actions,
      page: this,
      ready: this.ready,
      timings: this.timings,
      group_of,
      counts: () => ({
        points: complex.data.points,
        samples: complex.sample_count,
        by_kind: complex.kind_counts,
        pairs: [0, 1, 2].map((d) => complex.pairs.dimension.reduce((sum, x) => sum + (x === d), 0)),
        s1: complex.kind_counts[1],
        s2_sets: complex.set_count,
        s2_triangles: this.triangles,
        s2_vertices: complex.s2.vertices.length / 3,
        u2_points: complex.u2?.record.length ?? null,
        u2_vertices: complex.u2 ? complex.u2.vertices.length / 3 : null,
      }),
      drawn: () => this.scene?.drawn() ?? null,
      most,
      brush_rectangle: (birth_low, birth_high, death_low, death_high) =>
        this.brush((pair) => {
          const [b, d] = [complex.birth_squared(pair), complex.death_squared(pair)];
          return b >= birth_low && b <= birth_high && d >= death_low && d <= death_high;
        }),
      brush_pairs: (pairs) => {
        const all = new Set(pairs);
        this.brush((pair) => all.has(pair));
      },
      clear_brush: () => this.brush(null),
      threshold: (mode, limit) => state.change({ mode, limit, brush: null }),
      pick: (what) => actions.pick(what === null ? none : point(what)),
      picked: () => name(state.picked),
      brushed: () => state.brushed_pairs(),
      shown: () => {
        const view = this.scene.view ?? (this.scene.lay_out(), this.scene.view);
        return {
          points: Array.from(view.points, name),
          sets: Array.from(view.sets, (set) => complex.s2.record[set]),
        };
      },
      exact: (what) => {
        const { center, squared } = complex.exact(point(what));
        return { center: center.map(rational_text), squared_distance: rational_text(squared) };
      },
      pixel_of: (what) => {
        const box = by_id('scene').getBoundingClientRect();
        const [x, y] = this.scene.pixel_of(point(what));
        return [x + box.left, y + box.top];
      },
      diagram_pixel_of: (pair) => [
        this.diagram.x.pixel(this.diagram.birth[pair]),
        this.diagram.y.pixel(this.diagram.death[pair]),
      ],
      save_picture: () => this.picture(),
    };
  }
}
