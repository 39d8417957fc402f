// view_test.mjs CAROM EXAMPLES MODULES CHROMIUM OUT: pages of examples in a real browser. Pages and screenshots stay in OUT.

import assert from 'node:assert/strict';
import {spawn} from 'node:child_process';
import {statSync} from 'node:fs';
import {join} from 'node:path';
import test from 'node:test';
import {carom, desktop, examples, file, pageOf, phone, run, withPage} from './browser.mjs';

/** Distance of the drawn surfaces of the two balls of event k [px], at its moment; of a wall event the ball's distance is not known: NaN. */
const gapAt = (page, k) => page.evaluate((k) => {
  const {carom} = window, e = carom.log(k);
  carom.goTo(k);
  if (e.kind !== 0) return NaN;
  const a = carom.ball(e.ball), b = carom.ball(e.partner);
  // Across the line of sight, in the plane of the two: |x_a - x_b| in the scene, at the scale of either.
  const apart = Math.hypot(...a.position.map((x, i) => x - b.position[i]));
  if (a.position.length === 3) return (apart - a.radius - b.radius) * Math.max(a.pixelsPerLength, b.pixelsPerLength);
  return Math.hypot(a.screen[0] - b.screen[0], a.screen[1] - b.screen[1]) - a.pixels - b.pixels;
}, k);

async function plays(page) {
  const before = await page.evaluate(() => window.carom.time);
  await page.keyboard.press(' ');
  await page.waitForFunction((t) => window.carom.time > t, before);
  await page.keyboard.press(' ');
  assert.equal(await page.evaluate(() => window.carom.playing), false);
}

const noProblems = (problems) => assert.deepEqual(problems, []);

test('the break shot: plays, steps to events where balls touch, ends where the run ends', async () => {
  const address = pageOf('break_shot');
  assert.ok(statSync(address).size < 1.5e6, 'a small run makes a small page');
  const final = JSON.parse(run('run', join(examples, 'break_shot/scene.toml'), '--until', '1.25', '--json', '--final', '--out', file('run'))).final;
  await withPage(address, desktop, async (page, problems) => {
    await plays(page);
    await page.keyboard.press('Home');
    for (let k = 1; k <= 3; ++k) {
      await page.keyboard.press('ArrowRight');
      assert.equal(await page.evaluate(() => window.carom.event), k);
    }
    const events = await page.evaluate(() => window.carom.events);
    assert.equal(events, 70);
    let touching = 0;
    for (let k = 1; k <= events; ++k) {
      const gap = await gapAt(page, k);
      if (Number.isNaN(gap)) continue;
      ++touching;
      assert.ok(Math.abs(gap) < 1e-6, `event ${k}: ${gap} px apart`);
    }
    assert.equal(touching, 39);
    // From either side of a moment the same places, and those of carom run.
    const places = await page.evaluate(() => [0, 3].map((from) => {
      window.carom.seek(from);
      window.carom.seek(1.25);
      return Array.from({length: 16}, (_, i) => window.carom.ball(i).position);
    }));
    assert.deepEqual(places[0], places[1]);
    for (const ball of final)
      ball.position.forEach((x, k) => assert.ok(Math.abs(x - places[0][ball.index][k]) < 1e-15 * 8, `ball ${ball.index}`));
    assert.deepEqual(await page.evaluate(() => window.carom.figures), ['balance', 'energy', 'rates', 'speeds']);
    assert.equal(await page.locator('.plot canvas').count(), 4);
    // A ball is followed by a click, time is reached by its text.
    await page.evaluate(() => window.carom.seek(0));
    const box = await page.locator('#exact').boundingBox(), [x, y] = await page.evaluate(() => window.carom.ball(0).screen);
    await page.mouse.click(box.x + x, box.y + y);
    await page.waitForFunction(() => document.getElementById('ball-title').textContent === 'Following cue');
    await page.keyboard.press('Escape');
    await page.fill('#jump-to', '#45');
    await page.press('#jump-to', 'Enter');
    assert.equal(await page.evaluate(() => window.carom.event), 45);
    await page.waitForTimeout(100);
    await page.screenshot({path: file('break_shot_desktop.png'), fullPage: true});
    noProblems(problems);
  });
  await withPage(address, phone, async (page, problems) => {
    await page.evaluate(() => window.carom.goTo(45));
    const [wide, seen] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
    assert.ok(wide <= seen, `${wide} px of page on ${seen} px of phone`);
    await page.waitForTimeout(100);
    await page.screenshot({path: file('break_shot_phone.png'), fullPage: true});
    noProblems(problems);
  });
});

