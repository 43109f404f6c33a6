// The 3D view with its controls: what to look at, how far to zoom, turning by pointer and keys. The zoom is the binary
// logarithm of the window's half width, so that its slider runs evenly from the whole case to a window far below an
// ulp.
import {h} from './dom.js';
import {isZero, logOf, minus} from './exact.js';
import {significant, superscript} from './figures.js';
import {unitOf} from './lens.js';
import {crossingOf, edgesOf, focusOf, logDistance, nearestOnLine, nearestOnProbe, normalOf, placeOf} from './question.js';
import {ulp} from './rounded.js';
import {note} from './route.js';
import {half, View3D} from './view3d.js';

let current = null;

/** Frees what the last view drew. */
export function leaveStage() {
  current?.clear();
  current = null;
}

const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const palette = () => ({target: css('--target'), probe: css('--probe'), ink: css('--ink'), card: css('--card')});

/** Named places to look at. */
function placesOf(question) {
  const {p, q, rings} = question.exact;
  const crossing = crossingOf(question);
  const named = [[crossing ? 'where line and plane cross' : 'the nearest approach', focusOf(question)]];
  named.push([question.isRay ? 'o, the origin' : 'p', placeOf(p)]);
  if (!question.isRay) named.push(['q', placeOf(q)]);
  rings.flat().slice(0, 12).forEach(
      (point, i) => named.push([question.isPolygon ? `vertex ${i}` : 'abc'[i], placeOf(point)]));
  return named;
}

/** log2 of the sizes that a zoom can go to: the whole, the target, one ulp, the smallest gap that is not zero. */
function sizesOf(question, focus) {
  const {p, q, rings, unit} = {...question.exact, p: placeOf(question.exact.p)};
  const ends = [...rings.flat().map(placeOf), p, ...(question.isRay ? [] : [placeOf(q)])];
  const far = Math.max(...ends.map((place) => logDistance(question, place, focus)));
  const whole = Number.isFinite(far) ? far : logOf(1n, 1n, unit);
  const near = Math.max(...rings.flat().map((point) => logDistance(question, placeOf(point), focus)));
  const numbers = [question.p, ...(question.isRay ? [] : [question.q]), ...question.rings.flat()].flat();
  const largest = Math.max(...numbers.map(Math.abs));
  const oneUlp = Math.log2(ulp(largest, question.format));
  const gaps = [
    ...edgesOf(question).map(([from, to]) => logDistance(question, focus, nearestOnLine(from, minus(to, from), focus))),
    ...ends.map((place) => logDistance(question, focus, place)),
    logDistance(question, focus, nearestOnProbe(question, focus)),
  ].filter(Number.isFinite);
  const gap = gaps.length ? Math.min(...gaps) : oneUlp;
  return {
    whole: whole + 0.15,
    target: (Number.isFinite(near) ? near : whole) + 0.25,
    ulp: oneUlp - 1,
    gap: gap + 0.6,
    least: Math.min(oneUlp - 4, gap - 2),
    unitUlp: oneUlp
  };
}

/** The whole, unless the target would be a dot in it. */
const firstSize = (sizes) => (sizes.whole - sizes.target > 3 ? sizes.target : sizes.whole);

/** How far, in doublings, a zoom may be from a size that fills the picture before the focus is in the middle. */
const slack = 1.5;

/** Places that fill the picture at a zoom, and how much they count: at the whole all of them, at the target its own. */
function fitOf(question, sizes, size) {
  const {p, q, rings} = question.exact;
  const target = rings.flat().map(placeOf);
  const all = [...target, placeOf(p), ...(question.isRay ? [] : [placeOf(q)])];
  const near = (mark) => Math.max(0, 1 - Math.abs(size - mark) / slack);
  const [places, weight] = near(sizes.whole) > 0 || firstSize(sizes) === sizes.whole ? [all, near(sizes.whole)] :
                                                                                       [target, near(sizes.target)];
  return {places, weight};
}

const power = (size) => (Math.abs(size) < 10 ? significant(2 ** size) : `2${superscript(Math.round(size))}`);

/** A length of 2^size in words: in units of the coordinates, and in ulps of the largest of them. */
function lengthInWords(size, unitUlp) {
  const ulps = size - unitUlp;
  const decimal = Math.abs(size) < 1000 ? significant(2 ** size) : power(size);
  return `${decimal} = ${Math.abs(ulps) < 20 ? significant(2 ** ulps) : `2${superscript(Math.round(ulps))}`} ulp`;
}

/**
 * The stage as an element. `hit`: whether the probe meets the target, if that is known. `state` has `zoom` (a number
 * or a name) and `at` (which place), from the fragment.
 */
export function stage(question, state, hit) {
  leaveStage();
  if (!question.finite)
    return h('p', {class: 'note'}, 'Some coordinate is not a finite number: there is nothing to draw.');
  const canvas = h('canvas', {
    class: 'stage',
    tabindex: 0,
    role: 'img',
    'aria-label':
        'The case in 3D. Arrow keys turn it, plus and minus zoom, 0 shows the whole, t the target, u one ulp, g the smallest gap.',
  });
  const labels = h('div', {class: 'labels', 'aria-hidden': 'true'});
  let view;
  try {
    view = new View3D(canvas, labels, palette);
  } catch {
    return h('p', {class: 'note'}, 'This browser draws no WebGL, so there is no 3D view; all else is here.');
  }
  current = view;
  const normal = normalOf(question);
  const {direction} = question.exact;
  view.face(isZero(normal) ? null : unitOf(normal), isZero(direction) ? [0, 0, 0] : unitOf(direction));
  return controls(question, state, hit, {canvas, labels, view});
}

