// Draws the page that the fragment names, and again whenever it changes.
import {atlasPage, classPage} from './atlas.js';
import {numberedCase} from './caseview.js';
import {certificatePage} from './certificate.js';
import {chartPage} from './chart.js';
import {h, link} from './dom.js';
import {leakPage} from './leak.js';
import {leaveLines} from './lines.js';
import {casesPage} from './lists.js';
import {mapPage, pixelPage} from './map.js';
import {cellPage, matrixPage} from './matrix.js';
import {aboutPage, benchPage, compilersPage, relationsPage} from './others.js';
import {overviewPage} from './overview.js';
import {picturePage} from './picture.js';
import {report, runsOf} from './report.js';
import {parse, to} from './route.js';
import {leaveStage} from './stage.js';
import {sweepPage} from './sweep.js';

const has = (...kinds) => kinds.some((kind) => runsOf(kind).length > 0);

/** name, title in the menu, whether there is something to show, the page; a page without a title has no entry. */
const views = [
  ['', 'Overview', () => true, () => overviewPage()],
  ['matrix', 'Where it fails', () => has('fuzz', 'certificate'), matrixPage],
  ['cell', null, null, cellPage],
  ['cases', 'Cases', () => report.cases.length > 0, (_, query) => casesPage(query)],
  ['case', null, null, (path, query) => numberedCase(Number(path[1]), query)],
  ['sweep', 'Sweeps', () => has('sweep'), sweepPage],
  ['map', 'Maps', () => has('map'), mapPage],
  ['pixel', null, null, pixelPage],
  ['chart', 'Cost', () => has('chart'), chartPage],
  ['picture', 'Pictures', () => has('render'), picturePage],
  ['certificate', 'Certificates', () => has('certificate'), certificatePage],
  ['leak', 'Watertight?', () => has('leak'), leakPage],
  ['relations', 'Relations', () => has('relations'), relationsPage],
  ['compilers', 'Compilers', () => has('compilers'), compilersPage],
  ['bench', 'Benchmarks', () => has('bench'), benchPage],
  ['classes', 'Classes', () => report.classes?.length > 0, (_, query) => atlasPage(query)],
  ['class', null, null, (path) => classPage(path[1])],
  ['about', 'About', () => true, () => aboutPage()],
];

/** The entry of the menu under which a page without one stands. */
const parents = {
  cell: 'matrix',
  case: 'cases',
  pixel: 'map',
  class: 'classes'
};

function masthead(current) {
  const entries = views.filter(([, title, shown]) => title && shown());
  return [
    h('p', {class: 'brand'}, link('#/', 'Tribunal'), h('span', {}, (report.directories ?? []).join(' · '))),
    h('nav', {'aria-label': 'views'},
      h('ul', {},
        entries.map(
            ([name, title]) =>
                h('li', {},
                  h('a', {href: name ? to(name) : '#/', 'aria-current': name === current ? 'page' : null}, title))))),
  ];
}

function titleOf(main) {
  return `${main.querySelector('h1')?.textContent ?? 'report'} – Tribunal`;
}

let drawnBefore = false;

function draw() {
  leaveStage();
  leaveLines();
  const {path, query} = parse(location.hash);
  const name = path[0] ?? '';
  const view = views.find(([key]) => key === name);
  const main = document.getElementById('main');
  const children = view ? view[3](path, query) : h('p', {}, 'There is no such page. ', link('#/', 'To the overview'));
  main.replaceChildren(
      ...[children].flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false));
  document.getElementById('masthead').replaceChildren(...masthead(parents[name] ?? name));
  document.title = titleOf(main);
  if (drawnBefore) {
    scrollTo(0, 0);
    main.focus({preventScroll: true});
  }
  drawnBefore = true;
}

document.getElementById('foot').append(
    h('p', {},
      `${report.made_with?.program ?? 'tribunal'} ${
          report.made_with?.revision ?? ''}. Its figures speak of the cases that were asked, and of no others.`));
addEventListener('hashchange', draw);
draw();
