// What `check` found wrong with a claim: findings by group, and the place of each in the scene, with the claimed and
// the true sphere, the samples inside the claimed one, and the lines that differ. What is claimed is dashed, and drawn
// over what is true in the same place.
// All texts come from a claim and enter as text.

import { BufferAttribute, BufferGeometry, Points } from 'three';
import { element, fill } from './element.js';
import { LineLayer } from './line_layer.js';
import { paint_points, point_material } from './point_cloud.js';
import { claim_order, sphere_mark } from './sphere_mark.js';
import { count_text, row_text } from './words.js';

const groups = [
  ['missed', ['missing', 'missed-by-cluster']],
  [
    'extra',
    [
      'not-cospherical',
      'ball-not-empty',
      'contact-incomplete',
      'outside-hull',
      'collision-as-critical',
      'claimed-twice',
      'extra',
    ],
  ],
  ['wrong index', ['wrong-index']],
  ['wrong position', ['wrong-position', 'rounding']],
  ['wrong limits', ['wrong-incidence', 'wrong-polyline']],
  ['wrong surface', ['wrong-surface']],
];

export const group_of = (finding) =>
  finding.variation
    ? 'permitted variations'
    : (groups.find(([, reasons]) => reasons.includes(finding.reason))?.[0] ?? 'others');

const most_listed = 200;

export class Findings {
  constructor(root, complex, scene, actions) {
    Object.assign(this, { root, complex, scene, actions, claim: complex.data.claim });
    this.items = [];
    this.build();
  }

  build() {
    const { claim } = this;
    const head = element(
      'header',
      { class: 'fact-head' },
      element(
        'div',
        {},
        element('h3', {}, claim.name),
        element('p', { class: 'muted' }, `verdict: ${claim.verdict}; tolerance ${claim.tolerance}`),
        element('p', {}, this.sum_up()),
      ),
    );
    const by_group = new Map([...groups.map(([name]) => [name, []]), ['others', []], ['permitted variations', []]]);
    claim.findings.forEach((finding, i) => by_group.get(group_of(finding)).push(i));
    const legend = element(
      'p',
      { class: 'legend' },
      element('span', { class: 'swatch claimed' }),
      'claimed, dashed ',
      element('span', { class: 'swatch truth' }),
      'true ',
      element('span', { class: 'swatch inside' }),
      'samples inside the claimed sphere',
    );
    this.facts = element('div', { class: 'finding-facts', 'aria-live': 'polite' });
    fill(
      this.root,
      head,
      legend,
      this.facts,
      [...by_group].filter(([, list]) => list.length > 0).map(([name, list]) => this.group(name, list)),
      this.notes('Not judged', claim.not_judged),
      this.notes('Not decided', claim.not_decided),
    );
  }

  sum_up() {
    const { findings, findings_count, verdict } = this.claim;
    if (verdict.startsWith('cannot be read')) return 'Nothing of the claim could be judged.';
    if (findings.length === 0) return 'Nothing is wrong with this claim.';
    const listed = findings_count > findings.length ? `, ${count_text(findings.length)} of them listed` : '';
    return `${count_text(findings_count)} ${findings_count === 1 ? 'finding' : 'findings'}${listed}.`;
  }

  group(name, list) {
    const rest = list.length - most_listed;
    return element(
      'details',
      { class: 'group', open: list.length <= 60 },
      element('summary', {}, name, element('span', { class: 'count' }, count_text(list.length))),
      element(
        'ul',
        {},
        list.slice(0, most_listed).map((i) => element('li', {}, this.item(i))),
      ),
      rest > 0 ? element('p', { class: 'muted' }, `and ${count_text(rest)} more`) : null,
    );
  }

  item(i) {
    const finding = this.claim.findings[i];
    const rows = (finding.contact ?? []).map((sample) => this.complex.sample_rows[sample]);
    const named = rows.length > 6 ? `${rows.slice(0, 6).join(' ')} …` : rows.join(' ');
    const button = element(
      'button',
      { class: 'finding', click: () => this.actions.finding(i) },
      element('b', {}, finding.reason),
      element('span', {}, rows.length > 0 ? `rows ${named}` : 'the whole claim'),
      element('span', { class: 'muted' }, finding.line === null ? '' : `line ${finding.line}`),
    );
    this.items[i] = button;
    return button;
  }

  notes(title, texts) {
    if (!texts || texts.length === 0) return null;
    return element(
      'section',
      { class: 'facts' },
      element('h4', {}, title),
      element(
        'ul',
        {},
        texts.map((text) => element('li', {}, text)),
      ),
    );
  }

  select(i) {
    for (const button of this.items) if (button) button.removeAttribute('aria-current');
    this.scene?.clear_claims();
    if (i < 0) return fill(this.facts);
    this.items[i]?.setAttribute('aria-current', 'true');
    const finding = this.claim.findings[i];
    fill(this.facts, this.describe(finding));
    if (this.scene) this.draw(finding);
  }

