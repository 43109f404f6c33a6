// A heat matrix that is read by eye, pointer and keys: a table with one stop for the Tab key, in which arrows move.
// A cell's shade has seven steps, so that steps and not tones are compared, and its figure stands in it where it fits.
import {h} from './dom.js';

const steps = [0.0001, 0.001, 0.01, 0.03, 0.1, 0.3];

/** 0: nothing wrong; 1 to 7: more and more; −1: nobody was asked. */
export function heatStep(share, n) {
  if (!n) return -1;
  if (share === 0) return 0;
  return 1 + steps.filter((bound) => share >= bound).length;
}

const short = (share) =>
    (share === 0        ? '0' :
         share < 0.0001 ? '<.01' :
         share < 0.01   ? (100 * share).toFixed(2).replace(/^0/, '') :
                          (100 * share).toFixed(share < 0.0995 ? 1 : 0));

/** What the shades mean. */
export function legend() {
  const names = ['0', '< 0.01 %', '< 0.1 %', '< 1 %', '< 3 %', '< 10 %', '< 30 %', 'more'];
  return h(
      'p', {class: 'legend'}, 'wrong: ',
      names.map(
          (name, i) =>
              h('span', {}, h('i', {class: `heat heat-${i}`, 'aria-hidden': 'true'}, i === 0 ? '0' : ''), name)),
      h('span', {}, h('i', {class: 'heat heat-none', 'aria-hidden': 'true'}, '·'), 'not asked'));
}

/**
 * rows, columns: [{name, label, title}]; cellOf(row, column): {share, n, words, href} or null. Figures are in percent.
 * `describe` is an element that says what the present cell is.
 */
export function heatGrid({rows, columns, cellOf, corner, label, compact}) {
  const detail =
      h('p', {class: 'detail', role: 'status'},
        'Point at a cell, or use the arrow keys, for its figures; a click or Enter goes to its cases.');
  const cells = rows.map(() => []);
  let here = [0, 0];

  function say(r, c) {
    const cell = cells[r][c].told;
    detail.replaceChildren(
        h('b', {}, `${rows[r].name} × ${columns[c].name}: `), cell ? cell.words : 'nobody was asked');
  }
  function move(r, c) {
    if (!cells[r]?.[c]) return;
    cells[here[0]][here[1]].tabIndex = -1;
    here = [r, c];
    cells[r][c].tabIndex = 0;
    cells[r][c].focus();
  }
  const arrows = {ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1]};
  function onkeydown(event) {
    const step = arrows[event.key];
    if (step)
      move(here[0] + step[0], here[1] + step[1]);
    else if (event.key === 'Home')
      move(here[0], 0);
    else if (event.key === 'End')
      move(here[0], columns.length - 1);
    else
      return;
    event.preventDefault();
  }

  function make(r, c) {
    const told = cellOf(rows[r].name, columns[c].name);
    const step = told ? heatStep(told.share, told.n) : -1;
    const text = step < 0 ? '·' : short(told.share);
    const control =
        h(told?.href ? 'a' : 'span', {
          href: told?.href,
          class: `heat heat-${step < 0 ? 'none' : step}`,
          tabindex: -1,
          'aria-label':
              `${step < 0 ? 'nobody was asked' : `${text}\u00a0% wrong`}: ${rows[r].name}, ${columns[c].name}`,
          role: told?.href ? null : 'img',
          onfocus: () => {
            here = [r, c];
            say(r, c);
          },
          onpointerenter: () => say(r, c),
        },
          text);
    control.told = told;
    cells[r][c] = control;
    return h('td', {role: 'gridcell'}, control);
  }

  const body = rows.map(
      (row, r) =>
          h('tr', {role: 'row'},
            h('th', {scope: 'row', role: 'rowheader', title: row.title},
              row.href ? h('a', {href: row.href}, row.label ?? row.name) : row.label ?? row.name),
            columns.map((_, c) => make(r, c))));
  if (cells[0]?.[0]) cells[0][0].tabIndex = 0;
  const grid =
      h('table', {
        class: compact ? 'grid compact' : 'grid',
        role: 'grid',
        'aria-label': label,
        style: `max-width:${190 + 110 * columns.length}px`,
        onkeydown
      },
        h('thead', {},
          h('tr', {role: 'row'}, h('th', {role: 'columnheader', class: 'corner'}, corner),
            columns.map(
                (column) =>
                    h('th', {scope: 'col', role: 'columnheader', title: column.title},
                      h('span', {},
                        column.href ? h('a', {href: column.href}, column.label ?? column.name) :
                                      column.label ?? column.name))))),
        h('tbody', {}, body));
  return h('div', {class: 'grid-box'}, detail, grid, legend());
}
