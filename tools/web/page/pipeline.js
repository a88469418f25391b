// The pipeline, cycle by cycle: a row is a stage, a column a cycle, a digit a pixel on its way. The
// cycles come from the clocked machine (tools/web/cycle_log.hpp).
import { byId, element } from './dom.js';

const letters = '123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ';
const hues = [210, 30, 130, 280, 0, 60, 170, 330];
export const cyclesShown = 48;

export class Pipeline {
  #log = null;
  #at = 0;
  #moved;      // (cycle): the cursor is there
  #player = 0;

  constructor(moved) {
    this.#moved = moved;
    byId('step-back').onclick = () => this.#step(-1);
    byId('step').onclick = () => this.#step(1);
    byId('play').onclick = () => this.#play();
    byId('cursor').oninput = (event) => this.#go(Number(event.target.value));
  }

  show(log) {
    this.#stop();
    this.#log = log.problem ? null : log;
    byId('pipeline').hidden = !this.#log;
    byId('pipeline-summary').textContent = log.problem ?? this.#summary(log);
    if (!this.#log) return;
    byId('cursor').max = log.cycles.length - 1;
    this.#draw();
    this.#go(0);
  }

  hide() {
    this.#stop();
    byId('pipeline').hidden = true;
    byId('pipeline-summary').textContent = '';
  }

  #summary(log) {
    return `A pixel enters every ${log.slot_cycles} cycles and is ${log.latency} cycles on its ` +
           'way. A row is a stage, a column a cycle, a digit a pixel.';
  }

  // Points are numbered from the first that enters while we look.
  #letter(point) {
    const index = point - this.#firstPoint();
    return index < 0 ? '\u2039' : letters[index] ?? '\u203a';
  }
  #firstPoint() {
    return this.#log.cycles.find((cycle) => cycle.released > 0)?.released ?? Infinity;
  }

  #readerCell({ reader, released }) {
    const [what, , , seen] = reader;
    if (what === 'done') return [' ', null];
    if (what === 'read' && seen === 'background') return ['\u00b7', null];
    if (what === 'slot' && released === 0) return ['~', null];
    return [released > 0 ? this.#letter(released) : what === 'read' ? 'r' : '=', released || null];
  }

  #stageCell(entry) {
    if (entry === null) return ['', null];
    const [what, point] = entry;
    return [what === 'work' ? this.#letter(point) : what === 'blocked' ? '=' : '#', point];
  }

  #draw() {
    const { stages, cycles } = this.#log;
    const head = element('tr', {}, element('th', {}, 'cycle'),
      ...cycles.map(({ cycle }) => element('th', {}, cycle % 10 === 0 ? String(cycle) : '')));
    const rows = ['reader', ...stages].map((name, k) => element('tr', {},
      element('th', { scope: 'row' }, name),
      ...cycles.map((cycle, column) => {
        const [text, point] = k === 0 ? this.#readerCell(cycle)
                                      : this.#stageCell(cycle.stages[k - 1]);
        const cell = element('td', { onclick: () => this.#go(column) }, text);
        if (point !== null) cell.style.setProperty('--hue', hues[point % hues.length]);
        if (point !== null) cell.className = 'busy';
        return cell;
      })));
    byId('waterfall').replaceChildren(head, ...rows);
  }

  #go(column) {
    this.#at = Math.min(Math.max(column, 0), this.#log.cycles.length - 1);
    byId('cursor').value = this.#at;
    for (const row of byId('waterfall').rows)
      for (const cell of row.cells)
        cell.classList.toggle('now', cell.cellIndex === this.#at + 1);
    const now = this.#log.cycles[this.#at];
    byId('cycle-now').textContent = `cycle ${now.cycle}`;
    byId('stages-now').replaceChildren(...this.#stagesNow(now));
    this.#moved(now.cycle);
  }

  #stagesNow(now) {
    const reader = element('li', {}, element('b', {}, 'reader'), ` ${now.reader.join(' ')}`);
    return [reader, ...this.#log.stages.map((name, k) => {
      const entry = now.stages[k];
      const text = entry ? ` ${entry[0]}: pixel ${entry[2]}, ${entry[3]}` : ' idle';
      return element('li', entry ? {} : { className: 'idle' }, element('b', {}, name), text);
    })];
  }

  #step(by) { this.#stop(); if (this.#log) this.#go(this.#at + by); }

  #play() {
    if (this.#player) return this.#stop();
    byId('play').textContent = 'pause';
    this.#player = setInterval(() => {
      if (this.#at + 1 < this.#log.cycles.length) this.#go(this.#at + 1);
      else this.#stop();
    }, 300);
  }
  #stop() {
    clearInterval(this.#player);
    this.#player = 0;
    byId('play').textContent = 'play';
  }
}
