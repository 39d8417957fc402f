// Walls on a canvas.

import {isClosed, outlinesOf, pointsOf, shiftsOf} from './wall_shapes.js';

/** Where a wall that moves or swings is now, from where the scene puts it. */
export function drift(wall, replay) {
  const s = replay.hi - replay.start + replay.lo, o = wall.oscillation;
  const swung = o ? Math.sin(o.omega * (replay.hi + replay.lo) + o.phase) : 0;
  return [0, 1, 2].map((k) => (wall.velocity?.[k] ?? 0) * s + (o ? (o.amplitude[k] ?? 0) * swung : 0));
}

export function wallPaths(g, stage) {
  const {scene} = stage.replay;
  g.save();
  if (scene.space.kind === 'periodic' && !stage.oneDimensional) clipToCell(g, stage, scene.space);
  g.lineCap = 'round';
  g.lineJoin = 'round';
  for (const points of outlinesOf(scene.walls)) floor(g, points.map((x) => stage.toScreen(x)), stage.colours.page);
  for (const wall of scene.walls)
    for (const shift of stage.oneDimensional ? [[0, 0]] : shiftsOf(wall, scene.space)) draw(g, stage, wall, shift);
  g.restore();
}

/** Where a ball's centre leaves, the line is dashed. */
function draw(g, stage, wall, shift) {
  const {colours: {page}, replay, scale} = stage;
  const d = drift(wall, replay);
  const at = (x) => stage.toScreen([x[0] + d[0] + shift[0], (x[1] ?? 0) + d[1] + shift[1]]);
  g.strokeStyle = page.wall;
  g.lineWidth = wall.opening ? 1.5 : 3;
  g.setLineDash(wall.opening ? [6, 6] : []);
  if (wall.kind === 'plane') return plane(g, stage, at(wall.point), wall.normal);
  if (wall.kind === 'circle' && !wall.opening) return circle(g, at(wall.centre), wall.radius * scale, wall.side, page);
  const points = pointsOf(wall).map(at);
  if (!isClosed(wall) || wall.opening) return polyline(g, points);
  g.fillStyle = wall.side === 'outside' ? page.line : page.floor;
  polygon(g, points);
}

function clipToCell(g, stage, {lower, upper}) {
  const [x0, y1] = stage.toScreen(lower), [x1, y0] = stage.toScreen(upper);
  g.beginPath();
  g.rect(x0, y0, x1 - x0, y1 - y0);
  g.clip();
}

function floor(g, points, page) {
  g.beginPath();
  for (const p of points) g.lineTo(...p);
  g.fillStyle = page.floor;
  g.fill();
}

function polyline(g, points) {
  g.beginPath();
  for (const p of points) g.lineTo(...p);
  g.stroke();
}

function polygon(g, points) {
  g.beginPath();
  for (const p of points) g.lineTo(...p);
  g.closePath();
  g.fill();
  g.stroke();
}

/** The line of a circle lies on the side where no balls are. */
function circle(g, [x, y], r, side, page) {
  if (!(r < 1e6)) return;
  const inside = side === 'inside';
  g.beginPath();
  g.arc(x, y, Math.max(0.5, inside ? r + 1.5 : r - 1.5), 0, 2 * Math.PI);
  g.fillStyle = inside ? page.floor : page.line;
  g.fill();
  g.stroke();
}

/** The half-space behind a plane is shaded. */
function plane(g, stage, [x, y], normal) {
  const length = Math.hypot(normal[0], normal[1] ?? 0) || 1;
  const nx = normal[0] / length, ny = -(normal[1] ?? 0) / length; // on the canvas, towards the balls
  const far = 2 * (stage.width + stage.height) + Math.hypot(x - stage.width / 2, y - stage.height / 2);
  const a = [x - ny * far, y + nx * far], b = [x + ny * far, y - nx * far];
  g.fillStyle = stage.colours.page.line;
  g.globalAlpha = 0.5;
  g.beginPath();
  g.moveTo(...a);
  g.lineTo(...b);
  g.lineTo(b[0] - nx * far, b[1] - ny * far);
  g.lineTo(a[0] - nx * far, a[1] - ny * far);
  g.fill();
  g.globalAlpha = 1;
  const out = 1.5;
  polyline(g, [[a[0] - nx * out, a[1] - ny * out], [b[0] - nx * out, b[1] - ny * out]]);
}
