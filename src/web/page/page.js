// The page: takes a file, has a worker compute, and shows the viewer's page of it. Files to download are made when they
// are asked for. Each input has a worker of its own, so that cancelling ends it, and no memory is left over.
// Nothing is loaded: the module, the worker and the examples are in the page, and its policy forbids all requests.
// An error, or cancelling, leaves what was shown before.

import { options_of, with_radii } from './options.js';

const $ = (id) => document.getElementById(id);
const number = (value) => value.toLocaleString('en');
const counted = (count, noun) => `${number(count)} ${noun}${count === 1 ? '' : 's'}`;
const address = (bytes, type) => URL.createObjectURL(new Blob([bytes], { type }));

async function unpacked(id) {
  const packed = Uint8Array.from(atob($(id).textContent), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Once for all workers. The module for radii waits until it is needed.
const module_of = async (id) => WebAssembly.compile(await unpacked(id));
const compiled = Promise.all([
  module_of('module.wasm'),
  unpacked('worker.js').then((code) => address(code, 'text/javascript')),
]);
let radii_compiled = null;

// Inputs are { name, content, options, began }: the one that was taken last, the one whose page is in the frame, and
// the one that is computed, null if it was cancelled. The worker has its own as `input`. Contents may be promises.
let taken = null, shown = null, ordered = null;
let worker = null, clock = 0;

// ---- What is computed ----

async function order(input, file) {
  ordered = input;
  set_busy(true);
  const broken = (error) => fail(`${input.name}: ${error.message}`);
  try {
    if (input.options.radii) radii_compiled ??= module_of('radii.wasm');
    const [[module, script], radii, bytes] = await Promise.all([compiled, radii_compiled, input.content]);
    if (ordered !== input) return;
    let first = {};
    if (worker?.input !== input) {
      worker?.terminate();
      worker = Object.assign(new Worker(script), { input, onmessage: answered, onerror: broken });
      first = { module, radii, bytes, name: input.name, options: input.options };
    }
    worker.postMessage({ file, ...first });
  } catch (error) {
    broken(error);
  }
}

function answered({ data, target }) {
  if (target !== worker || worker.input !== ordered) return;
  if (data.part) return show_progress(data.part, data.share);
  if (data.error) return fail(data.error);
  if (data.facts) show(worker.input, data);
  else save(data.file, data.bytes);
  set_busy(false);
}

function end() {
  worker?.terminate();
  worker = ordered = null;
  set_busy(false);
}

function fail(sentence) {
  end();
  say(sentence, 'error');
}

// ---- What is taken ----

function take(name, content, text = '') {
  say('');
  $('options').value = text;
  taken = { name, content, began: performance.now() };
  try {
    taken.options = options_of(text);
  } catch (error) {
    return fail(error.message);
  }
  order(taken, 'page');
}

function take_files(files) {
  if (files.length > 1) fail('One file at a time.');
  else if (files.length === 1) take(files[0].name, files[0].arrayBuffer());
}

const again = (text) => take(taken.name, taken.content, text);

// ---- What is shown ----

function set_busy(is_busy) {
  document.body.dataset.state = is_busy ? 'busy' : shown ? 'shown' : 'start';
  for (const part of ['view', 'controls']) $(part).hidden = !shown;
  $('start').hidden = shown !== null;
  clearInterval(clock);
  if (!is_busy) return $('work').close();
  if (!$('work').open) $('work').showModal();
  const start = performance.now();
  const tick = () => ($('seconds').textContent = `${Math.round((performance.now() - start) / 1000)} s`);
  clock = setInterval(tick, 500);
  tick();
  show_progress('reading');
}

function show_progress(part, share) {
  $('part').textContent = part;
  if (share > 0) $('progress').value = share;
  else $('progress').removeAttribute('value');
}

// Above the picture, with the options that a sentence may name.
function say(text, kind = '') {
  $('said').textContent = text;
  $('strip').className = kind;
  $('strip').hidden = text === '';
}

function show(input, { bytes, facts }) {
  const points = counted(facts.pointCount, facts.hasAtoms ? 'atom' : 'point');
  const counts = facts.counts ? `; critical points of index 0 to 3: ${facts.counts.map(number).join(' + ')}` : '';
  const seconds = ((performance.now() - input.began) / 1000).toFixed(1);
  $('told').textContent = `${input.name}: ${points}${counts}; computed here in ${seconds} s`;
  document.title = `${input.name} · Flowcert`;
  shown = Object.assign(input, { page: bytes });
  // A frame of a blob: would not be of this origin, from disk, and files dropped on it could not be taken.
  $('view').srcdoc = new TextDecoder().decode(bytes);
  $('radii-choice').hidden = !facts.hasAtoms;
  $('radii').value = `${input.options.radii ?? ''}`.split(',')[0];
  for (const button of document.querySelectorAll('[data-file]'))
    button.hidden = !facts.counts && button.dataset.file !== 'page';
  say(facts.notes.map((note) => note.text).join('\n'));
}

function save(file, bytes) {
  const stem = shown.name.replace(/\.gz$/i, '').replace(/\.[^.]*$/, '') || 'flow-complex';
  const ending = { page: '.html', records: '.jsonl', persistence: '.pers', surface: '_surface.ply' }[file];
  const link = Object.assign(document.createElement('a'), { href: address(bytes), download: stem + ending });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

// ---- What a person does ----

function on(target, type, act) {
  target.addEventListener(type, (event) => {
    event.preventDefault();
    document.body.classList.toggle('dragged', type === 'dragover');
    act(event);
  });
}

function accept_drops(target) {
  on(target, 'dragover', () => {});
  on(target, 'dragleave', () => {});
  on(target, 'drop', (event) => take_files(event.dataTransfer.files));
}

accept_drops(window);
$('view').addEventListener('load', () => accept_drops($('view').contentWindow));
on($('file'), 'change', ({ target }) => {
  take_files(target.files);
  target.value = '';
});
for (const [target, type] of [[$('cancel'), 'click'], [$('work'), 'cancel']])
  on(target, type, () => {
    end();
    say(`${taken.name}: cancelled`);
  });
on($('more'), 'click', () => ($('strip').hidden = !$('strip').hidden));
on($('back'), 'click', () => {
  shown = null;
  end();
  say('');
});
on($('again'), 'submit', () => again($('options').value));
on($('radii'), 'change', ({ target }) => again(with_radii($('options').value, target.value)));
for (const button of document.querySelectorAll('[data-example]'))
  on(button, 'click', () =>
    take(button.dataset.example, unpacked(button.dataset.example), button.dataset.options));
for (const button of document.querySelectorAll('[data-file]'))
  on(button, 'click', () => {
    if (button.dataset.file === 'page') save('page', shown.page);
    else order(shown, button.dataset.file);
  });
on($('licence'), 'toggle', async () => {
  $('notices').textContent = new TextDecoder().decode(await unpacked('notices.txt'));
});

const night = matchMedia('(prefers-color-scheme: dark)');
const choose_theme = () => (document.documentElement.dataset.theme = night.matches ? 'dark' : 'light');
on(night, 'change', choose_theme);
choose_theme();
