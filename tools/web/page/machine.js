// The machine in WebAssembly: one function, JSON in and JSON out (tools/web/bridge.cpp). A request
// that ends an instance (a C++ exception, a trap) leaves a new one in which nothing is drawn.

const ENOSYS = 52;  // of WASI: what a page has not, files above all

export class Machine {
  #module;
  #exports;
  #files;

  // `bytes` are the module's, `files` a map from a path to its text.
  static async start(bytes, files) {
    const machine = new Machine();
    machine.#module = await WebAssembly.compile(bytes);
    machine.#files = files;
    await machine.restart();
    return machine;
  }

  async restart() {
    const page = { thrown: (at, bytes) => { throw new Error(this.#text(at, bytes)); } };
    const system = new Proxy({}, { get: (_, name) => this.#systemCall(name) });
    const instance = await WebAssembly.instantiate(this.#module,
                                                   { page, wasi_snapshot_preview1: system });
    this.#exports = instance.exports;
    this.#exports._initialize();
    for (const [path, text] of this.#files) this.ask({ do: 'hand_in', path, text });
  }

  // The only call of the system that the machine needs is the clock's, for its milliseconds.
  #systemCall(name) {
    if (name !== 'clock_time_get') return () => ENOSYS;
    return (clock, precision, at) => {
      const nanoseconds = BigInt(Math.round(performance.now() * 1e6));
      new DataView(this.#exports.memory.buffer).setBigUint64(at, nanoseconds, true);
      return 0;
    };
  }

  #text(at, bytes) {
    return new TextDecoder().decode(new Uint8Array(this.#exports.memory.buffer, at, bytes));
  }

  ask(request) {
    const text = new TextEncoder().encode(JSON.stringify(request));
    const room = this.#exports.room(text.length);
    new Uint8Array(this.#exports.memory.buffer, room, text.length).set(text);
    const bytes = this.#exports.ask();
    return JSON.parse(this.#text(this.#exports.answer(), bytes));
  }

  // A copy of the picture's bytes, four a pixel, `by` times smaller each way; null if the frame has
  // no such picture.
  picture(name, by = 1) {
    const { size, at, bytes } = this.ask({ do: 'picture', name, by });
    if (size === 0) return null;
    const inMachine = new Uint8ClampedArray(this.#exports.memory.buffer, at, bytes);
    return { name, size, rgba: inMachine.slice() };
  }
}

// What tools/page has packed: base64 of gzip.
export async function unpacked(base64) {
  const packed = Uint8Array.from(atob(base64.replace(/\s+/g, '')), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Files that follow one another, each after a line "=== path".
export function filesIn(text) {
  const files = new Map();
  for (const part of text.split(/^=== /m).slice(1)) {
    const end = part.indexOf('\n');
    files.set(part.slice(0, end), part.slice(end + 1));
  }
  return files;
}
