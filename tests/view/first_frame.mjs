// first_frame.mjs CAROM EXAMPLES MODULES CHROMIUM OUT: the size of a small page, and how long a run of 10^5 collisions takes to its
// first picture [ms, three times].

import {statSync} from 'node:fs';
import {desktop, pageOf, withPage} from './browser.mjs';

console.log(`break_shot: ${statSync(pageOf('break_shot')).size} bytes`);
for (const name of ['gas_in_a_box', 'gas_periodic']) {
  const page = pageOf(name, '--events', '100000'), times = [];
  for (let n = 0; n < 3; ++n) await withPage(page, desktop, async (p) => times.push(Math.round(await p.evaluate(() => window.carom.firstFrame))));
  console.log(`${name}, 100000 collisions: ${statSync(page).size} bytes, first frame after ${times.join(', ')} ms`);
}
