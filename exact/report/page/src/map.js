// Failure maps: every pixel is an answer, and a case that can be opened.
import {casePage} from './caseview.js';
import {h, link} from './dom.js';
import {mapPixelCommand} from './emit.js';
import {toDouble, toHex} from './exact.js';
import {grouped} from './figures.js';
import {chooseRun} from './lists.js';
import {report, runsOf} from './report.js';
import {to} from './route.js';

const meanings = {
  H: 'right: hit',
  M: 'right: miss',
  '+': 'false hit',
  '-': 'false miss',
  c: 'wrong contact',
  x: 'fault',
  '?': 'refused',
  ' ': 'not owed'
};
const names = {
  H: 'hit',
  M: 'miss',
  '+': 'false-hit',
  '-': 'false-miss',
  c: 'contact',
  x: 'fault',
  '?': 'refused',
  ' ': 'none'
};

const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const channels = (letter) => css(`--map-${names[letter] ?? 'none'}`).match(/[\da-f]{2}/gi).map((x) => parseInt(x, 16));

function paint(canvas, panel, size) {
  canvas.width = canvas.height = size;
  const context = canvas.getContext('2d');
  const image = context.createImageData(size, size);
  const colours = Object.fromEntries(Object.keys(names).map((letter) => [letter, channels(letter)]));
  panel.pixels.forEach((row, y) => {
    for (let x = 0; x < size; ++x) {
      const [r, g, b] = colours[row[x]] ?? colours[' '];
      image.data.set([r, g, b, 255], 4 * ((size - 1 - y) * size + x));
    }
  });
  context.putImageData(image, 0, 0);
}

function panelView(run, index) {
  const {record} = run;
  const panel = record.panels[index];
  const {size} = record;
  const canvas = h('canvas', {
    class: 'map',
    tabindex: 0,
    role: 'img',
    'aria-label': `Map of ${panel.method}. Arrow keys move the pixel, with Shift by ten; Enter opens its case.`
  });
  const cursor = h('i', {class: 'cursor', 'aria-hidden': 'true', hidden: true});
  const told = h('span', {role: 'status'}, ' ');
  let at = [Math.floor(size / 2), Math.floor(size / 2)];

  function say(x, y) {
    at = [x, y];
    const [dx, dy] = at.map((v) => v - Math.floor(size / 2));
    told.textContent =
        `${dx >= 0 ? '+' : ''}${dx}, ${dy >= 0 ? '+' : ''}${dy} units: ${meanings[panel.pixels[y]?.[x]] ?? ''}`;
    cursor.hidden = false;
    cursor.style.cssText =
        `left:${(100 * x) / size}%;bottom:${(100 * y) / size}%;width:${100 / size}%;height:${100 / size}%`;
  }
  const placeOf = (event) => {
    const box = canvas.getBoundingClientRect();
    const inside = (v) => Math.min(size - 1, Math.max(0, Math.floor(v * size)));
    return [inside((event.clientX - box.left) / box.width), inside(1 - (event.clientY - box.top) / box.height)];
  };
  const open = () => {
    location.hash = to('pixel', run.index, index, ...at);
  };
  canvas.addEventListener('pointermove', (event) => say(...placeOf(event)));
  canvas.addEventListener('click', (event) => {
    say(...placeOf(event));
    open();
  });
  canvas.addEventListener('focus', () => say(...at));
  canvas.addEventListener('keydown', (event) => {
    const step = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
    if (event.key === 'Enter')
      open();
    else if (step)
      say(...at.map((v, i) => Math.min(size - 1, Math.max(0, v + step[i] * (event.shiftKey ? 10 : 1)))));
    else
      return;
    event.preventDefault();
  });
  requestAnimationFrame(() => paint(canvas, panel, size));
  const wrong =
      ['false hit', 'false miss', 'wrong contact', 'fault'].reduce((sum, name) => sum + (panel.counts[name] ?? 0), 0);
  return h(
      'figure', {class: 'panel'}, h('h2', {}, panel.method, ' ', h('small', {}, panel.fmt)),
      h('p', {},
        wrong === 0 ? `nothing wrong in ${grouped(size * size)} pixels` :
                      `${grouped(wrong)} of ${grouped(size * size)} pixels wrong`),
      h('div', {class: 'map-frame'}, canvas, cursor), h('figcaption', {}, told));
}

