#!/usr/bin/env python3
"""browser_test.py REPORT HOSTILE: uses two reports as a person would, by pointer and keys, in a headless browser.

Needs Debian's chromium, chromium-driver and python3-selenium, and `tribunal` in the path.
"""
import json
import subprocess
import sys
import time

from selenium.webdriver.common.keys import Keys

from browser import Page

GLYPHS = {'+': 1, '0': 0, '−': -1, 'NaN': 0}  # naive tests read NaN as zero


def check(truth, what):
    if not truth:
        raise AssertionError(what)


def replay(text, expected_words):
    """`tribunal replay` accepts the case; what it says."""
    done = subprocess.run(['tribunal', 'replay', '-'], input=text, capture_output=True, text=True, check=False)
    check(done.returncode in (0, 1), f'replay refuses a copied case: {done.stderr}')
    check(expected_words in done.stdout, f'replay says nothing of {expected_words}:\n{done.stdout[:800]}')
    return done.stdout


def menu(page):
    return page.run("return [...document.querySelectorAll('#masthead nav a')].map((a) => a.getAttribute('href'))")


def shown_number(page):
    return int(page.fragment().split('?')[0].split('/')[2])


def test_every_view_draws(page):
    kinds = {run['kind'] for run in page.data['runs']}
    check({'fuzz', 'certificate', 'sweep', 'map', 'chart', 'leak', 'render'} <= kinds, f'runs are missing: {kinds}')
    check(len(menu(page)) >= 10, 'entries of the menu are missing')
    for fragment in menu(page):
        page.go(fragment)
        time.sleep(0.15)  # pictures are decoded
        check(page.text('h1'), f'{fragment}: no heading')
        check('undefined' not in page.text('main') and 'NaN' not in page.text('main'), f'{fragment}: undefined or NaN')
        for canvas in page.all('main canvas'):
            check(page.colours(canvas) > 1, f'{fragment}: a canvas is blank')
    test_the_worst_comes_first(page)
    headings = page.run("return [...document.querySelectorAll('h2')].map((x) => x.textContent)")
    check(headings[0] == 'What was not covered', f'not covered comes first, not {headings[0]}')


SEVERITIES = {'plain': 'wrong in plain general position', 'boundary': 'wrong on boundaries', 'extreme': 'wrong at extreme scale'}


def test_the_worst_comes_first(page):
    """The first line says whom it is about and how bad it is; the figures of the verdict stand below it."""
    page.go('#/')
    worst = page.data['verdicts'][0]
    text = worst['text'].replace(' %', '\u00a0%')
    headline = f'{worst["method"]}: {SEVERITIES[worst["level"]]}' if worst['level'] in SEVERITIES else text
    check(page.text('h1') == headline, f'the first line is not the worst verdict: {page.text("h1")}')
    check(text.removeprefix(worst['method'] + ': ') in page.text('.worst'), 'the worst verdict has no figures')
    check('✗' in page.text('.legend') or worst['level'] not in ('plain', 'fault'), 'the marks have no legend')


def test_from_the_matrix_to_a_case(page):
    page.go('#/matrix')
    check('How far off its numbers are' in page.text('main'), 'errors of t are not shown')
    page.focus('.grid [tabindex="0"]')
    before = page.text('.detail')
    page.press(Keys.ARROW_RIGHT, Keys.ARROW_DOWN)
    check(page.text('.detail') != before and ' of ' in page.text('.detail'), 'arrow keys say nothing of a cell')
    # The cell with the most cases in the report.
    best = page.run("""
        const cells = [...document.querySelectorAll('.grid a.heat')];
        const cases = (cell) => { cell.dispatchEvent(new PointerEvent('pointerenter')); return Number(/→ ([\\d,]+) in/.exec(document.querySelector('.detail').textContent)?.[1].replace(',', '') ?? 0); };
        const best = cells.reduce((a, b) => (cases(b) > cases(a) ? b : a));
        best.focus(); return cases(best);""")
    check(best > 0, 'no cell leads to a case')
    page.shot('matrix')
    page.press(Keys.ENTER)
    check(page.fragment().startswith('#/cell/') and 'confidence' in page.text('.lead'), 'a cell has no interval')
    page.focus('table.cases a')
    page.press(Keys.ENTER)
    check(page.fragment().startswith('#/case/'), 'a cell does not lead to a case')
    time.sleep(0.1)


