// The list of events: only the rows that are seen exist, so a million events cost no more than a hundred.

import {grouped, shortNumber} from './numbers.js';

const ROW = 26, TALLEST = 6e6; // [px] browsers do not scroll much further than some 10^7

export class EventList {
  constructor(place, replay, goTo) {
    Object.assign(this, {place, replay, goTo});
    place.innerHTML = '<div class="rows"></div>';
    this.rows = place.firstElementChild;
    place.addEventListener('scroll', () => this.draw(), {passive: true});
    place.addEventListener('click', (event) => {
      const row = event.target.closest('[data-event]');
      if (row) this.goTo(Number(row.dataset.event) + 1);
    });
    new ResizeObserver(() => this.draw()).observe(place);
    this.shown = -1;
  }

  get events() {
    return this.replay.log.events;
  }

  /** How far an event's row lies from the top; beyond TALLEST, rows share pixels. */
  get pitch() {
    return Math.min(ROW, TALLEST / Math.max(1, this.events));
  }

  /** Brings the current event into view. */
  tick(event) {
    if (event === this.shown && this.events === this.known) return;
    this.shown = event;
    const top = Math.max(0, (event - 1) * this.pitch), {scrollTop, clientHeight} = this.place;
    if (top < scrollTop || top > scrollTop + clientHeight - 2 * ROW) this.place.scrollTop = top - clientHeight / 3;
    this.draw();
  }

  draw() {
    const {place, rows, events, pitch} = this;
    this.known = events;
    rows.style.height = Math.max(events * pitch, 1) + 'px';
    const first = Math.max(0, Math.floor(place.scrollTop / pitch) - 4), most = Math.ceil(place.clientHeight / ROW) + 8;
    const list = [];
    for (let e = first; e < Math.min(events, first + most); ++e) list.push(this.row(e, place.scrollTop + (e - place.scrollTop / pitch) * ROW));
    rows.innerHTML = list.join('');
  }

  row(e, top) {
    const {log} = this.replay;
    const who = log.kind[e] === 2 ? 'changes its motion' : '· ' + brief(this.replay.partnerName(e));
    const classes = (e + 1 === this.shown ? 'current ' : '') + (log.missed?.has(e) ? 'missed' : '');
    const text = `<span>${grouped(e + 1)}</span><span>${shortNumber(log.time[e], 7)}</span><span>${escape(brief(this.replay.ballName(log.ball[e])))} ${escape(who)}</span>` +
      `<span>${log.kind[e] === 2 ? '' : shortNumber(log.impulse[e])}${log.tie[e] ? ' tie' : ''}</span>`;
    return `<div class="event ${classes}" data-event="${e}" style="top:${top}px">${text}</div>`;
  }
}

const brief = (name) => name.replace(/^(ball|face) /, '');

function escape(text) {
  return text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
}