export function mapPage(path) {
  const runs = runsOf('map');
  const run = runs.find(({index}) => index === Number(path[1])) ?? runs[0];
  if (!run) return h('p', {}, 'No failure map is in this report.');
  const used = new Set(run.record.panels.flatMap((panel) => panel.pixels.flatMap((row) => [...row])));
  return [
    h('h1', {}, `Failure map: ${run.record.map}${run.record.probe === 'ray' ? ', rays' : ''}`),
    h('p', {class: 'lead'},
      `In the middle ${
          run.record
              .about}. A pixel moves x and y of the probe’s first point by one unit in the last place; each is a case.`),
    chooseRun(runs, run.index, 'map'),
    h('p', {class: 'legend'},
      Object.entries(meanings)
          .filter(([letter]) => used.has(letter))
          .map(
              ([letter, words]) =>
                  h('span', {},
                    h('i', {class: 'swatch', 'aria-hidden': 'true', style: `background:var(--map-${names[letter]})`}),
                    words))),
    h('div', {class: 'panels'}, run.record.panels.map((_, i) => panelView(run, i))),
    !run.record.base &&
        h('p', {class: 'note'}, 'This map does not say where its contact is, so its pixels cannot be opened.'),
  ];
}

/** The case of a pixel, exactly as the program makes it. */
function caseOfPixel(record, fmt, x, y) {
  const {seg, ray, tri} = record.base[fmt];
  const unit = toDouble(record.unit[fmt]);
  const middle = Math.floor(record.size / 2);
  const [px, py, pz] = (ray?.o ?? seg[0]).map(toDouble);
  const moved = [px + (x - middle) * unit, py + (y - middle) * unit, pz];
  const source = moved.map(toHex);
  const probe = ray ? {ray: {...ray, o: source}} : {seg: [source, seg[1]]};
  return {id: `map-${record.map}-${fmt}-${x}-${y}`, fmt, ...probe, tri};
}

export function pixelPage(path, query) {
  const [index, panelIndex, x, y] = path.slice(1).map(Number);
  const run = report.runs[index];
  const panel = run?.record?.panels?.[panelIndex];
  const answer = panel?.pixels[y]?.[x];
  if (answer === undefined || !run.record.base?.[panel.fmt])
    return h('p', {}, 'There is no such pixel, or the map does not say where its contact is.');
  const data = caseOfPixel(run.record, panel.fmt, x, y);
  const hit = run.record.truth[panel.fmt][y][x] === 'h' ? 1 : 0;
  const wrong = '+-cx'.includes(answer);
  const entry = {
    case: {...data, expect: hit},
    method: panel.method,
    outcome: wrong ? meanings[answer] : null,
    truth: {hit},
    in_words: wrong ? 'The exact answer of the closed point sets is ' + (hit ? 'a hit' : 'no hit') : null,
    replay: `${mapPixelCommand(run.record, panel.method, x, y)} | tribunal replay -`,
  };
  const step = (dx, dy, name) =>
      (panel.pixels[y + dy]?.[x + dx] === undefined ?
           null :
           link(to('pixel', index, panelIndex, x + dx, y + dy, Object.fromEntries(query)), name));
  return casePage(entry, Object.fromEntries(query), [
    h('p', {class: 'crumbs'}, link(to('map', index), `map ${run.record.map}`), ` › ${panel.method}, pixel ${x}, ${y} `,
      h('span', {class: 'steps'}, step(-1, 0, '←'), ' ', step(1, 0, '→'), ' ', step(0, 1, '↑'), ' ', step(0, -1, '↓'))),
    !wrong && h('p', {class: 'lead'}, `${panel.method} is right: ${meanings[answer]}.`)
  ]);
}