def test_the_first_3d_view(page):
    """It fills its box, and no name lies on another."""
    for number in range(0, len(page.data['cases']), max(1, len(page.data['cases']) // 24)):
        page.go(f'#/case/{number}')
        box, spots, names = page.run("""
            const rect = (x) => { const {left, top, right, bottom} = x.getBoundingClientRect(); return [left, top, right, bottom]; };
            const seen = [...document.querySelectorAll('.spot')].filter((x) => !x.hidden);
            return [rect(document.querySelector('canvas.stage')), seen.map(rect), seen.map((x) => rect(x.firstChild))];""")
        spans = [(max(s[i + 2] for s in spots) - min(s[i] for s in spots)) / (box[i + 2] - box[i]) for i in (0, 1)]
        check(max(spans) > 0.6, f'case {number} fills {spans} of its box')
        for i, a in enumerate(names):
            for b in names[:i]:
                check(a[0] >= b[2] or a[2] <= b[0] or a[1] >= b[3] or a[3] <= b[1], f'case {number}: a name lies on another')


def test_the_case_in_3d(page):
    canvas = page.focus('canvas.stage')
    check(page.colours(canvas) > 3, 'the 3D view is blank')
    pictures = [page.run('return arguments[0].toDataURL()', canvas)]
    for key in [Keys.ARROW_LEFT, 'u', 'g', '-', '0']:
        page.press(key)
        check(page.colours(canvas) > 2, f'the 3D view is blank after {key!r}')
        pictures.append(page.run('return arguments[0].toDataURL()', canvas))
    check(len(set(pictures)) >= 5, 'keys do not change the 3D view')
    page.press('u')
    check('zoom=' in page.fragment() and '0.5 ulp' in page.text('.scale'), f'one ulp does not fill the window: {page.text(".scale")}')
    page.shot('case')


def test_a_copied_case_replays(page):
    entry = page.data['cases'][shown_number(page)]
    line = page.copied('case (JSON line)')
    check(json.loads(line) == entry['case'], 'the copied case is another one')
    said = replay(line + '\n', entry['case']['id'])
    check(entry['method'] in said, 'replay does not ask the method')
    command = page.copied('command')
    done = subprocess.run(command, shell=True, capture_output=True, text=True, check=False)
    check(done.returncode == 1 and 'WRONG' in done.stdout, f'the command does not show it again: {command}\n{done.stderr}')
    done = subprocess.run([sys.executable, '-c', page.copied('Python')], capture_output=True, text=True, check=False)
    check(done.returncode == 0 and done.stdout.startswith('['), f'the Python is wrong: {done.stderr}')
    source = page.copied('C')
    check(('== 1)' if entry['truth']['hit'] else '== 0)') in source, 'the C expects something else')
    done = subprocess.run(['cc', '-std=c99', '-pedantic', '-Wall', '-Werror', '-fsyntax-only', '-x', 'c', '-'], input=source, capture_output=True, text=True, check=False)
    check(done.returncode == 0, f'the C does not compile: {done.stderr}')


def test_signs_are_those_of_the_program(page):
    """The page computes signs by integers and by rounded numbers; the program said them too."""
    seen = 0
    signed = [number for number, entry in enumerate(page.data['cases']) if entry.get('signs')]
    for number in signed[::max(1, len(signed) // 20)]:
        entry = page.data['cases'][number]
        seen += 1
        page.run('location.hash = `#/case/${arguments[0]}`', number)
        told = page.run("""
            const main = document.querySelector('main');
            return new Promise((done) => requestAnimationFrame(() => done([main.querySelector('h1 code').textContent,
              [...main.querySelector('[aria-label="signs of the five volumes"] thead').querySelectorAll('th')].map((x) => x.textContent),
              [...main.querySelectorAll('[aria-label="signs of the five volumes"] tbody tr')].map((row) => [...row.querySelectorAll('.sign')].map((x) => x.textContent))])));""")
        check(told[0] == entry['case']['id'], 'another case is shown')
        columns = ['exact'] + [name.removeprefix('in ') for name in told[1] if name.startswith('in ')]
        for i, name in enumerate(columns):
            signs = [GLYPHS.get(row[i]) for row in told[2]]
            check(signs == entry['signs'][name], f'{entry["case"]["id"]}, {name}: {signs}, the program says {entry["signs"][name]}')
    check(seen >= 16, 'few cases have signs')


def test_cases_of_every_kind_of_run(page):
    for run in page.data['runs']:
        for number in run['cases'][:1]:
            page.go(f'#/case/{number}')
            check(page.text('h1 code') == page.data['cases'][number]['case']['id'], f'case {number} is not shown')
            check('undefined' not in page.text('main'), f'case {number} of {run["kind"]}: undefined')


def test_a_pixel_of_a_map_is_a_case(page):
    page.go('#/map')
    page.focus('canvas.map')
    page.press(Keys.ARROW_LEFT, Keys.ARROW_LEFT, Keys.ARROW_UP)
    page.press(Keys.ENTER)
    _, kind, run, panel, x, y = page.fragment().split('?')[0].split('/')
    check(kind == 'pixel', 'Enter on a map opens no case')
    record = page.data['runs'][int(run)]['record']
    method, size = record['panels'][int(panel)]['method'], record['size']
    line = page.copied('case (JSON line)')
    replay(line + '\n', 'exact answer')
    printed = subprocess.run(['tribunal', 'sweep', '--map', record['map'], '--map-size', str(size), '--method', method, '--pixel', f'{method},{x},{y}'],
                             capture_output=True, text=True, check=True).stdout
    program, mine = json.loads(printed.splitlines()[0]), json.loads(line)
    numbers = lambda case: [float.fromhex(n) if isinstance(n, str) else n for point in case['seg'] + case['tri'] for n in point]
    check(numbers(program) == numbers(mine), f'pixel {x},{y}: the page has another case than the program')


def test_sweep_by_keys(page):
    page.go('#/sweep?axis=sliver')
    page.focus('.lines')
    page.press(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT)
    first = page.text('.detail')
    page.press(Keys.ARROW_DOWN)
    check(' of ' in first and page.text('.detail') != first, 'arrow keys say nothing along a sweep')
    for _ in range(40):
        if 'witness' in page.text('.detail'):
            break
        page.press(Keys.ARROW_RIGHT)
    check('witness' in page.text('.detail'), f'no witness along a sweep: {page.text(".detail")}')
    identity = page.text('.detail').split('witness: ')[1]
    page.press(Keys.ENTER)
    check(page.fragment().startswith('#/case/') and page.text('h1 code') == identity, 'a sweep leads to no case')


def test_pictures(page):
    page.go('#/picture')
    time.sleep(0.3)
    canvas = page.find('canvas.picture')
    before = page.run('return arguments[0].toDataURL()', canvas)
    count = len(next(run for run in page.data['runs'] if run['kind'] == 'render')['record']['pixels']['rows'])
    check(page.run("return document.querySelector('#frames').checked") == (count <= 200), 'frames hide the picture')
    page.focus('#split')
    page.press(*[Keys.ARROW_RIGHT] * 12)
    check(page.run('return arguments[0].toDataURL()', canvas) != before, 'the slider changes nothing')
    record = next(run for run in page.data['runs'] if run['kind'] == 'render')['record']
    why = record['pixels']['words']['why']
    words = [why[row[record['pixels']['columns'].index('why')]] for row in record['pixels']['rows']]
    check('face' in words, 'the pictures differ on no face')
    if 'start' in words:
        check('only by the start of a secondary ray' in page.text('.lead'), 'pixels that start elsewhere are not told apart')
    page.focus('canvas.picture')
    for _ in range(words.index('face') + 1):
        page.press('n')
    check('zoom' not in page.text('.detail') and 'open its case' in page.text('.detail'), f'no case of a pixel: {page.text(".detail")}')
    page.shot('picture')
    page.press(Keys.ENTER)
    check(page.fragment().startswith('#/case/'), 'a differing pixel leads to no case')
    time.sleep(0.1)
    check(page.colours(page.find('canvas.stage')) > 2, 'its 3D view is blank')
    replay(page.copied('case (JSON line)') + '\n', 'exact answer')


def per_million(k, n):
    rate = 1e6 * k / n
    return f'{round(rate):,}' if rate >= 99.95 else f'{rate:.3g}'


def test_a_mesh_trial(page):
    """A rate is of the rays judged, and a subject that is not judged has none; a mesh's case says what its error is."""
    index, run = next((i, run) for i, run in enumerate(page.data['runs']) if run['kind'] == 'leak')
    page.go(f'#/leak/{index}')
    text = page.text('main')
    check('at an edge' in text and 'at a edge' not in text, 'an aim is named wrongly')
    parity = unjudged = 0
    for t, trial in enumerate(run['record']['trials']):
        head, rows = page.run("""
            const table = [...document.querySelectorAll('main section table')][arguments[0]];
            const texts = (row) => [...row.children].map((cell) => cell.textContent);
            return [texts(table.tHead.rows[0]), [...table.tBodies[0].rows].map(texts)];""", t)
        expected = [(subject, tally) for subject in trial['subjects'] for tally in [subject['all'], *(subject['by_aim'][aim] for aim in ('vertex', 'edge', 'face'))]]
        check(len(rows) == len(expected), 'not a row for each subject and aim')
        for row, (subject, tally) in zip(rows, expected):
            shown = dict(zip(head, row))
            check(shown['leak'] == per_million(tally['leak'], tally['rays']), f'another rate of leaks: {shown}')
            if 'closest' in shown and subject['name'] == 'feito-double':
                check(shown['closest'] == shown['order'] == '–', f'a method without an order is judged on it: {shown}')
            if 'parity' not in shown:
                continue
            judged = 'parity' in subject['all'] and tally['parity_judged'] > 0
            check(shown['parity'] == (per_million(tally['parity'], tally['parity_judged']) if judged else '–'), f'another rate of parity: {shown}')
            parity, unjudged = parity + judged, unjudged + (not judged)
    check(parity > 0 and unjudged > 0, 'no subject is judged for parity, or every one')
    number = next(n for n in run['cases'] if page.data['cases'][n]['outcome'] == 'parity')
    page.go(f'#/case/{number}')
    check('on the wrong side' in page.text('main') and 'asks this one triangle only' in page.text('main'), 'a parity is not explained')


def test_a_plugin_needs_its_library(page):
    number = next(n for n, entry in enumerate(page.data['cases']) if entry.get('method') == 'my-mt')
    page.go(f'#/case/{number}')
    command = page.copied('command')
    check(command.endswith(' --plugin ./LIB.so') and page.text('pre.command') == command, f'the command names no library: {command}')
    check('./LIB.so' in page.text('.command + .note'), 'nothing says what the placeholder is')
    done = subprocess.run(command.replace('./LIB.so', './mine.so'), shell=True, capture_output=True, text=True, check=False)
    check(done.returncode == 1 and 'my-mt' in done.stdout and 'WRONG' in done.stdout, f'the command does not show it again: {command}\n{done.stderr}')


def test_the_chart_opens_at_the_worst(page):
    index, run = next((i, run) for i, run in enumerate(page.data['runs']) if run['kind'] == 'chart')
    wrong = {}
    for row in run['record']['rows']:
        if row['answers']['judged'] and (row.get('nanoseconds') or {}).get('median', 0) > 0:
            key = (row['population'], row['fmt'])
            wrong[key] = wrong.get(key, 0) + row['answers']['wrong']
    page.go(f'#/chart/{index}')
    told = page.run("return [...document.querySelectorAll('[aria-label=\"speed and accuracy\"] tbody tr')].map((row) => Number(row.children[2].textContent.replaceAll(',', '')))")
    check(sum(told) == max(wrong.values()) > 0, f'the chart opens with {sum(told)} wrong answers, another population has {max(wrong.values())}')
    check(page.run("return [...document.querySelectorAll('.scatter .number')].map((x) => x.textContent).sort()") ==
          page.run("return [...document.querySelectorAll('.who b')].map((x) => x.textContent).sort()"), 'marks and the list have other numbers')


def test_thresholds_are_those_chosen(page):
    index, run = next((i, run) for i, run in enumerate(page.data['runs']) if run['kind'] == 'sweep')
    all_of = [row for row in run['record']['thresholds'] if row['axis'] == 'sliver']
    for probe in ('segment', 'ray'):
        for outcome in ('wrong', 'false hit', 'wrong contact'):
            chosen = [row for row in all_of if row['fmt'] == 'binary64' and row['probe'] == probe and outcome in ('wrong', row['outcome'])]
            page.go(f'#/sweep/{index}?axis=sliver&fmt=binary64&probe={probe}&outcome={outcome}')
            shown = page.run("return [...document.querySelectorAll('[aria-label=\"thresholds\"] tbody tr')].map((row) => row.children[3].textContent)")
            check(shown == [probe] * len(chosen) and 0 < len(chosen) < len(all_of),
                  f'{probe}, {outcome}: {len(shown)} thresholds, {len(chosen)} of {len(all_of)} are chosen')


def states(page):
    polygon = next((i for i, entry in enumerate(page.data['cases']) if 'rings' in entry['case']), 0)
    return menu(page) + ['#/case/0?zoom=ulp', f'#/case/{polygon}', '#/class/C017', '#/class/R042', '#/matrix/0?method=sf-double&fmt=binary64']


def test_widths_and_accessibility(page):
    found = []
    looks = [(420, 'dark'), (1280, 'light')]
    for width, scheme in looks + ([(420, 'light'), (1280, 'dark')] if page.takes_pictures() else []):
        page.look(width, scheme)
        for fragment in states(page):
            page.go(fragment)
            wide = page.run('return document.documentElement.scrollWidth')
            if wide > width:
                found.append(f'{fragment} is {wide} pixels wide at {width}')
            page.shot(f'{width}-{scheme}-{fragment.strip("#/").split("?")[0].replace("/", "-") or "overview"}')
            if (width, scheme) in looks:
                found += [f'{fragment} at {width}, {scheme}: {violation}' for violation in page.axe()]
    check(not found, '\n'.join(found))


def test_a_state_is_a_link(page):
    page.driver.get('about:blank')
    page.driver.get(page.address + '#/case/1?zoom=-20&at=1')
    page.settle()
    check(page.text('h1 code') == page.data['cases'][1]['case']['id'], 'a link does not lead to its case')
    check('−20' not in page.fragment() and page.find('#focus').get_attribute('value') == '1', 'a link loses where it looks')


def test_hostile_names_stay_text(page):
    name = page.data['cases'][0]['case']['id']
    check('<script>' in name, 'the names are not hostile')
    for fragment in menu(page) + ['#/case/0', '#/cases', f'#/cell/0?method=<img src=x onerror=alert(4)>']:
        page.go(fragment)
        check(page.run("return document.querySelectorAll('main img, main script, header img, main b[onclick]').length") == 0, f'{fragment}: a name became an element')
    page.go('#/case/0')
    check(page.text('h1 code') == name, 'a hostile name is not shown as it is')
    replay(page.copied('case (JSON line)') + '\n', 'exact answer')
    source = page.copied('C')
    done = subprocess.run(['cc', '-std=c99', '-fsyntax-only', '-x', 'c', '-'], input=source, capture_output=True, text=True, check=False)
    check(done.returncode == 0, f'a hostile name breaks the C: {done.stderr}')


def run(file, tests):
    page = Page(file)
    try:
        for test in tests:
            begun = time.time()
            test(page)
            complaints = page.complaints()
            check(not complaints, 'the console or the network has:\n' + '\n'.join(complaints[:10]))
            print(f'{test.__name__}: {time.time() - begun:.1f} s', flush=True)
    finally:
        page.close()


run(sys.argv[1], [test_every_view_draws, test_the_first_3d_view, test_from_the_matrix_to_a_case, test_the_case_in_3d, test_a_copied_case_replays,
                  test_signs_are_those_of_the_program, test_cases_of_every_kind_of_run, test_a_pixel_of_a_map_is_a_case, test_sweep_by_keys, test_pictures,
                  test_a_mesh_trial, test_a_plugin_needs_its_library, test_the_chart_opens_at_the_worst, test_thresholds_are_those_chosen,
                  test_a_state_is_a_link, test_widths_and_accessibility])
run(sys.argv[2], [test_hostile_names_stay_text])
