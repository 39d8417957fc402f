// The stage of one and two dimensions: a canvas. In one dimension the balls lie on a line, over their paths in space and time.

import {KIND} from './log.js';
import {speedColours} from './colours.js';
import {extentOf} from './extent.js';
import {wallPaths} from './walls.js';

const BIG = 20000; // [px] radius from which a circle is drawn as the piece that is seen: canvases count in single precision
const LINE_AT = 0.2; // 1-D: height of the line from the top

export class FlatStage {
  constructor(canvas, replay, colours, options) {
    Object.assign(this, {canvas, replay, colours, options});
    this.context = canvas.getContext('2d');
    this.oneDimensional = replay.log.dimension === 1;
    this.extent = extentOf(replay);
    this.centre = [0, 0];
    this.scale = 1;
    this.fitted = true;
    this.resize();
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.listen();
  }

  resize() {
    const ratio = window.devicePixelRatio || 1;
    const {clientWidth: w, clientHeight: h} = this.canvas;
    if (w === 0 || h === 0) return;
    this.width = w;
    this.height = h;
    this.ratio = ratio;
    this.canvas.width = Math.round(w * ratio);
    this.canvas.height = Math.round(h * ratio);
    if (this.fitted) this.fit();
    this.options.changed();
  }

  fit() {
    const {lower, upper} = this.extent;
    const margin = Math.min(40, 0.06 * this.width + 8), top = innerWidth > 860 ? 64 : margin; // below the clock
    const w = upper[0] - lower[0], h = this.oneDimensional ? 0 : upper[1] - lower[1];
    this.scale = Math.min((this.width - 2 * margin) / w, h > 0 ? (this.height - margin - top) / h : Infinity);
    if (this.oneDimensional) this.scale = Math.min(this.scale, (0.3 * this.height) / Math.max(2 * this.largestRadius(), w / 1e6));
    this.centre = [(lower[0] + upper[0]) / 2, this.oneDimensional ? 0 : (lower[1] + upper[1]) / 2 + (top - margin) / 2 / this.scale];
    this.fitted = true;
    this.options.changed();
  }

  largestRadius() {
    return this.replay.log.startRadius.reduce((a, b) => Math.max(a, b), 0);
  }

  /** Where a place of the scene is on the canvas, in CSS pixels. */
  toScreen(x) {
    const middle = this.oneDimensional ? LINE_AT * this.height : this.height / 2;
    return [this.width / 2 + (x[0] - this.centre[0]) * this.scale, middle - ((this.oneDimensional ? 0 : x[1]) - this.centre[1]) * this.scale];
  }
  toScene([sx, sy]) {
    return [this.centre[0] + (sx - this.width / 2) / this.scale, this.centre[1] - (sy - this.height / 2) / this.scale];
  }
  pixelsPerLength() {
    return this.scale;
  }

  zoom(factor, at = [this.width / 2, this.height / 2]) {
    const before = this.toScene(at);
    this.scale *= factor;
    const after = this.toScene(at);
    this.centre[0] += before[0] - after[0];
    if (!this.oneDimensional) this.centre[1] += before[1] - after[1];
    this.fitted = false;
    this.options.changed();
  }

  /** The ball at a place of the canvas, or -1. */
  ballAt(place) {
    const x = [0, 0, 0];
    let best = -1, least = 14;
    for (let i = 0; i < this.replay.log.balls; ++i) {
      if (!this.replay.alive(i)) continue;
      const [sx, sy] = this.toScreen(this.replay.position(i, x));
      const d = Math.hypot(sx - place[0], sy - place[1]) - this.replay.radius(i) * this.scale;
      if (d < least) [best, least] = [i, d];
    }
    return best;
  }

