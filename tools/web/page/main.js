// The page: its state, what is asked of the worker when it changes, and who shows the answers.
import { Client } from './client.js';
import { Controls } from './controls.js';
import { byId, element } from './dom.js';
import { Drag, turned } from './drag.js';
import { Gauges } from './gauges.js';
import { Pipeline, cyclesShown } from './pipeline.js';
import { PixelPanel, texelRequest, texelsOf } from './pixel.js';
import { commandOf, firstState, fitsAddress, fromHash, fromPreset, isPreset, overrides,
         toHash } from './state.js';
import { Views, drawnNames, settledNames, shown } from './views.js';

const settleMs = 80;    // without a further change before what takes longer is asked for,
const longRestMs = 500;  // and before what takes about a second: truth without a closed form

const client = new Client(byId('worker-text').textContent);
let state = fromHash(location.hash);
let frame = null;        // the machine's last answer
let presets = [];
let version = 0;         // of the state; answers to older ones are not shown
let views, controls, gauges, pixelPanel, pipeline;

// --- drawing

const sceneRequest = ({ scene, text, set }) => ({ scene, text, set: overrides(set) });

// The picture on the stage whole, the others as tiles: settle() has them whole once nothing moves.
function draw() {
  const mine = ++version;
  delete document.documentElement.dataset.settled;
  const names = drawnNames.filter((name) => name === state.show);
  const tiles = drawnNames.filter((name) => name !== state.show);
  client.draw({ ...sceneRequest(state), names, tiles }, (answer) => take(answer, mine));
  showState();
}

function take(answer, mine) {
  report(answer.problem ?? '');
  if (answer.problem) return;
  frame = answer;
  views.expect();
  gauges.expect();
  views.take(answer.pictures);
  views.takeTiles(answer.tiles);
  const names = [...answer.pictures, ...answer.tiles].map((picture) => picture.name);
  views.lacks(drawnNames.filter((name) => !names.includes(name)));
  gauges.takeFrame(answer);
  controls.show(answer, state.set);
  byId('warnings').replaceChildren(
    ...answer.warnings.map((line) => element('li', {}, line)));
  if (mine === version) setTimeout(() => settle(mine), settleMs);
}

// What takes longer, one request after the other, as long as the state stays.
async function settle(mine) {
  const steps = [
    ['pictures', (answer) => views.take(answer), { names: drawnNames }],
    ['hashes', (answer) => views.takeHashes(answer)],
    ['machine', (answer) => gauges.takeMachine(answer)],
    ['error', (answer) => gauges.takeError(answer)],
    ['pictures', (answer) => takeSettled(answer), { names: settledNames }],
  ];
  for (const [what, show, more] of steps) {
    if (what === 'error' && !frame.has_closed_form && !frame.rates) await rest(longRestMs);
    if (mine !== version) return;
    const answer = await client.ask({ do: what, ...more });
    if (mine !== version) return;
    if (answer.problem) report(answer.problem);
    else show(answer);
  }
  if (state.pixel) await follow(mine);
  if (mine === version) document.documentElement.dataset.settled = String(mine);
}

const rest = (ms) => new Promise((resolve) => { setTimeout(resolve, ms); });

function takeSettled(pictures) {
  views.take(pictures);
  const names = pictures.map((picture) => picture.name);
  views.lacks(settledNames.filter((name) => !names.includes(name)));
}

async function follow(mine) {
  const [x, y] = state.pixel;
  const trace = await client.ask({ do: 'trace', x, y });
  if (mine !== version) return;
  pixelPanel.show(state.pixel, trace);
  if (trace.problem) {
    views.mark(state.pixel, null);
    pixelPanel.showTexels({ at: null }, {});
    return pipeline.hide();
  }
  const texels = texelsOf(trace);
  views.mark(state.pixel, texels.at);
  pixelPanel.showTexels(texels, texels.at ? await client.ask(texelRequest(texels.at)) : {});
  const log = await client.ask({ do: 'cycles', from: trace.first_cycle, count: cyclesShown });
  if (mine === version) pipeline.show(log);
}

function report(problem) {
  byId('problem').textContent = problem;
  byId('problem').hidden = problem === '';
}

// --- the state

function writeAddress() {
  const hash = toHash(state);
  if (hash !== location.hash) history.replaceState(null, '', hash);
}

// What the page shows of the state by itself.
function showState() {
  writeAddress();
  const alike = presets.filter((each) => isPreset(state, each));
  const preset = alike.find((each) => each.plane === state.show) ?? alike.at(-1);
  for (const button of byId('figures').children)
    button.setAttribute('aria-pressed', String(button.dataset.name === preset?.name));
  byId('gallery').value = preset && !preset.name.startsWith('figure') ? preset.name : '';
  byId('command').textContent = commandOf(state);
  byId('copy-link').disabled = !fitsAddress(state);
  byId('copy-link').title = fitsAddress(state) ? 'the address has all that is set here'
                                               : 'this scene is too long for a link';
  byId('drop-other').hidden = byId('wipe-row').hidden = byId('wipe-line').hidden = !state.other;
  byId('other-is').textContent = state.other
    ? `Left: ${state.other.text === null ? state.other.scene : 'pasted scene'} ` +
      overrides(state.other.set).join(' ') : '';
}

