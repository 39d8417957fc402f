// Colours of balls, and those of the page that canvases need.

const BY_NUMBER = ['#e4572e', '#2e86ab', '#f2b134', '#5c9e5f', '#8e5ea2', '#d9709c', '#3aa6a0', '#b5651d', '#6b7fd7', '#a3b440', '#c0392b', '#1f6f8b', '#e39b2d', '#3f7f52', '#6f4a8e', '#b1487a'];
const CUE = '#fbf7ea';
const MAP = ['#2f3e8f', '#2f6fb0', '#2a9d9a', '#58b368', '#b4c440', '#f2b53c', '#ee7b30', '#d7372f']; // slow to fast
export const LEVELS = 64;

function mix(a, b, share) {
  const part = (hex, k) => parseInt(hex.slice(1 + 2 * k, 3 + 2 * k), 16);
  return '#' + [0, 1, 2].map((k) => Math.round(part(a, k) + (part(b, k) - part(a, k)) * share).toString(16).padStart(2, '0')).join('');
}

/** Slow to fast, in LEVELS steps. */
export const speedColours = Array.from({length: LEVELS}, (_, k) => {
  const x = (k / (LEVELS - 1)) * (MAP.length - 1), n = Math.min(MAP.length - 2, Math.floor(x));
  return mix(MAP[n], MAP[n + 1], x - n);
});

export class Colours {
  /** mode: 'number' | 'size' | 'speed' */
  constructor(replay) {
    this.replay = replay;
    const {log} = replay;
    const kinds = new Map();
    this.kind = new Uint16Array(log.balls);
    for (let i = 0; i < log.balls; ++i) {
      const key = log.startRadius[i] + ' ' + log.startMass[i];
      if (!kinds.has(key)) kinds.set(key, kinds.size);
      this.kind[i] = kinds.get(key);
    }
    this.kinds = kinds.size;
    this.mode = log.balls <= 40 ? 'number' : this.kinds > 1 && this.kinds <= BY_NUMBER.length ? 'size' : 'speed';
    this.measure();
    this.refresh();
  }

  /** The speed from which a ball has the last colour. */
  measure() {
    const {log} = this.replay;
    const square = log.startVelocity.reduce((sum, v) => sum + v * v, 0);
    this.fast = 2.2 * Math.sqrt(square / Math.max(1, log.balls)) || 1;
    const fastest = this.fastestChange();
    if (fastest > 0 && (this.fast > fastest || this.fast === 1)) this.fast = fastest;
  }

  fastestChange() {
    const {log} = this.replay, D = log.dimension;
    let most = 0;
    for (let c = 0; c < Math.min(log.changes, 20000); ++c) {
      let v = 0;
      for (let k = 0; k < D; ++k) v += log.velocity[c * D + k] ** 2;
      if (v > most) most = v;
    }
    return Math.sqrt(most);
  }

  /** Looks up the page's own colours; after a change of theme. */
  refresh() {
    const style = getComputedStyle(document.documentElement);
    const read = (name) => style.getPropertyValue('--' + name).trim();
    this.page = {ink: read('ink'), muted: read('muted'), line: read('line'), accent: read('accent'), stage: read('stage'),
      floor: read('floor'), wall: read('wall'), edge: read('ball-edge'), impulse: read('impulse'), missed: read('missed'), paper: read('paper')};
  }

  level(i) {
    return Math.min(LEVELS - 1, Math.floor((this.replay.speed(i) / this.fast) * LEVELS));
  }

  of(i) {
    if (this.mode === 'speed') return speedColours[this.level(i)];
    if (this.mode === 'size') return BY_NUMBER[this.kind[i] % BY_NUMBER.length];
    return this.replay.scene.names[i] === 'cue' ? CUE : BY_NUMBER[i % BY_NUMBER.length];
  }
}
