// Where every ball is at a moment, in closed form from its last change of motion: x + v s + a s^2 / 2, or in a magnetic field
// of cyclotron frequency w on the circle x + (2 / w) sin(h) R(h) v, h = w s / 2.
//
// A moment is the unevaluated sum of two doubles, as the times of the log are: a flight time s is rounded once, however late
// the moment and however slow the motion that is shown.

/** a + b exactly, as [sum, error]. */
function twoSum(a, b) {
  const s = a + b, t = s - a;
  return [s, a - (s - t) + (b - t)];
}

export class Replay {
  constructor(log, scene) {
    this.log = log;
    this.scene = scene;
    this.start = scene.start;
    this.growth = scene.radius_growth ?? null; // rates by ball
    this.acceleration = [0, 1, 2].map((k) => scene.acceleration[k] ?? 0);
    this.magnetic = scene.magnetic ?? 0; // a ball at rest stays so, fixed or not
    const periodic = scene.space.kind === 'periodic';
    this.period = [0, 1, 2].map((k) => (periodic && k < log.dimension ? scene.space.upper[k] - scene.space.lower[k] : 0));
    this.lower = [0, 1, 2].map((k) => (periodic ? scene.space.lower[k] ?? 0 : 0));
    this.event = 0; // events that have happened
    this.current = new Int32Array(log.balls).fill(-1); // change of motion that each ball is in; -1: the start
    this.hi = this.start;
    this.lo = 0;
  }

  get time() {
    return this.hi;
  }

  /** Time since event e, or since the start for e < 0. */
  since(e) {
    return e < 0 ? this.hi - this.start + this.lo : this.hi - this.log.time[e] + (this.lo - this.log.timeLow[e]);
  }

  /** Whether the moment is that of the last event that has happened. */
  get atEvent() {
    return this.event > 0 && this.since(this.event - 1) === 0;
  }

  forward() {
    const {log} = this;
    for (let c = log.changesBegin(this.event); c < log.changesEnd[this.event]; ++c) this.current[log.changeBall[c]] = c;
    ++this.event;
  }
  backward() {
    const {log} = this;
    --this.event;
    for (let c = log.changesEnd[this.event] - 1; c >= log.changesBegin(this.event); --c)
      this.current[log.changeBall[c]] = log.previous[c];
  }

  /** To the moment hi + lo, after the events at it. */
  seek(hi, lo = 0) {
    [this.hi, this.lo] = twoSum(hi, lo);
    while (this.event < this.log.events && this.since(this.event) >= 0) this.forward();
    while (this.event > 0 && this.since(this.event - 1) < 0) this.backward();
  }

  /** A step in time. */
  advance(by) {
    const [s, error] = twoSum(this.hi, by);
    this.seek(s, error + this.lo);
  }

  /** To the moment of event number k, counted from 1, just after it; 0: the start. */
  goTo(k) {
    k = Math.max(0, Math.min(this.log.events, k));
    while (this.event < k) this.forward();
    while (this.event > k) this.backward();
    this.hi = k === 0 ? this.start : this.log.time[k - 1];
    this.lo = k === 0 ? 0 : this.log.timeLow[k - 1];
  }

  alive(i) {
    const c = this.current[i];
    return c < 0 || !this.log.radius || !Number.isNaN(this.log.radius[c]);
  }
  radius(i) {
    const c = this.current[i];
    if (this.growth) return this.grown(i, this.since(-1));
    return c >= 0 && this.log.radius ? this.log.radius[c] : this.log.startRadius[i];
  }
  /** Radius of ball i, which grows, s after the start. */
  grown(i, s) {
    return this.log.startRadius[i] + this.growth[i] * s;
  }
  mass(i) {
    const c = this.current[i];
    return c >= 0 && this.log.mass ? this.log.mass[c] : this.log.startMass[i];
  }

  accelerationOf(i, c, k) {
    if (c >= 0 && this.log.acceleration) return this.log.acceleration[c * this.log.dimension + k];
    return this.log.fixed[i] ? 0 : this.acceleration[k];
  }

  /** Stored velocity of ball i, turned by an angle; component k. */
  turnedVelocity(i, c, k, angle) {
    const {log} = this, all = c < 0 ? log.startVelocity : log.velocity, at = 2 * (c < 0 ? i : c);
    const other = k === 0 ? -all[at + 1] : all[at];
    return Math.cos(angle) * all[at + k] + Math.sin(angle) * other;
  }

  /** Coordinate k of ball i, s after change c; not wrapped. */
  coordinate(i, c, k, s) {
    const {log} = this, D = log.dimension;
    const x = c < 0 ? log.startPosition[i * D + k] : log.position[c * D + k];
    if (this.magnetic !== 0) {
      const half = (this.magnetic * s) / 2;
      return x + ((2 * Math.sin(half)) / this.magnetic) * this.turnedVelocity(i, c, k, half);
    }
    const v = c < 0 ? log.startVelocity[i * D + k] : log.velocity[c * D + k];
    return x + s * (v + 0.5 * s * this.accelerationOf(i, c, k));
  }
  speedComponent(i, c, k, s) {
    const {log} = this, D = log.dimension;
    if (this.magnetic !== 0) return this.turnedVelocity(i, c, k, this.magnetic * s);
    return (c < 0 ? log.startVelocity[i * D + k] : log.velocity[c * D + k]) + s * this.accelerationOf(i, c, k);
  }

