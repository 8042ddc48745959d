// The keys of the scene, and the list of all keys. Plots and tabs handle their own.

import { element, fill } from './element.js';

const list = [
  ['Arrows', 'turn the scene; on a plot, move the rectangle that brushes'],
  ['Shift + arrows', 'move the scene; on a plot, stretch the rectangle'],
  ['+ and −', 'zoom'],
  ['Home', 'show all again'],
  ['N and P', 'pick the next and the previous point; on the diagram, the next pair by persistence'],
  ['Enter', 'go to the point; on the diagram, brush its pair'],
  ['Escape', 'let go of what is picked or brushed'],
  ['F, S, T, G', 'full detail, see through, dark or light, save a picture'],
  ['?', 'this list'],
];

export function key_list(dialog) {
  fill(
    dialog,
    element('h2', {}, 'Keys'),
    element(
      'dl',
      {},
      list.map(([key, text]) => [element('dt', {}, element('kbd', {}, key)), element('dd', {}, text)]),
    ),
    element('button', { class: 'quiet', click: () => dialog.close() }, 'Close'),
  );
}

// actions: turn, pan, zoom, reset, step, approach, escape, and those of letters.
export function listen_to_keys(canvas, actions) {
  const letters = {
    f: actions.full,
    s: actions.see_through,
    t: actions.theme,
    g: actions.picture,
    '?': actions.keys,
  };
  const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  canvas.addEventListener('keydown', (event) => {
    const step = steps[event.key];
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (step && event.shiftKey) actions.pan(...step);
    else if (step) actions.turn(...step);
    else if (event.key === '+' || event.key === '=') actions.zoom(0.87);
    else if (event.key === '-') actions.zoom(1 / 0.87);
    else if (event.key === 'Home') actions.reset();
    else if (event.key === 'Enter') actions.approach();
    else if (event.key === 'n' || event.key === 'N') actions.step(1);
    else if (event.key === 'p' || event.key === 'P') actions.step(-1);
    else return;
    event.preventDefault();
  });
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.matches('input, select, textarea')) return;
    // A dialog closes itself.
    if (event.target.closest('dialog')) return;
    if (event.key === 'Escape') actions.escape();
    else letters[event.key.toLowerCase()]?.();
  });
}
