// Without a mouse: the theme's menus are labels of hidden boxes, which no key reaches. Here they are buttons, too.
addEventListener('DOMContentLoaded', () => {
  if (!document.querySelector('.skip-to-content')) {  // later versions of the theme have one
    document.querySelector('article').id ||= '__text';
    const skip = {className: 'skip', href: `#${document.querySelector('article').id}`, textContent: 'Skip to the text'};
    document.body.prepend(Object.assign(document.createElement('a'), skip));
  }
  for (const label of document.querySelectorAll('label[for]:not(.overlay)')) {
    label.tabIndex = 0;
    label.setAttribute('role', 'button');
    label.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' && event.key !== ' ') return;
      event.preventDefault();
      label.click();
    });
  }
  addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    for (const box of document.querySelectorAll('.sidebar-toggle')) box.checked = false;
  });
});
