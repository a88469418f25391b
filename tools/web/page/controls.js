// Controls for all settings, made from the machine's table: nothing about a setting is written here
// but which ones stand first.
import { byId, element, short } from './dom.js';

const first = ['bias', 'lookup', 'dither', 'dequantize', 'low_pass', 'xy_bits', 'z_bits',
               'fraction_bits', 'receiver', 'map_depth', 'taps', 'density', 'form'];
const units = ['quanta', 'texels', 'world'];
const mostSteps = 8192;  // a slider with more is a number alone

// Written only where it differs: each frame that is dragged puts the values of all settings.
function assign(control, value) {
  if (control.value !== String(value)) control.value = value;
}

export class Controls {
  #change;    // (key, value) or (key, null), which is the scene's own
  #rows = new Map();
  #bias = null;      // the unit in use
  #biasUnit;         // of the default bias

  constructor(table, change) {
    this.#change = change;
    const settings = new Map(table.settings.map((setting) => [setting.key, setting]));
    this.#biasUnit = settings.get('bias_unit').default;
    this.#profiles(table.profiles);
    for (const key of first) byId('first-settings').append(this.#row(settings.get(key)));
    for (const [key, setting] of settings)
      if (!first.includes(key) && key !== 'bias_unit')
        byId('other-settings').append(this.#row(setting));
    byId('find-setting').oninput = (event) => this.#find(event.target.value);
  }

  #profiles(profiles) {
    const select = byId('profile');
    for (const { name, meaning } of profiles)
      select.append(element('option', { value: name, title: meaning }, `${name}: ${meaning}`));
    select.onchange = () => this.#change('profile', select.value || null);
  }

  #row(setting) {
    const { key } = setting;
    const reset = element('button.reset', { type: 'button', title: `${key} as the scene has it`,
                                            'aria-label': `reset ${key}`,
                                            onclick: () => this.#reset(key) }, '\u21ba');
    const id = `set-${key}`;
    const input = setting.choices ? this.#choice(setting, id) : this.#number(setting, id);
    const row = element('div.setting', {},
      element('label', { htmlFor: id }, key), reset, input.box,
      element('p.meaning', {}, this.#meaning(setting)));
    row.dataset.text = `${key} ${setting.meaning}`.toLowerCase();
    this.#rows.set(key, { row, reset, ...input });
    return row;
  }

  #reset(key) {
    this.#change(key, null);
    if (key === 'bias') this.#change('bias_unit', null);
  }

  #meaning({ unit, choices, least, most, meaning }) {
    const isFar = most > 1e6;
    const range = choices ? '' : isFar ? ` (${unit})` : ` (${unit}, ${least} .. ${most})`;
    return meaning + range;
  }

  #choice({ key, choices }, id) {
    const select = element('select', { id, onchange: () => this.#change(key, select.value) },
                           ...choices.map((name) => element('option', { value: name }, name)));
    return { box: select, put: (value) => assign(select, value) };
  }

  #number(setting, id) {
    if (setting.key === 'bias') return this.#biasInput(setting, id);
    const { key, least, most, fraction_bits: bits } = setting;
    const step = 2 ** -bits;
    const number = element('input', { id, type: 'number', min: least, max: most,
                                      step: bits > 0 ? 'any' : 1 });
    number.onchange = () => this.#change(key, number.value || null);
    if ((most - least) / step > mostSteps)
      return { box: number, put: (value) => assign(number, value) };
    const slider = element('input', { type: 'range', min: least, max: most, step,
                                      'aria-label': key });
    slider.oninput = () => { number.value = slider.value; this.#change(key, slider.value); };
    const put = (value) => { assign(number, value); assign(slider, value); };
    return { box: element('div.ranged', {}, slider, number), put };
  }

  // The bias in its three units at once: each field sets both settings, bias and bias_unit.
  #biasInput(setting, id) {
    const slider = element('input', { id, type: 'range', min: 0, step: 'any' });
    slider.oninput = () => this.#setBias(this.#bias.unit, short(slider.value, 5));
    const fields = units.map((unit) => {
      const field = element('input', { type: 'number', step: 'any',
                                       'aria-label': `bias in ${unit}` });
      field.onchange = () => { if (field.value !== '') this.#setBias(unit, field.value); };
      return field;
    });
    const labelled = fields.map((field, k) => element('label.unit', {}, field, ` ${units[k]}`));
    const put = (value, frame) => {
      const unit = frame.settings.bias_unit, known = frame.bias ?? {};
      // The slider reaches to four times the default bias, which is in a unit of its own.
      const most = known[this.#biasUnit] ? 4 * setting.default * known[unit] / known[this.#biasUnit]
                                         : Number(slider.max);
      this.#bias = { unit };
      slider.max = Math.max(most, value);
      slider.value = value;
      fields.forEach((field, k) => {
        // The unit in use has the setting's own decimal; the others follow from the words.
        field.value = known.quanta === undefined ? ''
          : units[k] === unit ? value : short(known[units[k]], 8);
        field.classList.toggle('in-use', units[k] === unit);
      });
    };
    return { box: element('div.bias', {}, slider, ...labelled), put };
  }

  #setBias(unit, value) {
    if (unit !== this.#bias.unit) this.#change('bias_unit', unit, true);
    this.#change('bias', value);
  }

  #find(text) {
    for (const { row } of this.#rows.values())
      row.hidden = !row.dataset.text.includes(text.trim().toLowerCase());
  }

  // The values of a frame that was drawn; `set` marks those that are not the scene's own.
  show(frame, set) {
    for (const [key, { row, reset, put }] of this.#rows) {
      if (!row.contains(document.activeElement) || document.activeElement.type !== 'number')
        put(frame.settings[key], frame);
      const changed = key in set || (key === 'bias' && 'bias_unit' in set);
      row.classList.toggle('changed', changed);
      reset.hidden = !changed;
    }
    byId('profile').value = set.profile ?? '';
  }
}
