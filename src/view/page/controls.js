// Buttons, keys and fields.

import {shortNumber} from './numbers.js';

const $ = (id) => document.getElementById(id);

export function bindControls(app) {
  const {options} = app;
  $('play').addEventListener('click', () => app.play());
  $('next').addEventListener('click', () => app.step(1));
  $('previous').addEventListener('click', () => app.step(-1));
  $('first').addEventListener('click', () => app.goTo(0));
  $('last').addEventListener('click', () => app.seek(app.replay.end));
  $('fit').addEventListener('click', () => {
    app.follow(-1);
    app.leader = app.stage;
    app.stage.fit();
  });
  const zoom = (factor) => {
    app.leader = app.stage;
    app.stage.zoom(factor);
  };
  $('zoom-in').addEventListener('click', () => zoom(1.5));
  $('zoom-out').addEventListener('click', () => zoom(1 / 1.5));
  $('unfollow').addEventListener('click', () => app.follow(-1));
  $('help-button').addEventListener('click', () => $('help').showModal());
  $('theme').addEventListener('click', () => {
    const theme = document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark';
    try {
      localStorage.setItem('carom-theme', theme);
    } catch { /* a page from a file may keep nothing */ }
    app.setTheme(theme);
  });
  bindSpeed(app);
  bindJump(app);
  for (const button of document.querySelectorAll('[data-toggle]')) {
    const name = button.dataset.toggle, show = () => button.setAttribute('aria-pressed', String(options[name]));
    button.hidden = name === 'images' && app.scene.space.kind !== 'periodic';
    button.addEventListener('click', () => {
      options[name] = !options[name];
      show();
      options.changed();
    });
    show();
  }
  const mode = $('colour-mode');
  mode.value = app.colours.mode;
  mode.querySelector('[value=size]').hidden = app.colours.kinds < 2;
  mode.addEventListener('change', () => {
    app.colours.mode = mode.value;
    options.changed();
  });
  bindKeys(app, zoom);
  app.play(false);
}

function bindSpeed(app) {
  const slider = $('speed');
  const show = () => {
    $('speed-text').textContent = shortNumber(app.speed) + ' time / s';
    slider.setAttribute('aria-valuetext', $('speed-text').textContent);
  };
  slider.addEventListener('input', () => {
    app.exponent = Number(slider.value);
    show();
  });
  app.setExponent = (x) => {
    app.exponent = Math.max(-9, Math.min(3, x));
    slider.value = String(app.exponent);
    show();
  };
  show();
}

/** A number is a time; with # before it, an event. */
function bindJump(app) {
  $('jump').addEventListener('submit', (event) => {
    event.preventDefault();
    const field = $('jump-to'), text = field.value.trim().replace('−', '-');
    const value = Number(text.replace(/^#/, '')), good = text !== '' && Number.isFinite(value);
    field.setCustomValidity(good ? '' : 'A time, as 1.25, or an event, as #12');
    field.reportValidity();
    if (!good) return;
    app.play(false);
    if (text.startsWith('#')) app.goTo(Math.round(value));
    else app.seek(value);
    field.blur();
  });
  $('jump-to').addEventListener('input', () => $('jump-to').setCustomValidity(''));
}

function bindKeys(app, zoom) {
  const toggle = (name) => document.querySelector(`[data-toggle=${name}]:not([hidden])`)?.click();
  const keys = {
    ' ': () => app.play(), ArrowRight: (e) => app.step(stride(e)), ArrowLeft: (e) => app.step(-stride(e)),
    ArrowUp: () => app.setExponent(app.exponent + 0.25), ArrowDown: () => app.setExponent(app.exponent - 0.25),
    Home: () => app.goTo(0), End: () => app.seek(app.replay.end), '+': () => zoom(1.5), '=': () => zoom(1.5), '-': () => zoom(1 / 1.5), 0: () => $('fit').click(),
    t: () => toggle('trails'), v: () => toggle('arrows'), i: () => toggle('impacts'), p: () => toggle('images'), c: () => closer(app),
    g: () => $('jump-to').focus(), '?': () => $('help').showModal(), Escape: () => app.follow(-1),
  };
  document.addEventListener('keydown', (event) => {
    const field = event.target.closest?.('input, select, textarea');
    if (event.ctrlKey || event.metaKey || $('help').open || (field && field.type !== 'range')) return;
    if (event.target.closest?.('button, summary') && (event.key === ' ' || event.key === 'Enter')) return;
    const act = keys[event.key];
    if (!act) return;
    event.preventDefault();
    act(event);
  });
}

const stride = (event) => (event.altKey ? 100 : event.shiftKey ? 10 : 1);

/** Ten times closer to the point of the last contact. */
function closer(app) {
  const {replay, stage} = app;
  if (replay.event === 0) return;
  const contact = replay.contact(replay.event - 1);
  if (!contact || !stage.context) return;
  app.leader = stage;
  app.follow(-1);
  stage.centre = [contact.point[0], stage.oneDimensional ? 0 : contact.point[1]];
  stage.zoom(10);
}