test('a gas of spheres in three dimensions', async () => {
  await withPage(pageOf('gas_periodic', '--events', '3000', '--set', 'gas.0.count=200'), desktop, async (page, problems) => {
    await plays(page);
    for (const k of [1, 500, 2999]) {
      const gap = await gapAt(page, k);
      // A partner across a face of the periodic space is drawn on the other side.
      if (gap < 100) assert.ok(Math.abs(gap) < 1e-6, `event ${k}: ${gap} px apart`);
    }
    assert.deepEqual(await page.evaluate(() => window.carom.figures), ['balance', 'rates', 'speeds']);
    await page.click('[data-toggle=arrows]');
    await page.click('[data-toggle=images]');
    await page.waitForTimeout(300);
    await page.screenshot({path: file('gas_periodic.png')});
    noProblems(problems);
  });
});

test('a ball that bounces and comes to rest', async () => {
  const until = 3.0;
  const [ball] = JSON.parse(run('run', join(examples, 'bouncing_ball_at_rest/scene.toml'), '--until', String(until), '--json', '--final', '--out', file('run'))).final;
  await withPage(pageOf('bouncing_ball_at_rest'), {...desktop, colorScheme: 'dark'}, async (page, problems) => {
    await plays(page);
    const [there, last, end] = await page.evaluate((t) => {
      const {carom} = window;
      carom.seek(t);
      const there = carom.ball(0).position;
      carom.goTo(carom.events);
      const last = carom.ball(0).position[1];
      carom.seek(carom.end);
      return [there, last, carom.ball(0).position[1]];
    }, until);
    there.forEach((x, k) => assert.ok(Math.abs(x - ball.position[k]) < 1e-14, 'in flight'));
    assert.equal(end, last, 'it lies where it came to rest');
    await page.evaluate(() => window.carom.goTo(6));
    await page.waitForTimeout(100);
    await page.screenshot({path: file('bouncing_ball_at_rest.png')});
    noProblems(problems);
  });
});

test('steps beside the exact run miss the collision, and the page says so', async () => {
  await withPage(pageOf('tunnelling', '--compare', '0.01'), desktop, async (page, problems) => {
    await page.keyboard.press('ArrowRight');
    assert.ok(Math.abs(await gapAt(page, 1)) < 1e-6);
    await page.waitForFunction(() => document.getElementById('steps-caption').textContent.includes('1 missed'));
    // Both have gone on to the end: the exact balls back, the stepped ones through each other.
    const sides = await page.evaluate(() => {
      window.carom.seek(window.carom.end);
      return [window.carom.ball(0), window.carom.ball(1)].map((b) => Math.sign(b.position[0]));
    });
    await page.waitForFunction(() => window.carom.drawn);
    const stepped = await page.evaluate(() => [0, 1].map((i) => Math.sign(window.carom.stepped(i).position[0])));
    assert.deepEqual(sides, [-1, 1]);
    assert.deepEqual(stepped, [1, -1]);
    await page.evaluate(() => window.carom.goTo(1));
    await page.waitForTimeout(100);
    await page.screenshot({path: file('tunnelling.png')});
    noProblems(problems);
  });
});

test('one dimension, with paths in space and time', async () => {
  await withPage(pageOf('newtons_cradle'), phone, async (page, problems) => {
    await plays(page);
    assert.ok(Math.abs(await gapAt(page, 6)) < 1e-6);
    await page.waitForTimeout(100);
    await page.screenshot({path: file('newtons_cradle.png')});
    noProblems(problems);
  });
});

test('a run is watched while it goes, from this machine alone', async (t) => {
  const program = spawn(carom, ['run', join(examples, 'gas_in_a_box/scene.toml'), '--set', 'gas.0.count=100', '--events', '20000', '--live', '0', '--json', '--out', file('run')]);
  let out = '';
  program.stdout.on('data', (data) => (out += data));
  t.after(() => program.kill('SIGKILL'));
  let said = '';
  const first = await new Promise((found) => {
    program.stderr.on('data', (data) => {
      said += data;
      if (/http:|--live/.test(said)) found(said);
    });
    program.on('exit', () => found(said));
  });
  if (first.includes('--live is not part of this carom')) return t.skip(first);
  const [address] = /http:\/\/127\.0\.0\.1:\d+\//.exec(first);
  try {
    await withPage(address, desktop, async (page, problems) => {
      await page.waitForFunction(() => window.carom.events === 20000 && window.carom.time > 0);
      await page.waitForFunction(() => document.getElementById('subtitle').textContent.endsWith('20\u202f000 events'));
      assert.ok(Math.abs(await gapAt(page, 20000)) < 1e-6 || Number.isNaN(await gapAt(page, 20000)));
      assert.equal((await fetch(address + 'etc/passwd')).status, 404);
      assert.equal((await fetch(address + 'chunk?../../secret')).status, 400);
      await page.screenshot({path: file('live.png')});
      noProblems(problems);
    });
  } finally {
    program.kill('SIGINT');
  }
  assert.equal(await new Promise((end) => program.on('exit', end)), 0);
  assert.equal(JSON.parse(out).events.ball_ball + JSON.parse(out).events.ball_wall, 20000);
});
