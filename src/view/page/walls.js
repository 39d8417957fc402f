// Walls on a canvas.

/** Where a wall that moves is now, from where the scene puts it. */
function drift(wall, replay) {
  const s = replay.hi - replay.start + replay.lo;
  return [0, 1, 2].map((k) => (wall.velocity?.[k] ?? 0) * s);
}

export function wallPaths(g, stage) {
  const {replay, colours, scale} = stage;
  g.strokeStyle = colours.page.wall;
  g.lineCap = 'round';
  g.lineJoin = 'round';
  for (const wall of replay.scene.walls) {
    const d = drift(wall, replay);
    const at = (x) => stage.toScreen([x[0] + d[0], (x[1] ?? 0) + d[1]]);
    g.lineWidth = 3;
    if (wall.kind === 'segment') polyline(g, [at(wall.from), at(wall.to)]);
    if (wall.kind === 'polygon') polygon(g, wall.vertices.map(at), colours.page);
    if (wall.kind === 'circle') circle(g, at(wall.centre), wall.radius * scale, wall.side, colours.page);
    if (wall.kind === 'plane') plane(g, stage, at(wall.point), wall.normal);
  }
}

function polyline(g, points) {
  g.beginPath();
  for (const p of points) g.lineTo(...p);
  g.stroke();
}

function polygon(g, points, page) {
  g.beginPath();
  for (const p of points) g.lineTo(...p);
  g.closePath();
  g.fillStyle = page.floor;
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