  wrapped(x, k) {
    const p = this.period[k];
    return p > 0 ? x - p * Math.floor((x - this.lower[k]) / p) : x;
  }

  /** Position of ball i now, wrapped into a periodic space. */
  position(i, out = [0, 0, 0]) {
    const c = this.current[i], s = this.since(c < 0 ? -1 : this.log.changeEvent[c]);
    for (let k = 0; k < this.log.dimension; ++k) out[k] = this.wrapped(this.coordinate(i, c, k, s), k);
    return out;
  }
  velocity(i, out = [0, 0, 0]) {
    const c = this.current[i], s = this.since(c < 0 ? -1 : this.log.changeEvent[c]);
    for (let k = 0; k < this.log.dimension; ++k) out[k] = this.speedComponent(i, c, k, s);
    return out;
  }
  speed(i) {
    const v = this.velocity(i, this.scratch ??= [0, 0, 0]);
    return Math.hypot(v[0], v[1], v[2]);
  }

  /** Where event e happened: point of contact, normal from the partner towards the ball, and its size. */
  contact(e) {
    const {log} = this, D = log.dimension;
    const ball = log.ball[e];
    let at = null;
    for (let c = log.changesBegin(e); c < log.changesEnd[e]; ++c) if (log.changeBall[c] === ball) at = c;
    if (at === null) return null;
    // A ball that grows by merging jumps to the common centre: then the contact is where its flight before ended.
    const before = log.previous[at], since = before < 0 ? -1 : log.changeEvent[before];
    const s = since < 0 ? log.time[e] - this.start + log.timeLow[e] : log.time[e] - log.time[since] + (log.timeLow[e] - log.timeLow[since]);
    const r = this.growth ? this.grown(ball, log.time[e] - this.start) : log.radius && before >= 0 ? log.radius[before] : log.startRadius[ball];
    const normal = [0, 0, 0], point = [0, 0, 0], centre = [0, 0, 0];
    for (let k = 0; k < D; ++k) {
      normal[k] = log.normal[e * D + k];
      centre[k] = log.radius ? this.wrapped(this.coordinate(ball, before, k, s), k) : log.position[at * D + k];
      point[k] = centre[k] - r * normal[k];
    }
    return {event: e, ball, partner: log.partner[e], kind: log.kind[e], impulse: log.impulse[e], gap: log.gap[e], normal, point, centre, radius: r};
  }

  /** The name of who ball met in event e. */
  partnerName(e) {
    const {log, scene} = this;
    if (log.kind[e] === 2) return '';
    if (log.kind[e] === 1) {
      const label = scene.wall_labels[log.partner[e]] ?? String(log.partner[e]);
      return /^[xyz][+-]$/.test(label) ? 'face ' + label : 'wall ' + label;
    }
    return this.ballName(log.partner[e]);
  }
  ballName(i) {
    return this.scene.names[i] ?? 'ball ' + i;
  }

  /**
   * The path of ball i over the last `span` of time, newest first, in at most `most` flights: visit(a, b, ageA, ageB) for
   * each straight piece, ages as shares of the span. In a periodic space each piece lies in the cell of its middle.
   */
  trail(i, span, most, visit) {
    const {log} = this, D = log.dimension;
    let c = this.current[i], until = this.since(c < 0 ? -1 : log.changeEvent[c]), left = span;
    const curved = [0, 1, 2].some((k) => this.accelerationOf(i, c, k) !== 0);
    for (let n = 0; n < most; ++n) {
      const from = Math.max(0, until - left);
      const pieces = this.magnetic !== 0 ? 1 + Math.min(200, Math.ceil(Math.abs(this.magnetic) * (until - from) * 4))
        : curved ? 12 : this.period[0] > 0 ? 2 : 1;
      for (let p = 0; p < pieces; ++p) {
        const s0 = until - ((until - from) * p) / pieces, s1 = until - ((until - from) * (p + 1)) / pieces;
        const a = [0, 0, 0], b = [0, 0, 0];
        for (let k = 0; k < D; ++k) {
          a[k] = this.coordinate(i, c, k, s0);
          b[k] = this.coordinate(i, c, k, s1);
          const shift = this.period[k] > 0 ? this.period[k] * Math.floor(((a[k] + b[k]) / 2 - this.lower[k]) / this.period[k]) : 0;
          a[k] -= shift;
          b[k] -= shift;
        }
        visit(a, b, (span - left + until - s0) / span, (span - left + until - s1) / span);
      }
      left -= until - from;
      if (left <= 0 || c < 0) return;
      const before = log.previous[c];
      const began = before < 0 ? -1 : log.changeEvent[before], ended = log.changeEvent[c];
      until = began < 0 ? log.time[ended] - this.start + log.timeLow[ended]
        : log.time[ended] - log.time[began] + (log.timeLow[ended] - log.timeLow[began]);
      c = before;
    }
  }
}
