// A table of numbers: the first rows, and a button for more where there are. `row` makes that of an item.

import { element, fill } from './element.js';
import { count_text } from './words.js';

export function number_table({ label, caption, heads, first = 24, id = null }, items, row) {
  let shown = first;
  const body = element('tbody');
  const more = element('button', { class: 'quiet', id, click: () => draw((shown *= 4)) });
  const draw = () => {
    fill(body, items.slice(0, shown).map(row));
    more.hidden = items.length <= shown;
    more.textContent = `${count_text(items.length - shown)} more`;
  };
  draw();
  const titles = element('thead', {}, element('tr', {}, heads.map((head) => element('th', { scope: 'col' }, head))));
  const table = element('table', { class: 'numbers' }, element('caption', {}, caption), titles, body);
  const region = element('div', { class: 'table-scroll', tabindex: 0, role: 'region', 'aria-label': label }, table);
  return element('div', {}, region, more);
}
