// What sections of facts are made of: rows with a name, exact values with a button that copies them, and chips.

import { element } from './element.js';
import { count_text } from './words.js';

const most_listed = 24;

export function section(title, ...parts) {
  return element('section', { class: 'facts' }, element('h4', {}, title), parts);
}

export function fact(name, ...text) {
  return element('div', { class: 'row' }, element('dt', {}, name), element('dd', {}, text));
}

// text: the exact value, as it is copied; parts: what is shown of it.
export function exact_fact(actions, name, text, ...parts) {
  const title = `Copy the exact value of ${name}`;
  const click = () => actions.copy(text, `exact ${name}`);
  const copy = element('button', { class: 'copy', title, 'aria-label': title, click }, 'copy');
  return element(
    'div',
    { class: 'row' },
    element('dt', {}, name),
    element('dd', { 'data-exact': text }, parts, copy),
  );
}

export function chips(items, button) {
  const rest = items.length - most_listed;
  return element(
    'div',
    { class: 'chips' },
    items.slice(0, most_listed).map((item) => button(item)),
    rest > 0 ? element('span', { class: 'muted' }, `and ${count_text(rest)} more`) : null,
  );
}
