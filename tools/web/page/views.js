// The pictures side by side, and the one of them that is on the stage, with its wipe and its marks.
import { byId, element, paint } from './dom.js';

// By the planes' names; of a frame with several lights the first one's.
export const shown = [
  { name: 'light_z', title: 'depth map', of: 'the light\u2019s Z buffer, near is bright' },
  { name: 'intensity', title: 'observer', of: 'the picture before its shadows' },
  { name: 'mask', title: 'mask', of: 'what the comparison says: white is in shadow' },
  { name: 'filtered', title: 'filtered', of: 'the mask after its filters' },
  { name: 'picture', title: 'picture', of: 'the shadow laid on the picture' },
  { name: 'error', title: 'error', settled: true,
    of: 'against exact geometry: red false shadow, blue false light, yellow other surface, ' +
        'green the exact edge' },
  { name: 'spectrum', title: 'spectrum', settled: true,
    of: 'of the error where it is densest, 64 \u00d7 64 pixels: dots are moire, haze is noise' },
];
export const drawnNames = shown.filter((view) => !view.settled).map((view) => view.name);
export const settledNames = shown.filter((view) => view.settled).map((view) => view.name);

export class Views {
  #tiles = new Map();
  #pictures = new Map();
  #others = new Map();  // of the other settings, on the wipe's left
  #hashes = {};
  #goldens;             // name of a golden by its hash
  #show = 'picture';
  #texel = null;
  #pixel = null;

  constructor(goldens, choose) {
    this.#goldens = goldens;
    for (const view of shown) {
      const canvas = element('canvas', { width: 512, height: 512 });
      const badge = element('span.badge');
      const tile = element('button.tile', { type: 'button', title: view.of,
                                            onclick: () => choose(view.name) },
                           canvas, element('span.name', {}, view.title), badge);
      tile.dataset.view = view.name;
      this.#tiles.set(view.name, { tile, canvas, badge });
      byId('tiles').append(tile);
    }
  }

  get show() { return this.#show; }
  picture(name) { return this.#pictures.get(name) ?? null; }

  // A plane's hash and the golden that has it; of a coloured frame one for each channel.
  #published(name) {
    const names = name in this.#hashes ? [name]
                                       : ['red', 'green', 'blue'].map((each) => `${name}_${each}`);
    const hashes = names.map((each) => this.#hashes[each]).filter((hash) => hash);
    const goldens = hashes.map((hash) => this.#goldens.get(hash)).filter((golden) => golden);
    const all = hashes.length > 0 && goldens.length === hashes.length;
    return { hash: hashes.join(' '), golden: all ? goldens.join(', ') : '' };
  }

  // Pictures of a frame. Those that take longer come later and are marked until then.
  take(pictures) {
    for (const picture of pictures) this.#pictures.set(picture.name, picture);
    this.takeTiles(pictures);
    if (pictures.some((picture) => picture.name === this.#show)) this.#paintStage();
  }

  // The same, smaller: for the tiles alone.
  takeTiles(pictures) {
    for (const picture of pictures) {
      const { tile, canvas } = this.#tiles.get(picture.name);
      paint(canvas, picture);
      tile.classList.remove('stale', 'absent');
    }
  }

  expect() {
    this.#hashes = {};
    for (const { badge } of this.#tiles.values()) badge.textContent = '';
    for (const name of settledNames) this.#tiles.get(name).tile.classList.add('stale');
    byId('stage-hash').textContent = '';
    byId('stage-golden').textContent = '';
  }

  // What this frame has not: an error without truth, a map on a ground.
  lacks(names) {
    for (const name of names) {
      this.#pictures.delete(name);
      const { tile, canvas } = this.#tiles.get(name);
      canvas.getContext('2d').clearRect(0, 0, canvas.width, canvas.height);
      tile.classList.add('absent');
      tile.classList.remove('stale');
    }
    if (names.includes(this.#show)) this.#paintStage();
  }

  takeHashes(hashes) {
    this.#hashes = hashes;
    for (const [name, { badge }] of this.#tiles) {
      const { golden } = this.#published(name);
      badge.textContent = golden ? '\u2713' : '';
      badge.title = golden ? `equals the golden ${golden}` : '';
    }
    this.#captions();
  }

  choose(name) {
    this.#show = name;
    for (const [each, { tile }] of this.#tiles)
      tile.setAttribute('aria-pressed', String(each === name));
    this.#paintStage();
  }

  #paintStage() {
    const stage = byId('stage'), picture = this.#pictures.get(this.#show);
    if (picture) paint(stage, picture);
    else stage.getContext('2d').clearRect(0, 0, stage.width, stage.height);
    byId('stage-none').hidden = Boolean(picture);
    const other = this.#others.get(this.#show);
    byId('stage-other').hidden = !other;
    if (other) paint(byId('stage-other'), other);
    this.#captions();
    this.#marks();
  }

  #captions() {
    const view = shown.find((each) => each.name === this.#show);
    byId('stage-title').textContent = view.title;
    byId('stage-of').textContent = view.of;
    const { hash, golden } = this.#published(this.#show);
    byId('stage-hash').textContent = hash;
    byId('stage-golden').textContent = golden ? `\u2713 golden ${golden}` : '';
  }

  // --- the wipe between two settings

  takeOther(pictures) {
    this.#others = new Map(pictures.map((picture) => [picture.name, picture]));
    this.#paintStage();
  }
  dropOther() { this.#others.clear(); this.#paintStage(); }
  wipe(share) {
    byId('stage-other').style.clipPath = `inset(0 ${100 * (1 - share)}% 0 0)`;
    byId('wipe-line').style.left = `${100 * share}%`;
  }

  // --- marks: the pixel that is followed, and where it is looked up in the depth map

  mark(pixel, texel) {
    this.#pixel = pixel;
    this.#texel = texel;
    this.#marks();
  }
  #marks() {
    const mark = byId('mark'), picture = this.#pictures.get(this.#show);
    const at = this.#show === 'light_z' ? this.#texel : this.#show === 'spectrum' ? null
                                                                                  : this.#pixel;
    mark.hidden = !at || !picture;
    if (mark.hidden) return;
    mark.style.left = `${100 * (at[0] + 0.5) / picture.size}%`;
    mark.style.top = `${100 * (at[1] + 0.5) / picture.size}%`;
  }
}