  listen() {
    const {canvas} = this, fingers = new Map();
    let moved = 0;
    const place = (event) => {
      const box = canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      fingers.set(event.pointerId, place(event));
      if (fingers.size === 1) moved = 0;
    });
    canvas.addEventListener('pointermove', (event) => {
      if (!fingers.has(event.pointerId)) return;
      const before = [...fingers.values()], old = fingers.get(event.pointerId), now = place(event);
      fingers.set(event.pointerId, now);
      moved += Math.hypot(now[0] - old[0], now[1] - old[1]);
      if (moved < 5) return;
      if (fingers.size === 2) {
        const after = [...fingers.values()], span = ([a, b]) => Math.hypot(a[0] - b[0], a[1] - b[1]);
        this.zoom(span(after) / Math.max(1, span(before)), [(after[0][0] + after[1][0]) / 2, (after[0][1] + after[1][1]) / 2]);
      }
      const share = 1 / fingers.size;
      this.centre[0] -= ((now[0] - old[0]) * share) / this.scale;
      if (!this.oneDimensional) this.centre[1] += ((now[1] - old[1]) * share) / this.scale;
      this.fitted = false;
      if (this.options.following >= 0 && fingers.size === 1) this.options.follow(-1);
      this.options.changed();
    });
    const up = (event) => {
      if (fingers.delete(event.pointerId) && fingers.size === 0 && moved < 5 && event.type === 'pointerup')
        this.options.follow(this.ballAt(place(event)));
    };
    canvas.addEventListener('pointerup', up);
    canvas.addEventListener('pointercancel', up);
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY * (event.ctrlKey ? 0.01 : 0.0015)), place(event));
    }, {passive: false});
    canvas.addEventListener('dblclick', () => this.fit());
  }

  /** `marks`: contacts to show, with their strength 0..1. */
  draw(marks) {
    if (!this.width) return;
    const {context: g, replay, options, colours} = this;
    if (options.following >= 0 && replay.alive(options.following)) {
      const x = replay.position(options.following);
      this.centre = [x[0], this.oneDimensional ? 0 : x[1]];
    }
    g.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    g.fillStyle = colours.page.stage;
    g.fillRect(0, 0, this.width, this.height);
    this.drawSpace(g);
    if (this.oneDimensional) this.drawPaths(g);
    if (options.trails && !this.oneDimensional) this.drawTrails(g);
    if (options.images && replay.scene.space.kind === 'periodic') this.drawImages(g);
    this.drawBalls(g);
    if (options.arrows) this.drawArrows(g);
    for (const mark of marks) this.drawContact(g, mark);
    if (options.following >= 0) this.ring(g, options.following);
    this.drawScale(g);
  }

  drawSpace(g) {
    const {scene} = this.replay, {page} = this.colours;
    if (scene.space.kind !== 'open') {
      const [x0, y1] = this.toScreen(scene.space.lower), [x1, y0] = this.toScreen(scene.space.upper);
      const top = this.oneDimensional ? LINE_AT * this.height - Math.max(30, this.largestRadius() * this.scale + 12) : y0, bottom = this.oneDimensional ? this.height : y1;
      g.fillStyle = page.floor;
      g.fillRect(x0, top, x1 - x0, bottom - top);
      g.strokeStyle = page.wall;
      const periodic = scene.space.kind === 'periodic';
      g.lineWidth = periodic ? 1 : 5;
      g.setLineDash(periodic ? [5, 5] : []);
      const out = periodic ? 0 : 2.5;
      if (this.oneDimensional) {
        for (const x of [x0 - out, x1 + out]) {
          g.beginPath();
          g.moveTo(x, top);
          g.lineTo(x, bottom);
          g.stroke();
        }
      } else {
        g.strokeRect(x0 - out, y0 - out, x1 - x0 + 2 * out, y1 - y0 + 2 * out);
      }
      g.setLineDash([]);
    }
    wallPaths(g, this);
    if (this.oneDimensional) {
      g.strokeStyle = page.line;
      g.lineWidth = 1;
      g.beginPath();
      g.moveTo(0, LINE_AT * this.height);
      g.lineTo(this.width, LINE_AT * this.height);
      g.stroke();
    }
  }

  /** 1-D: position to the right, time downwards into the past. */
  drawPaths(g) {
    const {replay, colours} = this, top = LINE_AT * this.height;
    const span = this.options.trailSpan * 4, height = this.height - top - 20;
    g.lineWidth = 1.5;
    for (let i = 0; i < replay.log.balls; ++i) {
      if (!replay.alive(i)) continue;
      g.strokeStyle = this.pathColour(i);
      g.beginPath();
      replay.trail(i, span, 400, (a, b, ageA, ageB) => {
        g.moveTo(this.toScreen(a)[0], top + ageA * height);
        g.lineTo(this.toScreen(b)[0], top + ageB * height);
      });
      g.stroke();
    }
    g.fillStyle = colours.page.muted;
    g.font = '12px system-ui, sans-serif';
    g.textAlign = 'left';
    g.fillText('paths in the last ' + this.options.shortNumber(span) + ' of time, downwards', 12, this.height - 10);
  }

  pathColour(i) {
    return this.colours.mode === 'number' && this.replay.scene.names[i] === 'cue' ? this.colours.page.muted : this.colours.of(i);
  }

  drawTrails(g) {
    const {replay, options} = this;
    const only = options.following >= 0 || replay.log.balls > 400;
    const list = only ? (options.following >= 0 ? [options.following] : []) : Array.from({length: replay.log.balls}, (_, i) => i);
    g.lineWidth = 1.6;
    g.lineCap = 'round';
    for (const i of list) {
      if (!replay.alive(i)) continue;
      g.strokeStyle = this.pathColour(i);
      replay.trail(i, options.trailSpan, only ? 2000 : 60, (a, b, age) => {
        const [ax, ay] = this.toScreen(a), [bx, by] = this.toScreen(b);
        g.globalAlpha = 0.75 * (1 - age);
        g.beginPath();
        g.moveTo(ax, ay);
        g.lineTo(bx, by);
        g.stroke();
      });
    }
    g.globalAlpha = 1;
  }

  /** Calls f(sx, sy, r, i) for the balls on the canvas, shifted by whole periods. */
  eachBall(shift, f) {
    const {replay} = this, x = [0, 0, 0];
    for (let i = 0; i < replay.log.balls; ++i) {
      if (!replay.alive(i)) continue;
      replay.position(i, x);
      x[0] += shift[0];
      x[1] += shift[1];
      const [sx, sy] = this.toScreen(x), r = Math.max(replay.radius(i) * this.scale, 1.6);
      if (sx + r > 0 && sx - r < this.width && sy + r > 0 && sy - r < this.height) f(sx, sy, r, i);
    }
  }

  drawBalls(g, shift = [0, 0]) {
    const {colours, replay} = this;
    const many = replay.log.balls > 300;
    if (!many) {
      this.eachBall(shift, (sx, sy, r, i) => this.drawBall(g, sx, sy, r, i));
      return;
    }
    const groups = new Map();
    this.eachBall(shift, (sx, sy, r, i) => {
      const colour = colours.mode === 'speed' ? speedColours[colours.level(i)] : colours.of(i);
      let path = groups.get(colour);
      if (!path) groups.set(colour, (path = new Path2D()));
      path.moveTo(sx + r, sy);
      path.arc(sx, sy, r, 0, 2 * Math.PI);
    });
    const edge = this.largestRadius() * this.scale > 4;
    for (const [colour, path] of groups) {
      g.fillStyle = colour;
      g.fill(path);
      if (edge) {
        g.strokeStyle = colours.page.edge;
        g.lineWidth = 0.6;
        g.stroke(path);
      }
    }
  }

  /** The outline lies inside the radius, so that balls in contact are seen to touch. */
  drawBall(g, sx, sy, r, i) {
    const colour = this.colours.of(i), line = Math.min(1.2, 0.15 * r);
    g.fillStyle = colour;
    g.strokeStyle = this.colours.page.edge;
    g.lineWidth = line;
    if (r > BIG) return this.bigCircle(g, i);
    g.beginPath();
    g.arc(sx, sy, Math.max(r - line / 2, 0.5), 0, 2 * Math.PI);
    g.fill();
    g.stroke();
    if (r > 6 && r < 600) {
      const light = g.createRadialGradient(sx - 0.35 * r, sy - 0.4 * r, 0.1 * r, sx, sy, r);
      light.addColorStop(0, 'rgba(255,255,255,.38)');
      light.addColorStop(0.5, 'rgba(255,255,255,0)');
      light.addColorStop(1, 'rgba(0,0,0,.16)');
      g.fillStyle = light;
      g.fill();
    }
    if (r > 11 && this.replay.log.balls <= 100) {
      g.fillStyle = this.replay.scene.names[i] === 'cue' && this.colours.mode === 'number' ? '#222' : '#fff';
      g.font = `600 ${Math.min(14, Math.round(r * 0.9))}px system-ui, sans-serif`;
      g.textAlign = 'center';
      g.textBaseline = 'middle';
      g.fillText(String(i), sx, sy + 0.5);
      g.textBaseline = 'alphabetic';
    }
  }

  /** The piece of a huge circle that is seen, from the point of it nearest to the middle of the canvas. */
  bigCircle(g, i) {
    const x = this.replay.position(i), r = this.replay.radius(i);
    const dx = this.centre[0] - x[0], dy = this.oneDimensional ? 0 : this.centre[1] - x[1], d = Math.hypot(dx, dy) || 1;
    const ux = dx / d, uy = dy / d, across = Math.hypot(this.width, this.height);
    const reach = Math.min(Math.PI, across / (r * this.scale)), middle = this.toScreen(this.centre);
    g.beginPath();
    const steps = 48, inside = (r - d) * this.scale;
    for (let n = -steps; n <= steps; ++n) {
      const t = (reach * n) / steps, half = Math.sin(t / 2);
      const along = r * this.scale * Math.sin(t), towards = inside - r * this.scale * 2 * half * half;
      g.lineTo(middle[0] + ux * towards - uy * along, middle[1] - (uy * towards + ux * along));
    }
    g.lineTo(middle[0] - ux * 2 * across - uy * across, middle[1] + uy * 2 * across - ux * across);
    g.lineTo(middle[0] - ux * 2 * across + uy * across, middle[1] + uy * 2 * across + ux * across);
    g.closePath();
    g.fill();
    g.lineWidth = 1;
    g.stroke();
  }

  drawImages(g) {
    const {period, log} = this.replay;
    g.globalAlpha = 0.35;
    const many = log.dimension === 1 ? [0] : [-1, 0, 1];
    for (const nx of [-1, 0, 1])
      for (const ny of many) if (nx !== 0 || ny !== 0) this.drawBalls(g, [nx * period[0], ny * period[1]]);
    g.globalAlpha = 1;
  }

  drawArrows(g) {
    const v = [0, 0, 0], unit = this.arrowUnit();
    g.strokeStyle = g.fillStyle = this.colours.page.ink;
    g.lineWidth = 1.5;
    this.eachBall([0, 0], (sx, sy, r, i) => {
      this.replay.velocity(i, v);
      arrow(g, sx, sy, sx + v[0] * unit, sy - (this.oneDimensional ? 0 : v[1]) * unit);
    });
  }
  /** Pixels for a unit of velocity: a fast ball's arrow is a tenth of the stage. */
  arrowUnit() {
    return (0.09 * Math.min(this.width, 2 * this.height)) / this.colours.fast;
  }

  drawContact(g, {contact, strength, text}) {
    const {page} = this.colours, [px, py] = this.toScreen(contact.point);
    if (px < -50 || py < -50 || px > this.width + 50 || py > this.height + 50 || contact.kind === KIND.other) return;
    const nx = contact.normal[0], ny = -(this.oneDimensional ? 0 : contact.normal[1]);
    g.globalAlpha = strength;
    g.strokeStyle = page.muted;
    g.lineWidth = 1;
    g.setLineDash([4, 4]);
    g.beginPath();
    g.moveTo(px - 60 * nx, py - 60 * ny);
    g.lineTo(px + 60 * nx, py + 60 * ny);
    g.stroke();
    g.setLineDash([]);
    g.strokeStyle = g.fillStyle = page.impulse;
    g.lineWidth = 2.5;
    const length = Math.min(1, 0.4 + this.width / 1200) * (16 + 44 * Math.min(1, Math.sqrt(contact.impulse / this.options.largestImpulse)));
    if (contact.impulse > 0) {
      arrow(g, px, py, px + length * nx, py + length * ny);
      if (contact.kind === KIND.balls) arrow(g, px, py, px - length * nx, py - length * ny);
    }
    g.beginPath();
    g.arc(px, py, 3, 0, 2 * Math.PI);
    g.fill();
    if (text) {
      g.font = '600 12px system-ui, sans-serif';
      g.textAlign = 'left';
      const w = g.measureText(text).width + 14, x = Math.max(6, Math.min(this.width - w - 6, px + 14)), y = Math.max(24, py - 18);
      g.fillStyle = page.paper;
      g.globalAlpha = 0.92 * strength;
      g.beginPath();
      g.roundRect(x - 7, y - 15, w, 22, 6);
      g.fill();
      g.globalAlpha = strength;
      g.fillStyle = page.impulse;
      g.fillText(text, x, y);
    }
    g.globalAlpha = 1;
  }

  ring(g, i) {
    if (!this.replay.alive(i)) return;
    const [sx, sy] = this.toScreen(this.replay.position(i)), r = this.replay.radius(i) * this.scale;
    g.strokeStyle = this.colours.page.accent;
    g.lineWidth = 2;
    g.beginPath();
    g.arc(sx, sy, Math.min(r + 5, BIG), 0, 2 * Math.PI);
    g.stroke();
  }

  /** A bar of a round length. */
  drawScale(g) {
    const wanted = 110 / this.scale, power = 10 ** Math.floor(Math.log10(wanted));
    const length = power * (wanted / power >= 5 ? 5 : wanted / power >= 2 ? 2 : 1);
    const w = length * this.scale, x = this.width - w - 14, y = this.height - 12;
    g.strokeStyle = g.fillStyle = this.colours.page.muted;
    g.lineWidth = 1;
    g.beginPath();
    g.moveTo(x, y - 4);
    g.lineTo(x, y);
    g.lineTo(x + w, y);
    g.lineTo(x + w, y - 4);
    g.stroke();
    g.font = '11px system-ui, sans-serif';
    g.textAlign = 'right';
    g.fillText(this.options.shortNumber(length), x + w, y - 7);
  }
}

export function arrow(g, x0, y0, x1, y1) {
  const length = Math.hypot(x1 - x0, y1 - y0);
  if (!(length > 1)) return;
  const ux = (x1 - x0) / length, uy = (y1 - y0) / length, head = Math.min(7, 0.5 * length);
  g.beginPath();
  g.moveTo(x0, y0);
  g.lineTo(x1 - 0.6 * head * ux, y1 - 0.6 * head * uy);
  g.stroke();
  g.beginPath();
  g.moveTo(x1, y1);
  g.lineTo(x1 - head * ux - 0.5 * head * uy, y1 - head * uy + 0.5 * head * ux);
  g.lineTo(x1 - head * ux + 0.5 * head * uy, y1 - head * uy - 0.5 * head * ux);
  g.fill();
}
