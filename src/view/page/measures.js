// What the plots show, from the log: thinned where there is more than a plot can show, and computed from all of it.

/** At most 2 `buckets` points that keep the smallest and the largest value of each stretch of events. */
export function envelope(log, column, scale, buckets = 1200) {
  const times = [], values = [];
  const E = log.events, each = Math.max(1, E / buckets);
  let thinned = false;
  for (let b = 0; b * each < E; ++b) {
    const from = Math.floor(b * each), to = Math.min(E, Math.floor((b + 1) * each));
    let low = -1, high = -1;
    for (let e = from; e < to; ++e) {
      const v = column[e];
      if (Number.isNaN(v)) continue;
      if (low < 0 || v < column[low]) low = e;
      if (high < 0 || v > column[high]) high = e;
    }
    if (low < 0) continue;
    if (to - from > 2) thinned = true;
    for (const e of low === high ? [low] : [Math.min(low, high), Math.max(low, high)]) {
      times.push(log.time[e]);
      values.push(column[e] * scale);
    }
  }
  return {times, values, thinned};
}

/** Collisions in each of `bins` spans from start to end: [of two balls, with walls]. */
export function rates(log, start, end, bins) {
  const balls = new Float64Array(bins), walls = new Float64Array(bins), scale = bins / (end - start);
  for (let e = 0; e < log.events; ++e) {
    const b = Math.min(bins - 1, Math.max(0, Math.floor((log.time[e] - start) * scale)));
    if (log.kind[e] === 0) ++balls[b];
    if (log.kind[e] === 1) ++walls[b];
  }
  return {balls, walls};
}

const PIECES = 8; // of an accelerated flight

/**
 * Share of their time that the balls of finite mass spend at which speed, over the whole run: each flight counts with its
 * duration; an accelerated one in pieces, each at the speed in its middle. Beside it Maxwell's distribution of the same mean energy and the same masses.
 */
export function speedHistogram(replay, end, bins = 60) {
  const {log} = replay, D = log.dimension;
  const speeds = [], weights = [], masses = [];
  const fly = (i, c, from, to) => {
    const mass = c >= 0 && log.mass ? log.mass[c] : log.startMass[i];
    if (!Number.isFinite(mass) || (c >= 0 && log.radius && Number.isNaN(log.radius[c])) || !(to > from)) return;
    const pieces = [0, 1, 2].some((k) => k < D && replay.accelerationOf(i, c, k) !== 0) ? PIECES : 1;
    for (let p = 0; p < pieces; ++p) {
      let v = 0;
      for (let k = 0; k < D; ++k) v += replay.speedComponent(i, c, k, ((to - from) * (p + 0.5)) / pieces) ** 2;
      speeds.push(Math.sqrt(v));
      weights.push((to - from) / pieces);
      masses.push(mass);
    }
  };
  const skip = Math.max(1, Math.ceil(log.changes / 400000)); // beyond it every skip-th flight stands for the others
  const since = new Float64Array(log.balls).fill(replay.start), last = new Int32Array(log.balls).fill(-1);
  for (let c = 0; c < log.changes; ++c) {
    const i = log.changeBall[c], t = log.time[log.changeEvent[c]];
    if (c % skip === 0 || last[i] < 0) fly(i, last[i], since[i], t);
    since[i] = t;
    last[i] = c;
  }
  for (let i = 0; i < log.balls; ++i) fly(i, last[i], since[i], end);
  const total = weights.reduce((a, b) => a + b, 0);
  if (!(total > 0)) return null;
  let energy = 0, top = 0;
  for (let n = 0; n < speeds.length; ++n) {
    energy += (weights[n] * masses[n] * speeds[n] ** 2) / 2;
    top = Math.max(top, speeds[n]);
  }
  if (!(top > 0)) return null;
  const kT = (2 * energy) / (D * total);
  let width = top / bins;
  const rms = Math.sqrt(speeds.reduce((a, v, n) => a + weights[n] * v * v, 0) / total);
  if (top > 6 * rms) width = (6 * rms) / bins; // a long tail does not squeeze the rest
  const density = new Float64Array(bins);
  for (let n = 0; n < speeds.length; ++n) {
    const b = Math.min(bins - 1, Math.floor(speeds[n] / width));
    density[b] += weights[n] / (total * width);
  }
  const kinds = new Map();
  let counted = 0;
  for (let i = 0; i < log.balls; ++i) {
    const m = log.startMass[i];
    if (!Number.isFinite(m)) continue;
    kinds.set(m, (kinds.get(m) ?? 0) + 1);
    ++counted;
  }
  const centres = Array.from({length: bins}, (_, b) => (b + 0.5) * width);
  const maxwell = centres.map((v) => [...kinds].reduce((sum, [m, n]) => sum + (n / counted) * maxwellDensity(v, m / kT, D), 0));
  return {centres, density: Array.from(density), maxwell, sampled: skip > 1, width};
}

/** Of the speed v of a mass m at the temperature kT, b = m / kT, in d dimensions. */
function maxwellDensity(v, b, d) {
  const factor = d === 1 ? Math.sqrt((2 * b) / Math.PI) : d === 2 ? b : Math.sqrt(2 / Math.PI) * b ** 1.5;
  return factor * v ** (d - 1) * Math.exp((-b * v * v) / 2);
}
