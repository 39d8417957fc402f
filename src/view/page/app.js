// The page: data in, stage and figures out, and the controls between them.

import {Colours} from './colours.js';
import {extentOf} from './extent.js';
import {EventList} from './event_list.js';
import {Log, bytesOf} from './log.js';
import {fullNumber, grouped, shortNumber} from './numbers.js';
import {Plots} from './plots.js';
import {Replay} from './replay.js';
import {Steps} from './steps.js';
import {Timeline} from './timeline.js';
import {bindControls} from './controls.js';
import {showFacts} from './facts.js';
import {streamInto} from './live.js';

const FLASH = 500; // [ms] that an impact stays to be seen
const MOST_FLASHES = 40;
const $ = (id) => document.getElementById(id);
const json = (id) => ($(id) ? JSON.parse($(id).textContent) : null);

export class App {
  constructor(Stage) {
    this.began = performance.now();
    this.scene = json('scene');
    this.result = json('result');
    this.log = new Log(this.scene.dimension, this.scene.balls, bytesOf($('start').textContent));
    this.takeChunks();
    this.replay = new Replay(this.log, this.scene);
    this.replay.end = this.endOfRun();
    this.playing = false;
    this.exponent = 0;
    this.flashes = [];
    this.seen = 0;
    this.stale = true;
    this.options = {
      following: -1, trails: this.log.balls <= 60, trailSpan: 1, arrows: false, impacts: true, images: false, largestImpulse: 1,
      shortNumber, changed: () => (this.stale = true), follow: (i) => this.follow(i),
    };
    setTheme(localStorageTheme() ?? (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light'));
    this.colours = new Colours(this.replay);
    this.measure();
    this.stage = new Stage($('exact'), this.replay, this.colours, this.options);
    this.addSteps(Stage);
    this.shape();
    addEventListener('resize', () => this.shape());
    this.timeline = new Timeline($('timeline'), this.replay, this.colours, (t) => this.seek(t));
    this.list = new EventList($('events'), this.replay, (k) => this.goTo(k));
    this.plots = new Plots($('figures'), this.replay, this.colours, (t) => this.seek(t));
    bindControls(this);
    showFacts(this);
    window.carom = this.face();
    requestAnimationFrame((now) => this.frame(now));
    // The first picture does not wait for the figures.
    setTimeout(() => this.updateFigures(), 30);
    if (this.scene.live) streamInto(this);
  }

  takeChunks() {
    const chunks = [...document.querySelectorAll('script.chunk')];
    let events = 0, changes = 0;
    const bytes = chunks.map((element) => {
      const b = bytesOf(element.textContent);
      element.remove();
      const head = new Uint32Array(b.buffer, 0, 8);
      events += head[2];
      changes += head[3];
      return b;
    });
    this.log.reserve(events, changes);
    for (const b of bytes) this.log.append(b);
  }

  endOfRun() {
    const last = this.log.events > 0 ? this.log.time[this.log.events - 1] : this.scene.start;
    return Math.max(last, this.result?.summary?.time ?? last);
  }

  /** Where the figures end: a long quiet time after the last event is left out. */
  endOfFigures() {
    const {log, replay} = this, last = log.events > 0 ? log.time[log.events - 1] : replay.end;
    return Math.min(replay.end, replay.start + 1.25 * (last - replay.start) || replay.end);
  }

  /** What depends on all of the log: the natural speed, the longest arrow, how long trails are. */
  measure() {
    const {log, replay} = this, duration = replay.end - replay.start;
    let largest = 0;
    for (let e = 0; e < log.events; ++e) if (log.impulse[e] > largest) largest = log.impulse[e];
    this.options.largestImpulse = largest || 1;
    // A fast ball crosses the stage in a second or so, but in a crowd none collides more often than once a second.
    const {lower, upper} = extentOf(replay), wide = Math.max(...upper.map((x, k) => x - lower[k]));
    const perBall = log.balls > 50 ? (duration * log.balls) / (2 * Math.max(1, log.events)) : Infinity;
    const natural = Math.min(duration / 4, wide / (1.2 * this.colours.fast), 0.7 * perBall) || 1;
    const power = 10 ** Math.floor(Math.log10(natural));
    this.natural = power * (natural / power >= 5 ? 5 : natural / power >= 2 ? 2 : 1);
    this.options.trailSpan = 2 * this.natural;
  }

  addSteps(Stage) {
    const head = json('steps-head');
    if (!head) return;
    this.steps = new Steps(this.replay, head, bytesOf($('steps').textContent));
    this.log.missed = new Set(head.missed);
    $('second').hidden = $('exact-caption').hidden = false;
    this.second = new Stage($('steps-canvas'), this.steps, this.colours, this.options);
    this.second.extent = this.stage.extent;
    for (const [from, to] of [[this.stage, this.second], [this.second, this.stage]])
      for (const type of ['pointermove', 'wheel', 'dblclick', 'pointerup', 'change']) (from.controls ?? from.canvas).addEventListener?.(type, () => (this.leader = from));
    this.leader = this.stage;
  }

  /** The stage is no taller than its scene needs. */
  shape() {
    const {lower, upper} = this.stage.extent, flat = this.scene.dimension === 2;
    const wide = $('stages').clientWidth / (this.second && innerWidth > 860 ? 2 : 1), stages = this.second && innerWidth <= 860 ? 2 : 1;
    if (flat) $('stages').style.setProperty('--tall', stages * (((upper[1] - lower[1]) / (upper[0] - lower[0])) * wide + (innerWidth > 860 ? 90 : 60)) + 'px');
  }

  get speed() {
    return this.natural * 10 ** this.exponent;
  }

  play(on = !this.playing) {
    if (on && this.replay.hi >= this.replay.end && !this.scene.live) this.goTo(0);
    this.playing = on;
    $('play').dataset.playing = String(on);
    $('play').setAttribute('aria-label', on ? 'Pause' : 'Play');
    this.options.changed();
  }
  seek(t) {
    this.replay.seek(Math.max(this.replay.start, Math.min(this.replay.end, t)));
    this.settle();
  }
  goTo(k) {
    this.replay.goTo(k);
    this.settle();
  }
  step(by) {
    this.play(false);
    const {replay} = this;
    if (by < 0 && !replay.atEvent) by += 1; // back to the event that was last
    if (replay.event + by > this.log.events) return this.seek(replay.end);
    this.goTo(replay.event + by);
  }
  settle() {
    this.flashes = [];
    this.seen = this.replay.event;
    this.options.changed();
  }
  follow(i) {
    this.options.following = i;
    $('ball-card').hidden = i < 0;
    this.options.changed();
  }

  frame(now) {
    const passed = Math.min(100, now - (this.before ?? now));
    this.before = now;
    if (this.playing) {
      this.replay.advance((passed / 1000) * this.speed);
      if (this.replay.hi >= this.replay.end) {
        this.replay.seek(this.replay.end);
        if (!this.scene.live || this.result) this.play(false);
      }
      this.noteFlashes(now);
      this.stale = true;
    }
    if (this.flashes.length > 0) this.stale = true;
    if (this.stale) this.draw(now);
    requestAnimationFrame((later) => this.frame(later));
  }

  noteFlashes(now) {
    const {replay} = this;
    for (let e = Math.max(this.seen, replay.event - MOST_FLASHES); e < replay.event; ++e) {
      const contact = replay.contact(e);
      if (contact) this.flashes.push({contact, born: now, missed: this.log.missed?.has(e)});
    }
    this.seen = replay.event;
    this.flashes = this.flashes.filter((f) => now - f.born < (f.missed ? 3 : 1) * FLASH).slice(-MOST_FLASHES);
  }

  /** The contacts to draw; at a moment of impact, that one with its numbers. */
  marks(now) {
    const {replay} = this, list = [];
    if (!this.options.impacts) return list;
    for (const f of this.flashes) list.push({contact: f.contact, strength: Math.max(0, 1 - (now - f.born) / FLASH)});
    if (replay.atEvent && !this.playing) {
      const contact = replay.contact(replay.event - 1);
      if (contact) list.push({contact, strength: 1, text: contact.kind === 2 ? '' : 'J = ' + shortNumber(contact.impulse)});
    }
    return list;
  }

  draw(now) {
    this.stale = false;
    const {replay} = this;
    this.stage.draw(this.marks(now));
    if (this.second) this.drawSecond(now);
    this.timeline.draw();
    this.list.tick(replay.event);
    this.plots.tick(replay.hi);
    this.tell();
    this.firstFrame ??= performance.now();
  }

  drawSecond(now) {
    const {steps, stage, second} = this;
    steps.follow();
    if (stage.camera) {
      const [from, to] = this.leader === second ? [second, stage] : [stage, second];
      to.camera.position.copy(from.camera.position);
      to.controls.target.copy(from.controls.target);
      to.camera.lookAt(to.controls.target);
    } else {
      const [from, to] = this.leader === second ? [second, stage] : [stage, second];
      to.centre = [...from.centre];
      to.scale = from.scale;
      to.fitted = from.fitted;
    }
    second.draw([]);
    const missed = this.flashes.filter((f) => f.missed);
    if (this.replay.atEvent && this.log.missed.has(this.replay.event - 1)) missed.push({contact: this.replay.contact(this.replay.event - 1), born: now});
    for (const on of [stage, second]) for (const f of missed) flashMissed(on, f, now, this.colours.page.missed);
    const so = steps.missedSoFar(this.replay.event);
    $('exact-caption').textContent = 'exact';
    $('steps-caption').innerHTML = `${steps.head.method}, dt ${shortNumber(steps.head.dt)} · <b>${so} missed</b>`;
  }

  tell() {
    const {replay, log} = this;
    $('clock').textContent = 't = ' + fullNumber(replay.hi);
    $('happening').textContent = `${grouped(replay.event)} of ${grouped(log.events)} events` + (replay.atEvent ? ' · at the moment of impact' : '');
    const facts = [];
    if (replay.event > 0) {
      const e = replay.event - 1;
      facts.push(['number', grouped(e + 1)], ['time', fullNumber(log.time[e])]);
      if (log.kind[e] === 2) {
        facts.push([replay.ballName(log.ball[e]), 'changes its motion']);
      } else {
        const contact = replay.contact(e);
        facts.push(['parties', `${replay.ballName(log.ball[e])} · ${replay.partnerName(e)}`], ['impulse', shortNumber(log.impulse[e], 6)],
          ['gap left', shortNumber(log.gap[e], 3)], ['normal', contact ? contact.normal.slice(0, log.dimension).map((n) => shortNumber(n, 4)).join(', ') : '–']);
        if (log.tie[e]) facts.push(['tie', 'at the moment of another one']);
        if (log.missed?.has(e)) facts.push(['by steps', 'missed']);
      }
    } else {
      facts.push(['none yet', 'press → for the first']);
    }
    fill($('impact'), facts);
    const i = this.options.following;
    if (i < 0) return;
    $('ball-title').textContent = 'Following ' + replay.ballName(i);
    const D = log.dimension, numbers = (v) => v.slice(0, D).map((x) => shortNumber(x, 5)).join(', ');
    fill($('ball'), [['position', numbers(replay.position(i))], ['velocity', numbers(replay.velocity(i))], ['speed', shortNumber(replay.speed(i), 5)],
      ['radius', shortNumber(replay.radius(i), 5)], ['mass', shortNumber(replay.mass(i), 5)]]);
  }

  updateFigures() {
    this.plots.theme = document.documentElement.dataset.theme;
    this.plots.update(this.result, this.endOfFigures());
    this.plots.tick(this.replay.hi);
    this.drawn = performance.now();
  }

  setTheme(theme) {
    setTheme(theme);
    this.colours.refresh();
    this.updateFigures();
    this.options.changed();
  }

  /** The page's own state, for tests and for the console. */
  face() {
    const app = this;
    return {
      get time() { return app.replay.hi; },
      get event() { return app.replay.event; },
      get events() { return app.log.events; },
      get playing() { return app.playing; },
      get end() { return app.replay.end; },
      get firstFrame() { return app.firstFrame; }, // [ms] since the page was asked for
      get figures() { return [...app.plots.figures.keys()]; },
      get drawn() { return app.drawn !== undefined && app.firstFrame !== undefined && !app.stale; },
      balls: app.log.balls,
      play: () => app.play(true), pause: () => app.play(false), seek: (t) => app.seek(t), goTo: (k) => app.goTo(k), follow: (i) => app.follow(i),
      /** Where ball i is: in the scene, on the stage in CSS pixels, and its radius there. */
      ball(i, stage = app.stage) {
        const position = stage.replay.position(i), radius = stage.replay.radius(i), scale = stage.pixelsPerLength(position);
        return {position: position.slice(0, app.log.dimension), screen: stage.toScreen(position), radius, pixels: radius * scale, pixelsPerLength: scale,
          velocity: stage.replay.velocity(i).slice(0, app.log.dimension)};
      },
      stepped(i) { return this.ball(i, app.second); },
      log: (k) => ({kind: app.log.kind[k - 1], ball: app.log.ball[k - 1], partner: app.log.partner[k - 1], time: app.log.time[k - 1], impulse: app.log.impulse[k - 1], balance: app.log.balance[k - 1]}),
    };
  }
}

export function fill(list, pairs) {
  const text = pairs.map(([a, b]) => a + '\u0000' + b).join('\u0001');
  if (list.dataset.text === text) return;
  list.dataset.text = text;
  list.replaceChildren(...pairs.flatMap(([a, b]) => {
    const dt = document.createElement('dt'), dd = document.createElement('dd');
    dt.textContent = a;
    dd.textContent = b;
    return [dt, dd];
  }));
}

function flashMissed(stage, flash, now, colour) {
  if (!stage.context) return;
  const {contact} = flash, g = stage.context, beat = 0.5 + 0.5 * Math.cos((now - flash.born) / 60);
  g.strokeStyle = colour;
  g.lineWidth = 2 + 3 * beat;
  for (const i of contact.kind === 0 ? [contact.ball, contact.partner] : [contact.ball]) {
    const [x, y] = stage.toScreen(stage.replay.position(i)), r = stage.replay.radius(i) * stage.scale;
    g.beginPath();
    g.arc(x, y, Math.min(2e4, r + 6 + 4 * beat), 0, 2 * Math.PI);
    g.stroke();
  }
  const [x, y] = stage.toScreen(contact.point);
  g.fillStyle = colour;
  g.font = '700 13px system-ui, sans-serif';
  g.textAlign = 'center';
  g.fillText('missed', x, y + stage.replay.radius(contact.ball) * stage.scale + 28);
}

function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
}

/** A choice made by hand outlives the page, where the browser lets it. */
function localStorageTheme() {
  try {
    return localStorage.getItem('carom-theme');
  } catch {
    return null;
  }
}