/** A legend of what the view marks. */
function whatIsMarked(question, crossing, hit) {
  if (!crossing) return null;
  const plane = question.isPolygon ? 'the polygon’s plane' : 'the triangle’s plane';
  const where = `where the probe’s line crosses ${plane}`;
  const known = hit !== null && hit !== undefined;
  return h(
      'span', {class: 'marked'},
      hit ? `The ring is ${where}: they meet there.` :
          known ? `The broken ring is ${where}: they do not meet.` :
                  `The broken ring is ${where}.`);
}

function controls(question, state, hit, {canvas, labels, view}) {
  const places = placesOf(question);
  const crossing = crossingOf(question);
  let at = Math.min(Math.max(0, Number(state.at) || 0), places.length - 1);
  let sizes = sizesOf(question, places[at][1]);
  let size = sizes[state.zoom] ??
      (state.zoom !== undefined && Number.isFinite(Number(state.zoom)) ? Number(state.zoom) : firstSize(sizes));

  const slider = h('input', {type: 'range', id: 'zoom', step: 'any', oninput: () => zoomTo(-Number(slider.value))});
  const scale = h('output', { for: 'zoom', class: 'scale' });
    const chooser =
        h('select', {id: 'focus', onchange: () => lookAt(Number(chooser.value))},
          places.map(([name], i) => h('option', {value: i, selected: i === at}, name)));

    function draw() {
      const fit = at === 0 ? fitOf(question, sizes, size) : {places: [], weight: 0};
      view.show(question, places[at][1], size, {crossing, hit: Boolean(hit), fit});
      slider.min = -sizes.whole - 1;
      slider.max = -sizes.least;
      slider.value = -size;
      slider.setAttribute('aria-valuetext', `half width ${lengthInWords(size, sizes.unitUlp)}`);
      const shown = size + Math.log2((view.halfHeight ?? half) / half);
      scale.textContent = `from the middle to the edge: ${lengthInWords(shown, sizes.unitUlp)}`;
    }
    function zoomTo(next) {
      size = Math.min(sizes.whole + 1, Math.max(sizes.least, next));
      note({zoom: size.toFixed(2)});
      draw();
    }
    function lookAt(next) {
      at = next;
      sizes = sizesOf(question, places[at][1]);
      note({at});
      zoomTo(size);
    }

    const keys = {
      ArrowLeft: () => view.turn(-0.12, 0),
      ArrowRight: () => view.turn(0.12, 0),
      ArrowUp: () => view.turn(0, 0.1),
      ArrowDown: () => view.turn(0, -0.1),
      '+': () => zoomTo(size - 1),
      '=': () => zoomTo(size - 1),
      '-': () => zoomTo(size + 1),
      0: () => zoomTo(sizes.whole),
      t: () => zoomTo(sizes.target),
      u: () => zoomTo(sizes.ulp),
      g: () => zoomTo(sizes.gap),
    };
    canvas.addEventListener('keydown', (event) => {
      const action = event.ctrlKey || event.metaKey || event.altKey ? null : keys[event.key];
      if (!action) return;
      event.preventDefault();
      action();
    });
    canvas.addEventListener('pointerdown', (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener('pointermove', (event) => {
      if (canvas.hasPointerCapture(event.pointerId)) view.turn(-event.movementX * 0.01, event.movementY * 0.01);
    });
    // A wheel scrolls the page unless the view has the focus.
    canvas.addEventListener('wheel', (event) => {
      if (document.activeElement !== canvas) return;
      event.preventDefault();
      zoomTo(size + Math.sign(event.deltaY) * 0.5);
    }, {passive: false});

    const observer = new ResizeObserver(() => view === current && view.render());
    observer.observe(canvas);
    requestAnimationFrame(() => view === current && draw());
    const button = (name, title, target) =>
        h('button', {type: 'button', title, onclick: () => zoomTo(sizes[target])}, name);
    return h(
        'figure', {class: 'stage-box'}, h('div', {class: 'stage-frame'}, canvas, labels),
        h('div', {class: 'controls'},
          h('label',
            { for: 'focus'
            },
            'look at '),
          chooser,
          h('span', {class: 'group'}, button('whole', 'the whole case (key 0)', 'whole'),
            button(question.isPolygon ? 'polygon' : 'triangle', 'the target alone (key t)', 'target'),
            button('one ulp', 'one unit in the last place of the largest coordinate from edge to edge (key u)', 'ulp'),
            button('the gap', 'the smallest distance from the place looked at that is not zero (key g)', 'gap'))),
        h('div', {class: 'controls'}, h('label', { for: 'zoom'
          }, 'zoom '), slider), h('figcaption', {}, scale, whatIsMarked(question, crossing, hit)));
}

/** Colours may have changed with the scheme. */
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => dispatchEvent(new HashChangeEvent('hashchange')));