function change(key, value, isPartial = false) {
  const set = { ...state.set };
  if (value === null) delete set[key];
  else set[key] = String(value);
  state = { ...state, set };
  if (!isPartial) draw();
}

function go(next) {
  state = { ...next, other: state.other, wipe: state.wipe };
  choose(next.show);
  if (!state.pixel) forgetPixel();
  draw();
}

function choose(name) {
  state = { ...state, show: name };
  views.choose(name);
  showState();
}

function forgetPixel() {
  state = { ...state, pixel: null };
  views.mark(null, null);
  pixelPanel.hide();
  pipeline.hide();
}

// --- pointer and keys

let turnFrom = null;  // the frame's views when a drag began

function turn(name, azimuth, elevation) {
  const view = turnFrom?.find((each) => each.name === name) ??
               turnFrom?.find((each) => each.name.startsWith(name));
  if (!view) return;
  state = { ...state, set: { ...state.set, ...turned(view, azimuth, elevation) } };
  draw();
}

function followAt(x, y, dx, dy) {
  const size = views.picture('picture')?.size ?? 512;
  const inside = (n) => Math.min(size - 1, Math.max(0, n));
  const from = state.pixel ?? [size / 2, size / 2];
  const isSpectrum = views.show === 'spectrum' || views.show === 'light_z';
  if (x !== null && isSpectrum) choose('mask');
  else if (x !== null) state.pixel = [Math.floor(x * size), Math.floor(y * size)];
  else state.pixel = [inside(from[0] + dx), inside(from[1] + dy)];
  if (!state.pixel) return;
  views.mark(state.pixel, null);
  writeAddress();
  follow(version);
}

// --- the two settings of the wipe

function keepOther() {
  state = { ...state, other: { scene: state.scene, text: state.text, set: state.set } };
  showState();
  return drawOther();
}

function dropOther() {
  state = { ...state, other: null };
  views.dropOther();
  writeAddress();
  showState();
}

function wipeTo(share) {
  state = { ...state, wipe: share };
  byId('wipe').value = share;
  views.wipe(share);
  writeAddress();
}

// The left one of two settings; in one request, so that no other frame comes between.
async function drawOther() {
  const answer = await client.ask({ do: 'draw', ...sceneRequest(state.other),
                                    names: [...drawnNames, ...settledNames] });
  if (answer.problem) return report(answer.problem);
  views.takeOther(answer.pictures);
  wipeTo(state.wipe);
}

// A state from an address.
async function adopt(next) {
  state = next;
  if (!shown.some((view) => view.name === state.show)) state.show = firstState.show;
  views.choose(state.show);
  views.dropOther();
  if (!state.pixel) forgetPixel();
  if (state.other) await drawOther();
  draw();
}

// --- the start

function wire() {
  const stage = byId('stage');
  const drag = new Drag(stage, { turn, follow: followAt,
                                 start: () => { turnFrom = frame?.views ?? null; } });
  for (const input of document.querySelectorAll('input[name=drag]'))
    input.onchange = () => { drag.mode = input.value; };
  byId('keep-other').onclick = keepOther;
  byId('drop-other').onclick = dropOther;
  byId('wipe').oninput = (event) => wipeTo(Number(event.target.value));
  byId('reset-all').onclick = () => go({ ...state, set: {} });
  byId('paste').onclick = () => byId('paste-dialog').showModal();
  byId('paste-draw').onclick = () => go({ ...firstState, scene: 'pasted.toml',
                                          text: byId('paste-text').value });
  byId('copy-link').onclick = async () => {
    await navigator.clipboard?.writeText(location.href);
    byId('copy-link').textContent = 'copied';
    setTimeout(() => { byId('copy-link').textContent = 'copy link'; }, 1200);
  };
  window.onhashchange = () => adopt(fromHash(location.hash));
}

function listPresets() {
  for (const preset of presets) {
    if (preset.name.startsWith('figure'))
      byId('figures').append(element('button', {
        type: 'button', title: preset.shows, 'data-name': preset.name,
        onclick: () => go(fromPreset(preset)) }, preset.name.replace('figure ', '')));
    else
      byId('gallery').append(element('option', { value: preset.name },
                                     `${preset.name}: ${preset.shows}`));
  }
  byId('gallery').onchange = (event) => {
    const preset = presets.find((each) => each.name === event.target.value);
    if (preset) go(fromPreset(preset));
  };
}

function readGoldens(text) {
  return new Map(text.trim().split('\n').map((line) => line.split(' ').reverse()));
}

async function start() {
  const packed = { wasm: byId('wasm').textContent, held: byId('held').textContent };
  const answer = await client.start(packed);
  byId('wasm').remove();
  byId('held').remove();
  if (answer.problem) return report(`The machine could not be started: ${answer.problem}`);
  presets = answer.presets;
  views = new Views(readGoldens(answer.goldens), choose);
  controls = new Controls(answer.table, change);
  gauges = new Gauges();
  pixelPanel = new PixelPanel();
  pipeline = new Pipeline((cycle) => pixelPanel.showCycle(cycle));
  listPresets();
  wire();
  // Without a state in its address the page opens with the moire.
  if (location.hash === '') state = fromPreset(presets.find(({ golden }) => golden === 'mask3'));
  await adopt(state);
  document.documentElement.dataset.ready = 'yes';
}

start();
