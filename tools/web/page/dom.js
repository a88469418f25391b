// Small helpers for making elements.

export const byId = (id) => document.getElementById(id);

// element('p.small', {title: 'x', onclick: f}, 'text', child, ...)
export function element(kind, properties = {}, ...children) {
  const [tag, ...classes] = kind.split('.');
  const made = document.createElement(tag);
  if (classes.length > 0) made.className = classes.join(' ');
  for (const [name, value] of Object.entries(properties)) {
    if (name in made) made[name] = value;
    else made.setAttribute(name, value);
  }
  made.append(...children.filter((child) => child !== null));
  return made;
}

export function paint(canvas, picture) {
  if (canvas.width !== picture.size) canvas.width = canvas.height = picture.size;
  canvas.getContext('2d').putImageData(new ImageData(picture.rgba, picture.size), 0, 0);
}

export const grouped = (n) => n < 10000
  ? String(n) : Math.round(n).toString().replace(/\B(?=(\d{3})+$)/g, '\u2009');
export const percent = (rate) => rate === null || rate === undefined
  ? 'n/a' : `${(100 * rate).toFixed(2)} %`;
// A number with so many significant digits and no trailing zeros.
export const short = (n, digits = 6) => String(Number(Number(n).toPrecision(digits)));
