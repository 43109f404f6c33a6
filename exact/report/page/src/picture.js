// Two methods' images of one scene: a slider between them, their difference, zoom to pixels; a differing pixel leads to
// its case. A pixel may differ without a wrong answer, because secondary rays start elsewhere; then it is said so.
import {h, link, table} from './dom.js';
import {grouped} from './figures.js';
import {chooseRun} from './lists.js';
import {report, rows, runsOf} from './report.js';
import {note, to} from './route.js';
import {Viewer} from './viewer.js';

const reasons = {
  face: 'an answer differs: a case',
  order: 'only which hit is first differs',
  start: 'only the start of a secondary ray differs: no answer is wrong',
  unexamined: 'not examined',
};
/** More frames than these would hide the picture, so they are off at first. */
const fewFrames = 200;

const loaded = (entry) => new Promise((resolve) => {
  const image = new Image();
  image.onload = () => resolve(image);
  image.onerror = () => resolve(null);
  // Only what the program embeds: never an address.
  image.src = entry?.uri?.startsWith('data:image/png;base64,') ? entry.uri : 'data:,';
});

function summaryOf(run, pixels) {
  const {record: {difference}, verdict_pixels: verdict} = run;
  const of = (name) => verdict?.[name] ?? 0;
  const words = [
    [of('method'), `pixels show a wrong answer of ${difference.method}`],
    [of('against'), `pixels show a wrong answer of ${difference.against}`],
    [of('neither'), 'pixels show answers that differ by convention: neither is wrong'],
    [of('order'), 'pixels differ only by which hit is first'],
    [of('start'), 'pixels differ only by the start of a secondary ray: nobody is wrong there'],
    [of('unexamined'), 'pixels were not examined'],
  ].filter(([n]) => n > 0);
  if (pixels.length === 0 && words.length === 0)
    return h(
        'p', {class: 'lead'},
        'No pixel differs. That clears this picture and not the method: its rays met none of the cases in which it is wrong.');
  return h(
      'ul', {class: 'plain lead'},
      words.map(
          ([n, text]) =>
              h('li', {}, h('b', {}, grouped(n)),
                ` ${
                    n === 1 ? text.replace('pixels show', 'pixel shows')
                                  .replace('pixels differ', 'pixel differs')
                                  .replace('pixels were', 'pixel was') :
                              text}`)));
}

export function picturePage(path, query) {
  const runs = runsOf('render');
  const run = runs.find(({index}) => index === Number(path[1])) ?? runs[0];
  if (!run) return h('p', {}, 'No pictures are in this report.');
  const {record} = run;
  const pixels = rows(record.pixels);
  const {method, against} = record.difference ?? {};
  return [
    h('h1', {}, method && against ? `${method} against ${against}` : run.title),
    record.scene &&
        h('p', {class: 'crumbs'}, `${record.scene}, ${record.width} × ${record.height} pixels, ${record.fmt}`),
    chooseRun(runs, run.index, 'picture'),
    summaryOf(run, pixels),
    viewerOf(record, run.images ?? {}, pixels, query, method, against),
    pixels.length > 0 && pixelTable(pixels),
  ];
}

