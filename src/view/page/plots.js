// The figures beside the stage.

import uPlot from 'uplot';
import {envelope, rates, speedHistogram} from './measures.js';
import {grouped, shortNumber, ulpOf} from './numbers.js';

const HEIGHT = 150;
const FEWEST = 5; // balls whose speeds have a distribution

export class Plots {
  constructor(place, replay, colours, seek) {
    Object.assign(this, {place, replay, colours, seek});
    this.figures = new Map();
    this.order = [];
    new ResizeObserver(() => this.resize()).observe(place);
  }

  /** All figures anew; after a change of theme, and while a run streams in. */
  update(result, end) {
    const {replay} = this, {log} = replay;
    this.end = end;
    if (log.events > 0 && end > replay.start) {
      this.balance();
      this.energy();
      this.rates(end);
      if (log.balls >= FEWEST) this.speeds(replay.end);
    }
    for (const table of result?.tables ?? []) this.table(table);
  }

  balance() {
    const {log} = this.replay;
    let largest = 0;
    for (let e = 0; e < log.events; ++e) if (Math.abs(log.energy[e]) > largest) largest = Math.abs(log.energy[e]);
    largest = Math.max(largest, Math.abs(this.replay.scene.energy ?? 0));
    const ulp = ulpOf(largest);
    if (!(ulp > 0)) return;
    const {times, values, thinned} = envelope(log, log.balance, 1 / ulp);
    const worst = values.reduce((a, v) => Math.max(a, Math.abs(v)), 0);
    this.show('balance', 'Energy balance', `in ulps of the largest energy, ${shortNumber(largest)}`,
      [[this.replay.start, ...times, this.end], [0, ...values, values.at(-1)]], [{label: 'ulp', stroke: 'accent', points: true}],
      {note: `largest ${shortNumber(worst)} ulp` + (thinned ? `; ${grouped(log.events)} events, smallest and largest of each stretch drawn` : ''), range: [-1, 1]});
  }

  energy() {
    const {log} = this.replay;
    const {times, values} = envelope(log, log.energy, 1, 600);
    const lost = log.events > 0 ? log.dissipated[log.events - 1] : 0;
    if (!(lost > 0)) return;
    const t0 = this.replay.start, e0 = this.replay.scene.energy ?? values[0];
    const gone = envelope(log, log.dissipated, 1, 600);
    const at = [t0, ...times, this.end];
    this.show('energy', 'Energy', 'kinetic and potential, and what impacts dissipated',
      [at, [e0, ...values, values.at(-1)], resample(at, [t0, ...gone.times], [0, ...gone.values])],
      [{label: 'energy', stroke: 'ball2', step: true}, {label: 'dissipated', stroke: 'impulse', step: true}], {note: ''});
  }

  rates(end) {
    const {log} = this.replay, t0 = this.replay.start;
    const bins = Math.max(8, Math.min(120, Math.round(Math.sqrt(log.events) * 2)));
    const {balls, walls} = rates(log, t0, end, bins), width = (end - t0) / bins;
    const times = Array.from({length: bins + 1}, (_, b) => t0 + b * width);
    const list = (a) => [...Array.from(a, (n) => n / width), a[bins - 1] / width];
    this.show('rates', 'Collisions per time', 'of two balls, and with walls', [times, list(balls), list(walls)],
      [{label: 'balls', stroke: 'ball1', step: true, fill: true}, {label: 'walls', stroke: 'ball2', step: true}], {note: '', zero: true});
  }

  speeds(end) {
    const h = speedHistogram(this.replay, end);
    if (!h) return;
    this.show('speeds', 'Speeds', 'share of time at each speed, and Maxwell’s curve of the same energy', [h.centres, h.density, h.maxwell],
      [{label: 'run', stroke: 'ball2', bars: true}, {label: 'Maxwell', stroke: 'accent', width: 2}],
      {note: h.sampled ? 'from a share of the flights' : '', zero: true, xLabel: 'speed', speed: true});
  }

  /** A measured table: over its first column, or the middles of its bins; errors and bare counts are left to the file. */
  table(table) {
    const [first, second] = table.columns, binned = first.label === 'from' && second.label === 'to';
    const x = binned ? first.values.map((v, k) => (v + second.values[k]) / 2) : first.values;
    const others = table.columns.slice(1).filter((c) => !/^(to|share|samples|count)$|error/.test(c.label)).slice(0, 4);
    if (others.length === 0 || !x.every((v, k) => k === 0 || v > x[k - 1])) return;
    const label = binned ? 'the middle of the bin' : first.label;
    this.show('table-' + table.name, table.name.replace(/^observe\./, '').replaceAll('_', ' '), `measured: ${others.map((c) => c.label).join(', ')} over ${label}`,
      [x, ...others.map((c) => c.values)],
      others.map((c, k) => ({label: c.label, stroke: ['accent', 'ball1', 'ball2', 'impulse'][k], points: x.length < 60})), {note: '', xLabel: label, speed: true});
  }

