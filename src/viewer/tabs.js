// Tabs with their pages: one page is seen; arrow keys go between tabs, as is usual for the role.

import { element, fill } from './element.js';

export class Tabs {
  // pages: [[name, title, shown], ...]
  constructor(list, root, pages) {
    this.pages = new Map();
    for (const [name, title, shown] of pages) {
      const page = element('div', {
        id: `page-${name}`,
        role: 'tabpanel',
        'aria-labelledby': `tab-${name}`,
        tabindex: -1,
      });
      const tab = element(
        'button',
        {
          id: `tab-${name}`,
          role: 'tab',
          'aria-controls': `page-${name}`,
          click: () => this.open(name),
          keydown: (event) => this.key(event, name),
        },
        title,
      );
      this.pages.set(name, { page, tab, shown });
    }
    fill(
      list,
      [...this.pages.values()].map(({ tab }) => tab),
    );
    fill(
      root,
      [...this.pages.values()].map(({ page }) => page),
    );
  }

  page(name) {
    return this.pages.get(name).page;
  }

  open(name) {
    this.current = name;
    for (const [other, { page, tab }] of this.pages) {
      page.hidden = other !== name;
      tab.setAttribute('aria-selected', String(other === name));
      tab.tabIndex = other === name ? 0 : -1;
    }
    this.pages.get(name).shown?.();
  }

  key(event, name) {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    const names = [...this.pages.keys()];
    const next = names[(names.indexOf(name) + step + names.length) % names.length];
    this.open(next);
    this.pages.get(next).tab.focus();
    event.preventDefault();
  }
}
