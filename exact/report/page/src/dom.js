// Elements made by function calls. Text from files goes through `append`, which makes text nodes of strings: no name
// can become markup.

const svgSpace = 'http://www.w3.org/2000/svg';

function fill(element, attributes, children) {
  for (const [key, value] of Object.entries(attributes ?? {})) {
    if (value === undefined || value === null || value === false) continue;
    if (key.startsWith('on')) element.addEventListener(key.slice(2), value);
    else if (key === 'style') element.style.cssText = value;
    else element.setAttribute(key, value === true ? '' : value);
  }
  element.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false));
  return element;
}

/** h('p', {class: 'note'}, 'text', element…) */
export const h = (tag, attributes, ...children) => fill(document.createElement(tag), attributes, children);

/** The same in SVG. */
export const svg = (tag, attributes, ...children) => fill(document.createElementNS(svgSpace, tag), attributes, children);

export const link = (href, ...children) => h('a', { href }, ...children);
export const code = (text) => h('code', {}, text);

/** A table of rows of cells; a cell is text, an element or {cell, ...attributes}. Numbers are aligned by class `n`. */
export function table(head, rows, attributes = {}) {
  const cellOf = (tag, extra) => (cell) => {
    const known = cell !== null && typeof cell === 'object' && 'cell' in cell;
    const { cell: content, ...rest } = known ? cell : { cell };
    return h(tag, { ...extra, ...rest }, content);
  };
  return h('div', { class: 'wide', tabindex: 0, role: 'region', 'aria-label': attributes.label ?? 'table' },
    h('table', { class: attributes.class },
      head && h('thead', {}, h('tr', {}, head.map(cellOf('th', { scope: 'col' })))),
      h('tbody', {}, rows.map((row) => h('tr', {}, row.map(cellOf('td')))))));
}
