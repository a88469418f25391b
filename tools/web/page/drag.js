// The stage under pointer and keys. A drag turns the light or the observer; a click, or Enter,
// follows a pixel; arrow keys do the same in small steps.

const degreesAcross = 180;  // of a drag over the whole stage
const still = 4;            // pixels of the screen within which a press is a click

// The overrides that turn a view of the frame by so many degrees from where it is. A light that
// stands at a place is moved about the vertical axis through its target.
export function turned(view, byAzimuth, byElevation) {
  const azimuth = ((view.azimuth + byAzimuth + 540) % 360) - 180;
  const elevation = Math.min(85, Math.max(-85, view.elevation + byElevation));
  const text4 = (n) => Math.round(n * 1e4) / 1e4;
  const text = (n) => String(Math.round(n * 100) / 100);
  if (view.name === 'observer' || !view.perspective)
    return { [`${view.name}.azimuth`]: text(azimuth), [`${view.name}.elevation`]: text(elevation) };
  const a = azimuth * Math.PI / 180, e = elevation * Math.PI / 180;
  const back = [Math.cos(e) * Math.sin(a), Math.sin(e), Math.cos(e) * Math.cos(a)];
  const place = back.map((along, k) => text4(view.target[k] + view.distance * along));
  return { [`${view.name}.position`]: `[${place.join(', ')}]` };
}

export class Drag {
  #stage;
  #mode = 'light';
  #turn;    // (view's name, degrees of azimuth, of elevation, from the press on)
  #follow;  // (x, y) of the picture
  #start;   // called when a drag begins
  #from = null;

  constructor(stage, { turn, follow, start }) {
    this.#stage = stage;
    this.#turn = turn;
    this.#follow = follow;
    this.#start = start;
    stage.addEventListener('pointerdown', (event) => this.#press(event));
    stage.addEventListener('pointermove', (event) => this.#move(event));
    stage.addEventListener('pointerup', (event) => this.#release(event));
    stage.addEventListener('pointercancel', () => { this.#from = null; });
    stage.addEventListener('keydown', (event) => this.#key(event));
  }

  set mode(mode) { this.#mode = mode; }

  #place(event) {
    const box = this.#stage.getBoundingClientRect();
    return [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
  }

  #press(event) {
    if (event.button !== 0) return;
    this.#stage.setPointerCapture(event.pointerId);
    this.#from = { place: this.#place(event), x: event.clientX, y: event.clientY, moved: false };
    this.#start();
  }

  #move(event) {
    if (!this.#from) return;
    const far = Math.hypot(event.clientX - this.#from.x, event.clientY - this.#from.y);
    if (!this.#from.moved && far < still) return;
    this.#from.moved = true;
    if (this.#mode === 'pixel') return this.#followAt(this.#place(event));
    const [x, y] = this.#place(event);
    const across = (x - this.#from.place[0]) * degreesAcross;
    const down = (y - this.#from.place[1]) * degreesAcross;
    // The scene follows the hand; so does the light.
    if (this.#mode === 'light') this.#turn('light', across, -down);
    else this.#turn('observer', -across, down);
  }

  #release(event) {
    if (this.#from && !this.#from.moved) this.#followAt(this.#place(event));
    this.#from = null;
  }

  #followAt([x, y]) {
    const inside = (share) => Math.min(0.999999, Math.max(0, share));
    this.#follow(inside(x), inside(y));
  }

  #key(event) {
    const step = event.shiftKey ? 10 : 1;
    const along = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    if (event.key === 'Enter') {
      this.#follow(null, null, 0, 0);
    } else if (event.key in along) {
      const [dx, dy] = along[event.key].map((each) => each * step);
      this.#start();
      if (this.#mode === 'pixel') this.#follow(null, null, dx, dy);
      else if (this.#mode === 'light') this.#turn('light', dx, -dy);
      else this.#turn('observer', -dx, dy);
    } else {
      return;
    }
    event.preventDefault();
  }
}
