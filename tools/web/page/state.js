// What the page shows, as one value, and as the address's part after '#', by which it is shared.
//
//   {scene, text, set, show, pixel, other, wipe}
//   scene  a file of the page's list; text: a pasted scene in its place, or null
//   set    {key: value}: what differs from the scene, as --set takes it
//   show   the picture on the stage; pixel: [x, y] that is followed, or null
//   other  {scene, text, set} on the left of the wipe, or null; wipe: 0 .. 1

const pageKeys = ['scene', 'text', 'show', 'pixel', 'wipe', 'other'];
const longestText = 6000;  // that an address can be expected to carry

export const firstState = {
  scene: 'figures.toml', text: null, set: {}, show: 'picture', pixel: null, other: null, wipe: 0.5,
};

// Whether a link can carry all of it.
export const fitsAddress = ({ text }) => text === null || text.length <= longestText;

function sceneFields({ scene, text, set }) {
  const fields = new URLSearchParams({ scene });
  if (text !== null && text.length <= longestText) fields.set('text', text);
  for (const [key, value] of Object.entries(set)) fields.set(key, value);
  return fields;
}

function readScene(fields) {
  const set = {};
  for (const [key, value] of fields) if (!pageKeys.includes(key)) set[key] = value;
  return { scene: fields.get('scene') ?? firstState.scene, text: fields.get('text'), set };
}

export function toHash(state) {
  const fields = sceneFields(state);
  fields.set('show', state.show);
  if (state.pixel) fields.set('pixel', state.pixel.join(','));
  if (state.other) {
    fields.set('other', sceneFields(state.other).toString());
    fields.set('wipe', String(Math.round(state.wipe * 100) / 100));
  }
  return '#' + fields.toString().replaceAll('%2C', ',');
}

export function fromHash(hash) {
  const fields = new URLSearchParams(hash.replace(/^#/, ''));
  const state = { ...firstState, ...readScene(fields) };
  state.show = fields.get('show') ?? firstState.show;
  const pixel = (fields.get('pixel') ?? '').split(',').map(Number);
  state.pixel = pixel.length === 2 && pixel.every(Number.isInteger) ? pixel : null;
  if (fields.get('other')) state.other = readScene(new URLSearchParams(fields.get('other')));
  const wipe = Number(fields.get('wipe') ?? firstState.wipe);
  state.wipe = wipe >= 0 && wipe <= 1 ? wipe : firstState.wipe;
  return state;
}

// The overrides as the program takes them.
export const overrides = (set) => Object.entries(set).map(([key, value]) => `${key}=${value}`);

export function fromPreset(preset) {
  const set = {};
  for (const each of preset.set) {
    const equals = each.indexOf('=');
    set[each.slice(0, equals)] = each.slice(equals + 1);
  }
  return { ...firstState, scene: preset.scene, set, show: preset.plane };
}

const sorted = (set) => JSON.stringify(Object.entries(set).sort());

export function isPreset(state, preset) {
  return state.text === null && state.scene === preset.scene &&
         sorted(state.set) === sorted(fromPreset(preset).set);
}

// The command that draws the same: what a person types who wants it from the program.
export function commandOf(state) {
  const scene = state.text === null ? `tools/scenes/${state.scene}` : 'scene.toml';
  return ['umbra78 render', scene, ...overrides(state.set).map((each) => `--set '${each}'`)]
    .join(' ');
}