  describe(finding) {
    const row = (name, text) => element('div', { class: 'row' }, element('dt', {}, name), element('dd', {}, text));
    const inside = finding.spheres.flatMap((sphere) => (sphere.role === 'claimed' ? sphere.inside : []));
    const gap = this.complex.atoms ? ', ' : ' ';
    const rows = (samples) => samples.map((sample) => row_text(this.complex, sample)).join(gap);
    return element(
      'section',
      { class: 'facts' },
      element('h4', {}, `${group_of(finding)}: ${finding.reason}`),
      finding.sentence ? element('p', { class: 'line' }, finding.sentence) : null,
      element(
        'dl',
        { class: 'exact' },
        row('clause', `${finding.clause}, level ${finding.level}`),
        row('claimed', finding.claimed),
        row('truth', finding.truth),
        finding.line === null ? null : row('line', `${finding.line} of the claim`),
        finding.contact.length > 0 ? row('contact', `rows ${rows(finding.contact)}`) : null,
        finding.contact.length > 0 ? row('more', this.explain_command(finding.contact)) : null,
        inside.length > 0
          ? row('inside', `${inside.length === 1 ? 'row' : 'rows'} ${rows(inside)} inside the claimed sphere`)
          : null,
      ),
    );
  }

  // To be pasted into a shell, in the folder of the points.
  explain_command(samples) {
    const ids = samples.map((sample) => this.complex.sample_rows[sample]).join(',');
    const name = this.complex.data.name;
    const word = /^[\w./,:@%+-]+$/.test(name) ? name : `'${name.replaceAll("'", "'\\''")}'`;
    return `flowcert explain ${word} --ids ${ids}`;
  }

  draw(finding) {
    const { scene } = this;
    const { palette, complex } = scene;
    const color = (role) => (role === 'claimed' ? palette.claimed : palette.truth);
    const at = (sample) => complex.frame_position(sample);
    for (const sphere of finding.spheres) {
      scene.claims.add(sphere_mark(sphere.center, sphere.radius, color(sphere.role), sphere.role === 'claimed'));
      if (sphere.on.length > 0) this.rings(sphere.on.map(at), sphere.role);
      if (sphere.role === 'claimed' && sphere.inside.length > 0) this.crosses(sphere.inside.map(at));
    }
    if (finding.spheres.length === 0 && finding.contact.length > 0)
      this.rings(finding.contact.map(at), 'claimed');
    if (group_of(finding) === 'wrong limits') this.draw_true_lines(finding.record);
    for (const line of finding.lines) this.draw_line(line, color(line.role));
    if (finding.position) scene.mark_rings([finding.position], palette.ink, scene.claims);
    scene.redraw();
  }

  rings(positions, role) {
    const { palette, claims } = this.scene;
    if (role === 'claimed') this.scene.mark_rings(positions, palette.claimed, claims, true);
    else this.scene.mark_rings(positions, palette.truth, claims);
  }

  draw_true_lines(record) {
    const segments = record === null ? [] : this.scene.line_segments(record + this.complex.sample_count);
    const layer = new LineLayer({ width: 3.5, on_top: true });
    layer.paint(this.scene.palette.truth);
    layer.show(segments);
    this.scene.claims.add(layer.object);
  }

  draw_line({ positions, role }, color) {
    const segments = [];
    for (let i = 1; i < positions.length; ++i) segments.push(...positions[i - 1], ...positions[i]);
    const claimed = { width: 4.5, dash: 0.03, on_top: true, order: claim_order };
    const layer = new LineLayer(role === 'claimed' ? claimed : { width: 3.5, on_top: true });
    layer.paint(color);
    layer.show(Float32Array.from(segments));
    this.scene.claims.add(layer.object);
  }

  // Samples inside a claimed sphere: filled diamonds, in front of all.
  crosses(positions) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(Float32Array.from(positions.flat()), 3));
    geometry.setAttribute('kind', new BufferAttribute(new Uint8Array(positions.length).fill(4), 1));
    geometry.setAttribute('size', new BufferAttribute(new Float32Array(positions.length).fill(14), 1));
    const material = point_material();
    const { palette } = this.scene;
    paint_points(material, { ...palette, kinds: palette.kinds.map(() => palette.ink) });
    material.uniforms.pixel_ratio.value = this.scene.renderer.getPixelRatio();
    material.depthTest = false;
    const points = new Points(geometry, material);
    points.frustumCulled = false;
    points.renderOrder = 21;
    this.scene.claims.add(points);
  }

  // Where to look, and from how far: all spheres are seen.
  place(i) {
    const { position, spheres, contact } = this.claim.findings[i];
    if (spheres.length > 0) return around(spheres);
    const at = position ?? (contact.length > 0 ? this.complex.frame_position(contact[0]) : null);
    return at ? { position: at, distance: 1.5 } : null;
  }
}

function around(spheres) {
  const bound = (axis, sign) => Math.max(...spheres.map((s) => sign * s.center[axis] + s.radius));
  const low = [0, 1, 2].map((axis) => -bound(axis, -1));
  const high = [0, 1, 2].map((axis) => bound(axis, 1));
  const half = Math.hypot(...high.map((value, axis) => value - low[axis])) / 2;
  const position = high.map((value, axis) => (value + low[axis]) / 2);
  return { position, distance: Math.min(12, Math.max(0.4, 3.1 * half)) };
}
