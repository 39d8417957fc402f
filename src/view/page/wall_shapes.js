// Walls of two dimensions as paths: straight pieces, and curves in steps too short to see.

const STEPS = 360; // of a whole turn, or of a curve from end to end

const steps = (n, f) => Array.from({length: n + 1}, (_, k) => f(k / n));
const turn = ([x, y], angle, [cx, cy]) => [cx + Math.cos(angle) * x - Math.sin(angle) * y, cy + Math.sin(angle) * x + Math.cos(angle) * y];

const series = (wall, t) =>
  wall.cosines.reduce((r, a, k) => r + a * Math.cos(k * t), 0) + (wall.sines ?? []).reduce((r, b, k) => r + b * Math.sin(k * t), 0);

/** The points of a wall from its beginning to its end; of a closed one the first comes last again. None of a plane. */
export function pointsOf(wall) {
  const centre = wall.centre, angle = wall.angle ?? 0, whole = 2 * Math.PI;
  switch (wall.kind) {
    case 'segment':
      return [wall.from, wall.to];
    case 'polygon':
      return [...wall.vertices, wall.vertices[0]];
    case 'circle':
      return steps(STEPS, (u) => [centre[0] + wall.radius * Math.cos(whole * u), centre[1] + wall.radius * Math.sin(whole * u)]);
    case 'arc': {
      let span = wall.to_angle - wall.from_angle;
      if (!(span > 0)) span += whole;
      return steps(Math.ceil((STEPS * span) / whole), (u) => {
        const a = wall.from_angle + u * span;
        return [centre[0] + wall.radius * Math.cos(a), centre[1] + wall.radius * Math.sin(a)];
      });
    }
    case 'ellipse':
      return steps(STEPS, (u) => turn([wall.axes[0] * Math.cos(whole * u), wall.axes[1] * Math.sin(whole * u)], angle, centre));
    case 'parabola':
      return steps(STEPS, (u) => {
        const y = (2 * u - 1) * wall.half_width;
        return turn([(y * y) / (4 * wall.focal_length), y], angle, centre);
      });
    case 'curve':
      return steps(2 * STEPS, (u) => {
        const t = whole * u, r = series(wall, t);
        return turn([r * Math.cos(t), r * Math.sin(t)], angle, centre);
      });
    default:
      return [];
  }
}

export const isClosed = (wall) => ['polygon', 'circle', 'ellipse', 'curve'].includes(wall.kind);

const same = (a, b) => a[0] === b[0] && a[1] === b[1];

/** The closed outlines that the pieces of each table make: [points]. Pieces follow each other; their ends are the same numbers. */
export function outlinesOf(walls) {
  const outlines = [];
  let chain = [], table = -1;
  for (const wall of walls) {
    if ((wall.table ?? -1) < 0 || !['segment', 'arc'].includes(wall.kind)) continue;
    const points = pointsOf(wall);
    if (wall.from) [points[0], points[points.length - 1]] = [wall.from, wall.to];
    if (wall.table !== table || !chain.length || !same(chain[chain.length - 1], points[0])) chain = [];
    table = wall.table;
    chain = [...chain, ...(chain.length ? points.slice(1) : points)];
    if (chain.length > 2 && same(chain[0], chain[chain.length - 1])) {
      outlines.push(chain);
      chain = [];
    }
  }
  return outlines;
}

/** The shifts by whole periods that bring a wall into the cell. */
export function shiftsOf(wall, space) {
  if (space.kind !== 'periodic') return [[0, 0]];
  const points = pointsOf(wall), list = [];
  const range = [0, 1].map((k) => {
    const edge = space.upper[k] - space.lower[k], x = points.map((p) => p[k]);
    return [Math.ceil((space.lower[k] - Math.max(...x)) / edge), Math.floor((space.upper[k] - Math.min(...x)) / edge), edge];
  });
  for (let i = range[0][0]; i <= range[0][1]; ++i)
    for (let j = range[1][0]; j <= range[1][1]; ++j) list.push([i * range[0][2], j * range[1][2]]);
  return list;
}