function viewerOf(record, numbers, pixels, query, method, against) {
  const canvas = h('canvas', {
    class: 'picture',
    tabindex: 0,
    role: 'img',
    style: `aspect-ratio:${record.width}/${record.height}`,
    'aria-label': `${method} on the left, ${
        against} on the right. Arrow keys pan, plus and minus zoom, n and p go to the next and the previous differing pixel, Enter opens its case.`,
  });
  const viewer = new Viewer(canvas, record, pixels);
  const told =
      h('p', {class: 'detail', role: 'status'},
        pixels.length ? 'Click a differing pixel, or press n in the picture, for its case.' : ' ');
  const slider = h('input', {
    type: 'range',
    id: 'split',
    min: 0,
    max: 100,
    value: 50,
    oninput: () => {
      viewer.split = slider.value / 100;
      viewer.draw();
    }
  });
  const modes = [
    ['slider', 'both'], ['method', method], ['against', against], ['difference', 'difference'],
    ['tests', 'cost in tests'], ['stages', 'stages']
  ].filter(([name]) => name === 'slider' || numbers[name] !== null && numbers[name] !== undefined);
  const chooser =
      h('select', {
        id: 'mode',
        onchange: () => {
          viewer.mode = chooser.value;
          slider.disabled = chooser.value !== 'slider';
          note({mode: chooser.value});
          viewer.draw();
        }
      },
        modes.map(([name, words]) => h('option', {value: name}, words)));

  function choose(pixel) {
    viewer.chosen = pixel;
    viewer.centre = [pixel.x + 0.5, pixel.y + 0.5];
    note({pixel: pixels.indexOf(pixel)});
    const caseLink = pixel.case !== null && pixel.case !== undefined ? link(to('case', pixel.case), 'open its case') :
                                                                       'no case of it is in this report';
    told.replaceChildren(
        h('b', {}, `pixel ${pixel.x}, ${pixel.y}: `),
        `${reasons[pixel.why] ?? pixel.why}; parted on a ${pixel.parted_on} ray. `,
        ...(pixel.why === 'face' ? [caseLink] : []));
    viewer.draw();
  }
  const zoomTo = (zoom) => {
    viewer.zoom = Math.min(64, Math.max(1, zoom));
    note({zoom: viewer.zoom});
    viewer.draw();
  };
  const pan = (dx, dy) => {
    viewer.centre = [viewer.centre[0] + dx * 40 / viewer.scale, viewer.centre[1] + dy * 40 / viewer.scale];
    viewer.draw();
  };
  const next = (step) => {
    if (pixels.length) {
      if (viewer.zoom < 8) viewer.zoom = 8;
      choose(pixels[(pixels.indexOf(viewer.chosen) + step + pixels.length) % pixels.length]);
    }
  };
  const open = () => {
    const {chosen} = viewer;
    if (chosen && chosen.case !== null && chosen.case !== undefined) location.hash = to('case', chosen.case);
  };
  const keys = {
    ArrowLeft: () => pan(-1, 0),
    ArrowRight: () => pan(1, 0),
    ArrowUp: () => pan(0, -1),
    ArrowDown: () => pan(0, 1),
    '+': () => zoomTo(viewer.zoom * 2),
    '=': () => zoomTo(viewer.zoom * 2),
    '-': () => zoomTo(viewer.zoom / 2),
    0: () => zoomTo(1),
    n: () => next(1),
    p: () => next(-1),
    Enter: open,
  };
  canvas.addEventListener('keydown', (event) => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    keys[event.key]();
  });
  let dragged = 0;
  canvas.addEventListener('pointerdown', (event) => {
    dragged = 0;
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!canvas.hasPointerCapture(event.pointerId)) return;
    dragged += Math.abs(event.movementX) + Math.abs(event.movementY);
    viewer.centre =
        [viewer.centre[0] - event.movementX / viewer.scale, viewer.centre[1] - event.movementY / viewer.scale];
    viewer.draw();
  });
  canvas.addEventListener('click', (event) => {
    if (dragged > 4) return;
    const found = viewer.nearest(event.offsetX, event.offsetY);
    if (!found) return;
    if (found === viewer.chosen)
      open();
    else
      choose(found);
  });
  canvas.addEventListener('wheel', (event) => {
    if (document.activeElement !== canvas) return;
    event.preventDefault();
    zoomTo(viewer.zoom * (event.deltaY < 0 ? 1.25 : 0.8));
  }, {passive: false});

  const names = ['method', 'against', 'difference', 'tests', 'stages'];
  Promise.all(names.map((name) => loaded(report.images[numbers[name]]))).then((images) => {
    viewer.images = Object.fromEntries(names.map((name, i) => [name, images[i]]));
    viewer.zoom = Math.min(64, Math.max(1, Number(query.get('zoom')) || 1));
    if (modes.some(([name]) => name === query.get('mode'))) chooser.value = viewer.mode = query.get('mode');
    canvas.dataset.ready = 'true';
    const chosen = pixels[Number(query.get('pixel') ?? -1)];
    if (chosen)
      choose(chosen);
    else
      viewer.draw();
    new ResizeObserver(() => viewer.draw()).observe(canvas);
  });
  const button = (name, title, action) => h('button', {type: 'button', title, onclick: action}, name);
  viewer.marked = pixels.length <= fewFrames;
  const frames = h('input', {
    type: 'checkbox',
    id: 'frames',
    checked: viewer.marked,
    onchange: () => {
      viewer.marked = frames.checked;
      viewer.draw();
    }
  });
  return h(
      'figure', {class: 'picture-box'},
      h('div', {class: 'controls'},
        h('label',
          { for: 'mode'
          },
          'show '),
        chooser,
        h('span', {class: 'group'}, button('−', 'zoom out (key −)', () => zoomTo(viewer.zoom / 2)),
          button('+', 'zoom in (key +)', () => zoomTo(viewer.zoom * 2)),
          button('whole', 'the whole picture (key 0)', () => zoomTo(1))),
        h('span', {class: 'group'}, button('‹ differing', 'the differing pixel before (key p)', () => next(-1)),
          button('differing ›', 'the next differing pixel (key n)', () => next(1))),
        h('span', {}, frames,
          h('label',
            { for: 'frames'
            },
            ` frames around the ${grouped(pixels.length)} differing pixels`))),
      canvas, h('div', {class: 'controls split'}, h('label', { for: 'split'
                }, h('span', {}, `◀ ${method}`), h('span', {}, `${against} ▶`)), slider), told);
}

function pixelTable(pixels) {
  const shown = pixels.slice(0, 200);
  return h(
      'details', {}, h('summary', {}, `The ${grouped(pixels.length)} differing pixels as a table`),
      table(
          ['pixel', 'colour', 'parted on', 'why', 'case'],
          shown.map(
              (pixel) =>
                  [`${pixel.x}, ${pixel.y}`, pixel.colour ? 'another' : 'the same', pixel.parted_on,
                   reasons[pixel.why] ?? pixel.why,
                   pixel.case !== null && pixel.case !== undefined ? link(to('case', pixel.case), 'case') : '–']),
          {label: 'differing pixels'}),
      shown.length < pixels.length && h('p', {class: 'note'}, `The first ${shown.length}.`));
}
