// Elements made by function calls. Text from files goes through `append`, which makes text nodes of strings: no name
// can become markup.

const svgSpace = 'http://www.w3.org/2000/svg';

function fill(element, attributes, children) {
  for (const [key, value] of Object.entries(attributes ?? {})) {
    if (value === undefined || value === null || value === false) continue;
    if (key.startsWith('on'))
      element.addEventListener(key.slice(2), value);
    else if (key === 'style')
      element.style.cssText = value;
    else
      element.setAttribute(key, value === true ? '' : value);
  }
  element.append(
      ...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false));
  return element;
}

/** h('p', {class: 'note'}, 'text', element…) */
export const h = (tag, attributes, ...children) => fill(document.createElement(tag), attributes, children);

/** The same in SVG. */
export const svg = (tag, attributes, ...children) =>
    fill(document.createElementNS(svgSpace, tag), attributes, children);

export const link = (href, ...children) => h('a', {href}, ...children);
export const code = (text) => h('code', {}, text);

const isCell = (cell) => cell !== null && typeof cell === 'object' && 'cell' in cell;

/**
 * A table of rows of cells; a cell is text, an element or {cell, ...attributes}, numbers being {cell, class: 'n'}. On
 * narrow screens the style sheet stacks the cells of a row and shows their columns' names from `data-label`.
 */
export function table(head, rows, {label = 'table', class: name = ''} = {}) {
  const numeric = (i) => rows.some((row) => isCell(row[i]) && row[i].class?.startsWith('n'));
  const cellOf = (cell, i) => {
    const {cell: content, ...attributes} = isCell(cell) ? cell : {cell};
    return h('td', {'data-label': head[i] || null, ...attributes}, content);
  };
  return h(
      'div', {class: 'wide', tabindex: 0, role: 'region', 'aria-label': label},
      h('table', {class: `${name} ${head.length > 3 ? 'stack' : ''}`},
        h('thead', {},
          h('tr', {},
            head.map(
                (title, i) => (title ? h('th', {scope: 'col', class: numeric(i) ? 'n' : null}, title) : h('td', {}))))),
        h('tbody', {}, rows.map((row) => h('tr', {}, row.map(cellOf))))));
}
