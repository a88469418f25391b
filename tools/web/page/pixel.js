// One pixel's way: every word, stage by stage, and the light's texels around the place where it was
// looked up.
import { byId, element } from './dom.js';

const radius = 3;

// Where a trace says that the map was read: words "tx", "ty", and "z(367,180)" of each fetch.
export function texelsOf(trace) {
  const word = (name) => trace.words.find((each) => each.word === name)?.decimal;
  const fetched = [];
  for (const { word: name, decimal } of trace.words) {
    const found = /^z\((-?\d+),(-?\d+)\)$/.exec(name ?? '');
    if (found) fetched.push({ x: Number(found[1]), y: Number(found[2]), code: decimal });
  }
  const tx = word('tx') ?? fetched[0]?.x, ty = word('ty') ?? fetched[0]?.y;
  return { at: tx === undefined ? null : [tx, ty], fetched, k: word('k') };
}

function wordRow(line, isNew) {
  const cells = [isNew ? line.part : '', line.cycle ?? '', line.word ?? '', line.decimal ?? '',
                 line.value ?? '', line.format ?? '', line.hex ?? '', line.how ?? ''];
  const row = element('tr', {}, ...cells.map((text) => element('td', {}, String(text))));
  if (isNew) row.className = 'first';
  if (line.cycle !== null) row.dataset.cycle = line.cycle;
  return row;
}

export class PixelPanel {
  show(pixel, trace) {
    byId('pixel-title').textContent = `Pixel ${pixel[0]}, ${pixel[1]}`;
    const body = byId('words');
    body.replaceChildren();
    if (trace.problem) {
      byId('pixel-summary').textContent = trace.problem;
      return;
    }
    byId('pixel-summary').textContent = trace.summary;
    let last = null;
    for (const line of trace.words) {
      body.append(wordRow(line, last === null || last.part !== line.part));
      last = line;
    }
  }

  // The rows of one cycle of the pipeline.
  showCycle(cycle) {
    for (const row of byId('words').rows)
      row.classList.toggle('now', row.dataset.cycle === String(cycle));
  }

  // `around` are the codes of (2 radius + 1)^2 texels; k is the point's own code.
  showTexels({ at, fetched, k }, around) {
    const grid = byId('texels');
    grid.replaceChildren();
    byId('texels-of').textContent = at && around.rows
      ? `The light\u2019s texels around ${at[0]}, ${at[1]}. The point\u2019s code is ` +
        `${k ?? '\u2014'}: a texel with a smaller one is nearer to the light and puts the point ` +
        'in shadow. Framed: what was fetched.'
      : 'This pixel is not looked up in the light\u2019s map.';
    if (!at || !around.rows) return;
    const codes = around.rows.flat().filter((code) => code !== null && code !== around.most);
    const least = Math.min(...codes), range = Math.max(1, Math.max(...codes) - least);
    around.rows.forEach((row, j) => row.forEach((code, i) => {
      const x = at[0] + i - radius, y = at[1] + j - radius;
      const cell = element('div.texel', { title: `texel ${x}, ${y}: ${code ?? 'outside'}` },
                           code === null ? '' : code === around.most ? 'far' : String(code));
      const grey = code === null || code === around.most ? 0
                                                         : 220 - 160 * (code - least) / range;
      cell.style.background = `rgb(${grey} ${grey} ${grey})`;
      cell.style.color = grey > 120 ? '#000' : '#fff';
      cell.classList.toggle('fetched', fetched.some((each) => each.x === x && each.y === y));
      cell.classList.toggle('nearer', code !== null && k !== undefined && code < k);
      grid.append(cell);
    }));
  }

  hide() {
    byId('pixel-title').textContent = 'A pixel\u2019s way';
    byId('pixel-summary').textContent =
      'Click a pixel of the picture, or press Enter on it, to follow it through the machine.';
    byId('words').replaceChildren();
    byId('texels').replaceChildren();
    byId('texels-of').textContent = '';
  }
}

export const texelRequest = ([x, y]) => ({ do: 'around', plane: 'light_z', x, y, radius });
