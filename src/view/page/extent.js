// What part of the scene a stage shows at first.

import {pointsOf} from './wall_shapes.js';

/** The smallest upright box that holds the space, the walls and, in open space, where the balls go. */
export function extentOf(replay) {
  const {log, scene} = replay, D = log.dimension;
  const lower = [Infinity, Infinity, Infinity], upper = [-Infinity, -Infinity, -Infinity];
  const hold = (x, r = 0) => {
    for (let k = 0; k < D; ++k) {
      lower[k] = Math.min(lower[k], x[k] - r);
      upper[k] = Math.max(upper[k], x[k] + r);
    }
  };
  if (scene.space.kind !== 'open') {
    hold(scene.space.lower);
    hold(scene.space.upper);
  } else {
    let closed = false;
    for (const wall of scene.walls) {
      if (wall.kind === 'circle') hold(wall.centre, wall.radius);
      else if (D === 2) pointsOf(wall).forEach((x) => hold(x));
      closed ||= wall.table >= 0 || (wall.kind !== 'plane' && wall.side === 'inside') || wall.kind === 'polygon';
    }
    for (let i = 0; i < log.balls; ++i) hold(log.startPosition.subarray(i * D, i * D + D), log.startRadius[i]);
    if (!closed) holdPaths(replay, hold, lower, upper);
    for (const wall of scene.walls)
      if (wall.kind === 'plane' && distance(lower, upper, wall.point, D)) hold(wall.point);
  }
  for (let k = 0; k < 3; ++k) if (!(upper[k] > lower[k])) [lower[k], upper[k]] = [(lower[k] || 0) - 0.5, (upper[k] || 0) + 0.5];
  for (let k = D; k < 3; ++k) [lower[k], upper[k]] = [0, 0];
  return {lower, upper};
}

/** Collisions far from where the balls start (beyond the nearest nine tenths) do not make the stage larger. */
function holdPaths(replay, hold, lower, upper) {
  const {log} = replay, D = log.dimension;
  const many = Math.min(log.changes, 4000), places = [];
  for (let n = 0; n < many; ++n) {
    const c = Math.floor((n * log.changes) / many);
    places.push(Array.from(log.position.subarray(c * D, c * D + D)));
  }
  const size = Math.max(1e-300, ...[0, 1, 2].slice(0, D).map((k) => upper[k] - lower[k]));
  const r = log.startRadius[0] ?? 0;
  const middle = [0, 1, 2].slice(0, D).map((k) => (upper[k] + lower[k]) / 2);
  const away = (x) => Math.max(...x.map((v, k) => Math.abs(v - middle[k])));
  places.sort((a, b) => away(a) - away(b));
  const near = away(places[Math.floor(places.length * 0.9)] ?? middle);
  for (const x of places) if (away(x) <= Math.max(3 * size, 1.5 * near)) hold(x, r);
  // A little of what comes after the last collision.
  const x = [0, 0, 0];
  const kept = {event: replay.event, hi: replay.hi, lo: replay.lo};
  if (log.balls <= 1000) {
    replay.seek(replay.end ?? replay.start);
    for (let i = 0; i < log.balls; ++i) {
      replay.position(i, x);
      if (replay.alive(i) && away(x.slice(0, D)) <= 2.5 * size) hold(x, log.startRadius[i]);
    }
    replay.seek(kept.hi, kept.lo);
  }
}

function distance(lower, upper, point, D) {
  const size = Math.max(...[0, 1, 2].slice(0, D).map((k) => upper[k] - lower[k])) || 1;
  return [0, 1, 2].slice(0, D).every((k) => point[k] > lower[k] - 2 * size && point[k] < upper[k] + 2 * size);
}
