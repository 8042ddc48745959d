// The layers of the scene: a button for each, with its sign and how many there are; it is also the legend.
// Layers of which there is nothing have no button.

import { element, fill, glyph } from './element.js';
import { count_text } from './words.js';

const kinds = [
  ['samples', 'samples', 0],
  ['index1', 'index 1', 1],
  ['index2', 'index 2', 2],
  ['index3', 'index 3', 3],
  ['regular', 'regular', 4],
];

// What is drawn of the picked point alone.
const of_picked = ({ cells, pockets, pores }) => [
  ...(cells
    ? [
        ['s3', 'S3 cells', cells.drawn.count, cells.of],
        ['u1', 'U1 surfaces', cells.u1.record.count, cells.u1.of],
      ]
    : []),
  ...(pockets ? [['pockets', 'pockets', pockets.numbers.count, pockets.of]] : []),
  ...(pores ? [['pockets', 'chambers', pores.chambers.length]] : []),
];

// The atoms of a molecule, with the colours of the most frequent elements; of other inputs, samples as balls.
function atoms_layer(complex) {
  if (!complex.has_balls) return [];
  const symbols = complex.atoms?.by_frequency().slice(0, 5) ?? [''];
  const balls = symbols.map((symbol) => [
    element('span', { class: 'ball', style: `background: var(--element-${symbol}, var(--element-other))` }),
    symbol && element('span', { class: 'symbol' }, symbol),
  ]);
  const name = complex.atoms ? 'atoms' : 'balls';
  return [['atoms', name, complex.sample_count, element('span', { class: 'elements' }, balls)]];
}

export class LayersBar {
  constructor(root, complex, state) {
    const points = kinds.map(([name, text, kind]) => [name, text, complex.kind_counts[kind], glyph(kind)]);
    const stroke = (name) => element('span', { class: `stroke ${name}`, 'aria-hidden': 'true' });
    const lines = [
      ['s1', 'S1 edges', complex.kind_counts[1]],
      ['s2', 'S2 surfaces', complex.set_count],
      ['u2', 'U2 lines', complex.finite_line_count],
      ['infinity', 'U2 to infinity', complex.infinite_line_count],
      ...of_picked(complex.data),
    ].map(([name, text, count, of]) => [name, text, count, stroke(name), of]);
    this.buttons = new Map();
    for (const [name, text, count, sign, of] of [...atoms_layer(complex), ...lines, ...(complex.pores ? [] : points)])
      if (count > 0)
        this.buttons.set(
          name,
          element(
            'button',
            {
              'data-layer': name,
              title: of === undefined ? null : 'Drawn for the picked point',
              click: () => state.set_layer(name, !state.layers[name]),
            },
            sign,
            text,
            element('span', { class: 'count' }, count_text(count), of > count ? ` of ${count_text(of)}` : null),
          ),
        );
    fill(root, [...this.buttons.values()]);
    this.update(state);
  }

  update(state) {
    for (const [name, button] of this.buttons) button.setAttribute('aria-pressed', String(state.layers[name]));
  }
}
