// node run_wasm.mjs PROGRAM.wasm FILLER: prints what the program writes.
import {readFileSync} from 'node:fs';

let memory = null;
const text = (at, size) => Buffer.from(memory.buffer, at, size).toString();
const port = {write: (at, size) => process.stdout.write(text(at, size)), show: () => {}};
const {instance} = await WebAssembly.instantiate(readFileSync(process.argv[2]), {port});
memory = instance.exports.memory;
process.exitCode = instance.exports.draw(Number(process.argv[3]));
