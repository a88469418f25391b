// What the frame comes to, in figures: errors, the pattern in them, cycles, milliseconds.
import { byId, element, grouped, percent, short } from './dom.js';

const WHITE_NOISE = 0.5615;  // its spectral flatness (tools/truth/spectrum.hpp)

// id, name, help
const meters = [
  ['false_shadow', 'false shadow', 'of the pixels that exact geometry lights'],
  ['false_light', 'false light', 'of the pixels in true shadow'],
  ['mean', 'mean error', 'of the light that exact geometry sees, grey levels included'],
  ['isolated', 'isolated pixels', 'whose neighbours all have the other answer'],
  ['flatness', 'flatness', `of the error\u2019s spectrum: near 0 is moire, ${WHITE_NOISE} noise`],
  ['period', 'period', 'of the spectrum\u2019s highest line'],
  ['cycles', 'machine cycles', 'of the whole frame'],
  ['host', 'this computer', 'the frame from the change to its pictures'],
];

export class Gauges {
  constructor() {
    for (const [id, name, help] of meters)
      byId('gauges').append(element('div.gauge', { title: help },
        element('dt', {}, name), element('dd', { id: `gauge-${id}` }, '\u2026'),
        element('p.help', { id: `help-${id}` }, help)));
  }

  #put(id, text) {
    const field = byId(`gauge-${id}`);
    field.textContent = text;
    field.classList.remove('stale');
  }

  expect() {
    for (const [id] of meters) if (id !== 'host') byId(`gauge-${id}`).classList.add('stale');
  }

  takeFrame(frame) {
    const ms = frame.host_ms;
    this.#put('host', `${frame.frame_ms.toFixed(1)} ms`);
    this.#put('isolated', grouped(frame.isolated_pixels));
    if (frame.rates) this.#takeRates(frame.rates);
    const stages = [['light', ms.light], ['observer', ms.observer], ['shadow', ms.post_process],
                    ['filters', ms.filters]].map(([name, of]) => `${name} ${of.toFixed(1)}`);
    byId('help-host').textContent = `the frame and its pictures: ${stages.join(', ')}`;
  }

  takeMachine({ cycles, ms }) {
    this.#put('cycles', grouped(cycles));
    byId('help-cycles').textContent = `of the whole frame: ${(ms / 1000).toFixed(2)} s in 1978`;
  }

  #takeRates(rates) {
    this.#put('false_shadow', percent(rates?.false_shadow));
    this.#put('false_light', percent(rates?.false_light));
  }

  takeError(answer) {
    const { error } = answer;
    const by = error?.truth.by === 'polygons'
      ? 'Errors are against the facets that patches are diced into, found exactly by the ' +
        'alias-free shadow map: patches have no closed form.' : '';
    byId('why-no-truth').textContent = error ? by : `Errors: n/a (${answer.because}).`;
    this.#takeRates(error?.at_threshold ?? error);
    this.#put('mean', percent(error?.graded.mean_absolute));
    this.#put('flatness', answer.flatness ? answer.flatness.toFixed(2) : 'n/a');
    this.#put('period', answer.period_px ? `${short(answer.period_px, 3)} pixels` : 'n/a');
  }
}
