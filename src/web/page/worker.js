// The worker that computes: it takes one input, gives its page, and then each file that is asked for.
// It tells how far it is at most thirty times a second.

import { FlowComplex, load } from 'flowcert';

let complex, options, told = 0;

const files = {
  page: () => complex.page(options),
  records: () => complex.records(),
  persistence: () => new TextEncoder().encode(complex.persistenceText()),
  surface: () => complex.surface({ select: 'index2-radius<auto' }),
};

function progress(part, done, total) {
  const now = performance.now();
  if (now - told < 33) return;
  told = now;
  postMessage({ part, share: total > 0 ? done / total : 0 });
}

function facts() {
  const { pointCount, format, hasAtoms, notes } = complex;
  return { pointCount, format, hasAtoms, notes, counts: options.radii ? null : complex.counts };
}

async function begin(order) {
  options = order.options;
  await load({ wasm: order.module, radiiWasm: order.radii ?? undefined });
  complex = new FlowComplex(order.bytes, { ...options, name: order.name, progress });
}

// Of what fails while the module starts nobody else hears.
onunhandledrejection = ({ reason }) => postMessage({ error: reason.message ?? String(reason) });

onmessage = async ({ data }) => {
  try {
    if (data.bytes) await begin(data);
    const bytes = await files[data.file]();
    postMessage({ file: data.file, bytes, facts: data.file === 'page' ? facts() : null }, [bytes.buffer]);
  } catch (error) {
    postMessage({ error: error.message ?? String(error) });
  }
};
