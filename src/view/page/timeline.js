// The strip under the stage: how many collisions when, and where in time we are.

export class Timeline {
  constructor(canvas, replay, colours, seek) {
    Object.assign(this, {canvas, replay, colours, seek});
    let down = false;
    const go = (event) => {
      const box = canvas.getBoundingClientRect();
      const share = Math.max(0, Math.min(1, (event.clientX - box.left) / box.width));
      seek(replay.start + share * (replay.end - replay.start));
    };
    canvas.addEventListener('pointerdown', (event) => {
      down = true;
      canvas.setPointerCapture(event.pointerId);
      go(event);
    });
    canvas.addEventListener('pointermove', (event) => down && go(event));
    for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, () => (down = false));
    new ResizeObserver(() => this.measure()).observe(canvas);
    this.measure();
  }

  /** Counts the collisions in each column of pixels. */
  measure() {
    const {canvas, replay} = this, {log} = replay, ratio = window.devicePixelRatio || 1;
    this.width = canvas.clientWidth || 1;
    this.height = canvas.clientHeight || 1;
    canvas.width = Math.round(this.width * ratio);
    canvas.height = Math.round(this.height * ratio);
    this.ratio = ratio;
    const columns = Math.max(1, Math.floor(this.width / 3));
    this.counts = new Float64Array(columns);
    const scale = columns / (replay.end - replay.start || 1);
    for (let e = 0; e < log.events; ++e) ++this.counts[Math.min(columns - 1, Math.max(0, Math.floor((log.time[e] - replay.start) * scale)))];
    this.most = this.counts.reduce((a, b) => Math.max(a, b), 1);
    this.draw();
  }

  draw() {
    const {canvas, replay, colours, counts} = this, g = canvas.getContext('2d');
    g.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    g.clearRect(0, 0, this.width, this.height);
    const share = (replay.hi - replay.start) / (replay.end - replay.start || 1), x = share * this.width;
    const w = this.width / counts.length, tall = this.height - 8;
    for (let b = 0; b < counts.length; ++b) {
      const h = counts[b] > 0 ? Math.max(4, tall * Math.sqrt(counts[b] / this.most)) : 1;
      g.fillStyle = b * w < x ? colours.page.accent : colours.page.line;
      g.fillRect(b * w, this.height - h, Math.max(1, w - 1), h);
    }
    g.fillStyle = colours.page.ink;
    g.fillRect(Math.min(this.width - 2, Math.max(0, x - 1)), 0, 2, this.height);
    g.beginPath();
    g.arc(Math.min(this.width - 5, Math.max(5, x)), 5, 5, 0, 2 * Math.PI);
    g.fill();
  }
}
