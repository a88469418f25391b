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

function pictures(names) {
  return names.map((name) => machine.picture(name)).filter((picture) => picture !== null);
}

function answerTo(ask) {
  if (ask.do === 'pictures') return pictures(ask.names);
  if (ask.do === 'draw') lastDraw = ask;
  const answer = machine.ask(ask);
  if (ask.do === 'draw' && !answer.problem && ask.names) answer.pictures = pictures(ask.names);
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
  const drawn = Array.isArray(answer) ? answer : answer.pictures ?? [];
  postMessage({ id, answer }, drawn.map((picture) => picture.rgba.buffer));
}

// One after the other: a message waits until the one before it is answered.
let queue = Promise.resolve();
onmessage = (message) => { queue = queue.then(() => reply(message)); };