  colour(name) {
    return getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
  }

  show(name, title, subtitle, data, series, {note, range, zero, xLabel = 'time', speed = false}) {
    let figure = this.figures.get(name);
    if (!figure) {
      figure = {element: document.createElement('figure')};
      figure.element.className = 'plot';
      figure.element.dataset.plot = name;
      this.place.append(figure.element);
      this.figures.set(name, figure);
    }
    const fresh = !figure.plot || figure.theme !== this.theme || figure.series !== series.length;
    if (!fresh) {
      figure.plot.setData(data);
      figure.element.querySelector('.note').textContent = note;
      return;
    }
    figure.theme = this.theme;
    figure.series = series.length;
    figure.plot?.destroy();
    const legend = series.length > 1 ? series.map((s) => `<i style="background:var(--${s.stroke})"></i>${s.label}`).join(' ') : '';
    figure.element.innerHTML = '<figcaption><b></b><span></span></figcaption><div class="chart"></div><p class="note"></p>';
    figure.element.querySelector('b').textContent = title;
    figure.element.querySelector('span').textContent = subtitle;
    figure.element.querySelector('.note').textContent = note;
    if (legend) figure.element.querySelector('figcaption').insertAdjacentHTML('beforeend', `<span class="legend">${legend}</span>`);
    const axis = {stroke: this.colour('muted'), grid: {stroke: this.colour('line'), width: 1}, ticks: {show: false}, font: '11px system-ui, sans-serif'};
    figure.plot = new uPlot({
      width: this.width(figure), height: HEIGHT, legend: {show: false}, cursor: {y: false, points: {show: false}, drag: {x: false, y: false}}, padding: [8, 12, 0, 0],
      scales: {x: {time: false, range: speed ? undefined : () => [this.replay.start, this.end]}, y: {range: (u, low, high) => span(low, high, range, zero)}},
      axes: [{...axis, size: 26, space: 60, values: (u, ticks) => ticks.map((t) => shortNumber(t, 4))}, {...axis, size: 58, space: 30, values: (u, ticks) => ticks.map((t) => shortNumber(t, 4))}],
      series: [{label: xLabel}, ...series.map((s) => this.line(s))],
      hooks: {ready: [(u) => this.ready(u, figure, speed)]},
    }, data, figure.element.querySelector('.chart'));
  }

  line(s) {
    const stroke = this.colour(s.stroke);
    return {
      label: s.label, stroke, width: s.width ?? (s.bars ? 0 : 1.5),
      fill: s.fill || s.bars ? stroke + (s.bars ? 'b0' : '40') : undefined,
      paths: s.step ? uPlot.paths.stepped({align: 1}) : s.bars ? uPlot.paths.bars({size: [1, 100]}) : undefined,
      points: {show: Boolean(s.points), size: 3, stroke, fill: stroke},
    };
  }

  /** A line at the moment that is shown; a click goes to a moment. */
  ready(u, figure, speed) {
    if (speed) return;
    figure.now = document.createElement('div');
    figure.now.className = 'now';
    u.over.append(figure.now);
    u.over.addEventListener('click', (event) => this.seek(u.posToVal(event.offsetX, 'x')));
  }

  tick(time) {
    for (const {plot, now} of this.figures.values())
      if (now) now.style.transform = `translateX(${plot.valToPos(time, 'x')}px)`;
  }

  width(figure) {
    return Math.max(160, figure.element.clientWidth - 32);
  }
  resize() {
    for (const figure of this.figures.values())
      if (figure.plot && figure.plot.width !== this.width(figure)) figure.plot.setSize({width: this.width(figure), height: HEIGHT});
  }
}

/** Values at `times`, of a step function given at `at`. */
function resample(times, at, values) {
  let k = 0;
  return times.map((t) => {
    while (k + 1 < at.length && at[k + 1] <= t) ++k;
    return values[k];
  });
}

function span(low, high, least, zero) {
  if (low === null || low === undefined) return [0, 1];
  if (zero) low = 0;
  if (least) [low, high] = [Math.min(low, least[0]), Math.max(high, least[1])];
  const margin = 0.08 * (high - low) || Math.abs(high) * 0.1 || 1;
  return [zero ? 0 : low - margin, high + margin];
}
