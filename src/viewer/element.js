// Makes elements of the page. Text is always a text node and never markup, so that names from an input or a claim
// cannot be more than text. Attributes that are functions are listeners.

export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (typeof value === 'function') made.addEventListener(key, value);
    else if (value === true) made.setAttribute(key, '');
    else if (value !== false && value !== null && value !== undefined) made.setAttribute(key, value);
  }
  for (const child of children.flat(Infinity))
    if (child !== null && child !== undefined && child !== false) made.append(child);
  return made;
}

export function fill(parent, ...children) {
  parent.replaceChildren(...children.flat(Infinity).filter((child) => child !== null && child !== false));
}

const svg = 'http://www.w3.org/2000/svg';
const outlines = [
  'M8 3.5a4.5 4.5 0 1 0 0 9a4.5 4.5 0 1 0 0-9z',
  'M3 3h10v10H3z',
  'M8 2l6.2 11.2H1.8z',
  'M8 1.2l2 4.4 4.8.6-3.6 3.3 1 4.8L8 11.9l-4.2 2.4 1-4.8L1.2 6.2 6 5.6z',
  'M8 1l7 7-7 7-7-7z',
];

// The sign of a kind of points, as in the scene.
export function glyph(kind) {
  const made = document.createElementNS(svg, 'svg');
  made.setAttribute('viewBox', '0 0 16 16');
  made.setAttribute('class', `glyph kind${kind}`);
  made.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS(svg, 'path');
  path.setAttribute('d', outlines[kind]);
  made.append(path);
  return made;
}
