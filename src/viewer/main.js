// Joins the parts of the page: reads the data, makes state, scene, plots and facts, and draws the first frame.
// Big inputs begin with a thinned view of the shape; `#full` behind the page's address begins with everything.
// What is wrong with the data, or missing in the browser, is said in place of the scene, in one sentence.

import { can_decode } from './blobs.js';
import { Complex } from './complex.js';
import { Page } from './page.js';
import { PoresPage } from './pores_page.js';
import { shown_name } from './statements.js';
import { test_interface } from './test_interface.js';

function say(text) {
  const message = document.getElementById('stage-message');
  message.hidden = false;
  message.textContent = text;
}

async function start() {
  const timings = { script_ms: performance.now() };
  const data = JSON.parse(document.getElementById('flowcert-data').textContent);
  if (data === null) return say('This is the page without data. The command flowcert view fills it.');
  if (data.format !== 'flowcert-view' || data.format_version !== 1)
    return say('The data of this page are of another version.');
  document.title = `${shown_name(data.name)} · ${data.pores ? 'pores' : 'flow complex'}`;
  if (!can_decode())
    return say('This browser cannot decompress the data (DecompressionStream). One of 2023 or later can.');
  timings.parsed_ms = performance.now();
  const complex = new Complex(data);
  await complex.load_first();
  timings.decoded_ms = performance.now();
  const page = new (data.pores ? PoresPage : Page)(complex, timings);
  window.flowcert = test_interface(page);
  await page.begin(location.hash.includes('full'));
}

start().catch((error) => {
  console.error(error);
  say(`The page could not be drawn: ${error.message}`);
});
