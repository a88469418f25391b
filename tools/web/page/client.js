// The page's end of the worker. Requests are answered in their order; of frames only the newest
// that is asked for is drawn, so that dragging never queues up.

export class Client {
  #worker;
  #waiting = new Map();
  #next = 1;
  #drawing = false;
  #newest = null;

  constructor(workerText) {
    const blob = new Blob([workerText], { type: 'text/javascript' });
    this.#worker = new Worker(URL.createObjectURL(blob));
    this.#worker.onmessage = ({ data: { id, answer } }) => {
      this.#waiting.get(id)?.(answer);
      this.#waiting.delete(id);
    };
    this.#worker.onerror = (event) => {
      for (const answered of this.#waiting.values()) answered({ problem: event.message });
      this.#waiting.clear();
    };
  }

  #send(message) {
    const id = this.#next++;
    return new Promise((resolve) => {
      this.#waiting.set(id, resolve);
      this.#worker.postMessage({ id, ...message });
    });
  }

  start(packed) { return this.#send({ start: packed }); }
  ask(ask) { return this.#send({ ask }); }

  // Calls `drawn` with the answer, unless a newer frame was asked for before this one was begun.
  draw(ask, drawn) {
    this.#newest = { ask, drawn };
    if (!this.#drawing) this.#drawNewest();
  }

  async #drawNewest() {
    this.#drawing = true;
    while (this.#newest) {
      const { ask, drawn } = this.#newest;
      this.#newest = null;
      drawn(await this.ask({ do: 'draw', ...ask }));
    }
    this.#drawing = false;
  }
}
