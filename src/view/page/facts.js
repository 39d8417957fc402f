// What there is to say about the run in words and numbers.

import {fill} from './app.js';
import {grouped, shortNumber} from './numbers.js';

const $ = (id) => document.getElementById(id);

export function showFacts(app) {
  const {scene, result, log} = app;
  const title = scene.title || 'Untitled';
  document.title = title + ' · carom';
  $('title').textContent = title;
  const parts = [`${grouped(scene.balls)} ball${scene.balls === 1 ? '' : 's'} in ${scene.dimension}-D`, `${grouped(log.events)} event${log.events === 1 ? '' : 's'}`];
  if (result?.cut) parts.push(`the first ${grouped(result.cut)} collisions of the run`);
  if (result?.summary?.stopped) parts.push(`stopped: ${result.summary.stopped.reason}`);
  if (scene.live && !result) parts.push('running');
  $('subtitle').textContent = parts.join(' · ');
  $('list-note').textContent = '';
  if (result) showResult(app);
  const model = $('model');
  model.replaceChildren(...(scene.model ?? []).map((sentence) => {
    const item = document.createElement('li');
    item.textContent = sentence;
    return item;
  }));
  $('scene-text').textContent = scene.text ?? '';
}

function showResult({scene, result}) {
  const s = result.summary, e = s.exactness;
  const facts = [
    ['energy error', relative(s.energy.relative_error)], ['momentum error', relative(s.momentum.relative_error)],
    ['angular momentum error', relative(s.angular_momentum.relative_error)], ['largest gap at a contact', `${shortNumber(e.max_gap_error)}; ${shortNumber(e.max_gap_error_relative)} of the radii`],
    ['collisions', `${grouped(s.events.ball_ball)} of two balls, ${grouped(s.events.ball_wall)} with walls`], ['ties', grouped(s.events.ties)],
    ['clamped, unresolved, singular', `${e.clamped}, ${e.unresolved}, ${e.singular}`],
    ['energy', `${shortNumber(s.energy.initial, 6)} → ${shortNumber(s.energy.final, 6)}`], ['dissipated, injected', `${shortNumber(s.energy.dissipated, 4)}, ${shortNumber(s.energy.injected, 4)}`],
    ['run as', s.composition], ['precision', s.precision], ['written by', 'carom ' + scene.version],
  ];
  fill($('exactness'), facts);
  const observed = flatten(s.observed ?? {});
  $('observed-card').hidden = observed.length === 0;
  $('observed-card').open = observed.length > 0;
  fill($('observed'), observed);
}

function relative(x) {
  return x === null || x === undefined ? 'not conserved in this scene' : shortNumber(x) + ', relative';
}

/** Estimates by their dotted names: value and standard error. */
function flatten(object, prefix = '') {
  return Object.entries(object).flatMap(([key, x]) => {
    if (x === null || typeof x !== 'object') return [];
    if ('value' in x) return [[prefix + key, x.error === null ? shortNumber(x.value, 6) : `${shortNumber(x.value, 6)} ± ${shortNumber(x.error, 2)}`]];
    return flatten(x, prefix + key + '.');
  });
}
