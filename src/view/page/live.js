// A run that is under way: its log comes in pieces from the program that serves the page.

import {showFacts} from './facts.js';

const PAUSE = 250; // [ms] between questions while there is nothing new
const REDRAW = 1000; // [ms] between drawings of the figures

export async function streamInto(app) {
  let chunk = 0, drawn = 0;
  const again = (force = false) => {
    if (!force && performance.now() - drawn < REDRAW) return;
    drawn = performance.now();
    app.replay.end = app.endOfRun();
    app.timeline.measure();
    app.updateFigures();
    showFacts(app);
    app.options.changed();
  };
  for (;;) {
    let answer;
    try {
      answer = await fetch('chunk?' + chunk);
    } catch {
      document.getElementById('subtitle').textContent += ' · the program has ended';
      return;
    }
    const bytes = answer.status === 200 ? new Uint8Array(await answer.arrayBuffer()) : null;
    if (bytes?.length > 0) {
      const first = app.log.events === 0;
      app.log.append(bytes);
      ++chunk;
      app.replay.end = app.endOfRun();
      if (first) {
        app.colours.measure();
        app.measure();
        app.setExponent(0);
        app.play(true);
      }
      again();
    } else if (bytes) {
      app.result = await (await fetch('result')).json();
      again(true);
      return;
    } else {
      await new Promise((done) => setTimeout(done, PAUSE));
    }
  }
}
