// A fixed-step run beside the exact one: places at the ends of its steps. Between them it knows nothing, so nothing moves.

import {Replay} from './replay.js';

export class Steps extends Replay {
  /** `head` and `bytes` as include/carom/write/replay_steps.hpp says. */
  constructor(exact, head, bytes) {
    super(exact.log, exact.scene);
    this.head = head;
    this.exact = exact;
    const {log} = exact, F = head.frames, n = log.balls * log.dimension;
    this.times = new Float64Array(bytes.buffer, 0, F);
    this.places = new Float64Array(bytes.buffer, 8 * F, F * n);
    this.size = n;
    this.frame = 0;
    this.end = exact.end;
  }

  /** To the end of the last step that has been made at the exact run's moment. */
  follow() {
    this.hi = this.exact.hi;
    this.lo = this.exact.lo;
    let low = 0, high = this.times.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.times[middle] <= this.hi) low = middle;
      else high = middle - 1;
    }
    this.frame = low;
  }

  alive() {
    return true;
  }
  radius(i) {
    return this.log.startRadius[i];
  }
  place(frame, i, k) {
    return this.wrapped(this.places[frame * this.size + i * this.log.dimension + k], k);
  }
  position(i, out = [0, 0, 0]) {
    for (let k = 0; k < this.log.dimension; ++k) out[k] = this.place(this.frame, i, k);
    return out;
  }
  velocity(i, out = [0, 0, 0]) {
    const a = Math.max(0, Math.min(this.frame, this.times.length - 2)), s = this.times[a + 1] - this.times[a];
    for (let k = 0; k < this.log.dimension; ++k) {
      const at = a * this.size + i * this.log.dimension + k;
      out[k] = s > 0 ? (this.places[at + this.size] - this.places[at]) / s : 0;
    }
    return out;
  }

  trail(i, span, most, visit) {
    const end = this.times[this.frame], D = this.log.dimension;
    for (let f = this.frame; f > 0 && this.frame - f < Math.max(most, 400); --f) {
      const a = [0, 0, 0], b = [0, 0, 0];
      let jump = false;
      for (let k = 0; k < D; ++k) {
        a[k] = this.place(f, i, k);
        b[k] = this.place(f - 1, i, k);
        jump ||= this.period[k] > 0 && Math.abs(a[k] - b[k]) > this.period[k] / 2;
      }
      const age = (t) => (end - t) / span;
      if (age(this.times[f]) >= 1) return;
      if (!jump) visit(a, b, age(this.times[f]), Math.min(1, age(this.times[f - 1])));
    }
  }

  /** How many exact collisions up to now have no answer in the stepped run. */
  missedSoFar(event) {
    const list = this.head.missed;
    let low = 0, high = list.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (list[middle] < event) low = middle + 1;
      else high = middle;
    }
    return low;
  }
}
