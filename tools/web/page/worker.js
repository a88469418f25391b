// The worker: it has the machine, so that the page never waits for it. A message {id, ask} is
// answered by {id, answer} or {id, problem}; {id, start} comes first.
import { Machine, filesIn, unpacked } from './machine.js';

let machine = null;
let lastDraw = null;

async function start({ wasm, held }) {
  const files = filesIn(new TextDecoder().decode(await unpacked(held)));
  machine = await Machine.start(await unpacked(wasm), files);
  return { table: machine.ask({ do: 'table' }), presets: machine.ask({ do: 'presets' }),
           goldens: files.get('goldens'), scenes: [...files.keys()] };
}

const tileShare = 4;  // tiles of a frame that is dragged are so many times smaller each way

function pictures(names, by = 1) {
  return names.map((name) => machine.picture(name, by)).filter((picture) => picture !== null);
}

function answerTo(ask) {
  if (ask.do === 'pictures') return pictures(ask.names);
  if (ask.do === 'draw') lastDraw = ask;
  const began = performance.now();
  const answer = machine.ask(ask);
  if (ask.do !== 'draw' || answer.problem) return answer;
  answer.pictures = pictures(ask.names);
  answer.tiles = pictures(ask.tiles ?? [], tileShare);
  answer.frame_ms = performance.now() - began;
  return answer;
}

// After what ended the machine: a new one, with the frame as it was unless that was the reason.
async function recover(ask, error) {
  await machine.restart();
  if (ask.do !== 'draw' && lastDraw) machine.ask(lastDraw);
  return { problem: error.message };
}

async function reply({ data: { id, ask, start: first } }) {
  let answer;
  try {
    answer = first ? await start(first) : answerTo(ask);
  } catch (error) {
    answer = machine ? await recover(ask, error) : { problem: error.message };
  }
  const drawn = Array.isArray(answer) ? answer
                                      : [...answer.pictures ?? [], ...answer.tiles ?? []];
  postMessage({ id, answer }, drawn.map((picture) => picture.rgba.buffer));
}

// One after the other: a message waits until the one before it is answered.
let queue = Promise.resolve();
onmessage = (message) => { queue = queue.then(() => reply(message)); };
