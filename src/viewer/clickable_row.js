// A row of a table that picks something: with a click anywhere in it, or Enter while it has the focus. A button in it
// is for those who look for one. Without `pick` it is a row as others are.

import { element } from './element.js';

export function clickable_row(pick, attributes, ...cells) {
  if (!pick) return element('tr', attributes, ...cells);
  const click = (event) => {
    if (!event.target.closest('button')) pick();
  };
  const keydown = (event) => {
    if (event.key !== 'Enter' || event.target !== event.currentTarget) return;
    event.preventDefault();
    pick();
  };
  return element('tr', { ...attributes, class: 'clickable', tabindex: 0, click, keydown }, ...cells);
}

// The row of what is picked stands out.
export function mark_rows(rows, is_picked) {
  for (const row of rows)
    if (is_picked(row)) row.setAttribute('aria-current', 'true');
    else row.removeAttribute('aria-current');
}
