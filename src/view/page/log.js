// The event log: columns that grow as chunks come in (include/carom/write/replay_log.hpp says what is in a chunk).

const MAGIC = 0x4c505243;
const WITH_ACCELERATION = 1, WITH_SIZE = 2;
export const KIND = {balls: 0, wall: 1, other: 2};

/** Base64 to bytes; white space around it is ignored. */
export function bytesOf(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  text = text.trim();
  const length = (text.length / 4) * 3 - (text.endsWith('==') ? 2 : text.endsWith('=') ? 1 : 0);
  const bytes = new Uint8Array(length);
  let at = 0;
  for (let k = 0; k < text.length; k += 4) {
    const word = (DIGITS[text.charCodeAt(k)] << 18) | (DIGITS[text.charCodeAt(k + 1)] << 12) |
      (DIGITS[text.charCodeAt(k + 2)] << 6) | DIGITS[text.charCodeAt(k + 3)];
    bytes[at++] = word >> 16;
    bytes[at++] = word >> 8;
    bytes[at++] = word;
  }
  return bytes;
}

const DIGITS = new Uint8Array(128);
'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/'.split('').forEach((c, k) => (DIGITS[c.charCodeAt(0)] = k));

const EVENT_COLUMNS = {
  time: Float64Array, impulse: Float64Array, timeLow: Float32Array, gap: Float32Array, energy: Float32Array,
  dissipated: Float32Array, balance: Float32Array, ball: Uint32Array, partner: Uint32Array, feature: Int32Array,
  changesEnd: Uint32Array, kind: Uint8Array, tie: Uint8Array,
};
const CHANGE_COLUMNS = {changeBall: Uint32Array, changeEvent: Uint32Array, previous: Int32Array};

export class Log {
  /** `balls` in `dimension` dimensions, at `start` as replay_start gives them. */
  constructor(dimension, balls, start) {
    const D = dimension, N = balls;
    this.dimension = D;
    this.balls = N;
    const doubles = new Float64Array(start.buffer, start.byteOffset, N * (2 * D + 3));
    this.startPosition = doubles.subarray(0, N * D);
    this.startVelocity = doubles.subarray(N * D, 2 * N * D);
    this.startRadius = doubles.subarray(2 * N * D, 2 * N * D + N);
    this.startMass = doubles.subarray(2 * N * D + N, 2 * N * D + 2 * N);
    this.fixed = doubles.subarray(2 * N * D + 2 * N);
    this.events = 0;
    this.changes = 0;
    this.capacity = {events: 0, changes: 0};
    this.last = new Int32Array(N).fill(-1);
    for (const [name, Type] of Object.entries({...EVENT_COLUMNS, ...CHANGE_COLUMNS})) this[name] = new Type(0);
    for (const name of ['normal', 'position', 'velocity']) this[name] = new Float64Array(0);
    this.acceleration = this.radius = this.mass = null;
  }

  /** Makes room for as many more. */
  reserve(events, changes) {
    const grow = (name, Type, length) => {
      const old = this[name];
      this[name] = new Type(length);
      if (old) this[name].set(old);
    };
    if (this.events + events > this.capacity.events) {
      const room = (this.capacity.events = Math.max(this.events + events, 2 * this.events));
      for (const [name, Type] of Object.entries(EVENT_COLUMNS)) grow(name, Type, room);
      grow('normal', Float32Array, room * this.dimension);
    }
    if (this.changes + changes > this.capacity.changes) {
      const room = (this.capacity.changes = Math.max(this.changes + changes, 2 * this.changes));
      for (const [name, Type] of Object.entries(CHANGE_COLUMNS)) grow(name, Type, room);
      for (const name of ['position', 'velocity']) grow(name, Float64Array, room * this.dimension);
      if (this.acceleration) grow('acceleration', Float64Array, room * this.dimension);
      if (this.radius) for (const name of ['radius', 'mass']) grow(name, Float64Array, room);
    }
  }

  append(chunk) {
    const head = new Uint32Array(chunk.buffer, chunk.byteOffset, 8);
    const [magic, D, E, C, flags] = head;
    if (magic !== MAGIC || D !== this.dimension) throw new Error('this is no chunk of the log');
    if (flags & WITH_ACCELERATION && !this.acceleration)
      this.acceleration = new Float64Array(this.capacity.changes * D);
    if (flags & WITH_SIZE && !this.radius) {
      this.radius = new Float64Array(this.capacity.changes);
      this.mass = new Float64Array(this.capacity.changes);
    }
    this.reserve(E, C);
    let at = chunk.byteOffset + head.byteLength;
    const take = (name, Type, length, to) => {
      this[name].set(new Type(chunk.buffer, at, length), to);
      at += length * Type.BYTES_PER_ELEMENT;
    };
    const e0 = this.events, c0 = this.changes;
    take('time', Float64Array, E, e0);
    take('impulse', Float64Array, E, e0);
    take('position', Float64Array, C * D, c0 * D);
    take('velocity', Float64Array, C * D, c0 * D);
    if (flags & WITH_ACCELERATION) take('acceleration', Float64Array, C * D, c0 * D);
    if (flags & WITH_SIZE) for (const name of ['radius', 'mass']) take(name, Float64Array, C, c0);
    for (const name of ['timeLow', 'gap', 'energy', 'dissipated', 'balance']) take(name, Float32Array, E, e0);
    take('normal', Float32Array, E * D, e0 * D);
    take('ball', Uint32Array, E, e0);
    take('partner', Uint32Array, E, e0);
    take('feature', Int32Array, E, e0);
    take('changesEnd', Uint32Array, E, e0);
    take('changeBall', Uint32Array, C, c0);
    take('kind', Uint8Array, E, e0);
    take('tie', Uint8Array, E, e0);
    this.link(e0, E, c0);
    this.events += E;
    this.changes += C;
  }

  /** Each change knows its event and the change of the same ball before it. */
  link(e0, E, c0) {
    let c = c0;
    for (let e = e0; e < e0 + E; ++e) {
      const end = (this.changesEnd[e] += c0);
      for (; c < end; ++c) {
        this.changeEvent[c] = e;
        this.previous[c] = this.last[this.changeBall[c]];
        this.last[this.changeBall[c]] = c;
      }
    }
  }

  changesBegin(event) {
    return event === 0 ? 0 : this.changesEnd[event - 1];
  }
}
