#!/usr/bin/env python3
"""Branch coverage of what decides, by the programs of checks that judge its mutants (tests/mutation/groups.py).

    measure.py SCRATCH [--only PROGRAM] [--cxx g++] [--gcov gcov]

Each program is compiled with nothing optimised away, and run; gcov says which branches of the group's files it took. Writes
SCRATCH/coverage.json, which check.py reads. A branch of a template is taken if one of its instances takes it.
"""
import argparse
import collections
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / 'tests/mutation'))
import groups  # noqa: E402


def add(taken, place, files, gcov):
    """Adds file -> line -> whether each branch was taken. Ways out by an exception are left out, and the branches of the
    instances of a template are put one over the other: gcovr 5.2 does neither where a line is compiled more than once."""
    for data in sorted(place.glob('*.gcda')):
        told = subprocess.run([gcov, '--json-format', '--stdout', '--branch-probabilities', str(data)], check=True, cwd=place,
                              stdout=subprocess.PIPE, text=True).stdout
        for entry in (e for line in told.splitlines() for e in json.loads(line)['files']):
            path = pathlib.Path(place, entry['file']).resolve()
            name = str(path.relative_to(ROOT)) if path.is_relative_to(ROOT) else ''
            if name not in files:
                continue
            lines = taken.setdefault(name, {})
            instances = collections.defaultdict(list)
            for line in entry['lines']:
                instances[line['line_number'], line.get('function_name')] += [
                    b['count'] > 0 for b in line['branches'] if not b['throw']]
            for (number, _), branches in instances.items():
                # A call that may throw has one way out that does not.
                if len(branches) > 1:
                    known = lines.setdefault(number, [False] * len(branches))
                    known += [False] * (len(branches) - len(known))
                    lines[number] = [a or b for a, b in zip(known, branches + [False] * (len(known) - len(branches)))]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('scratch', type=pathlib.Path)
    parser.add_argument('--only', help='the group of this program, without .cpp')
    parser.add_argument('--cxx', default='g++')
    parser.add_argument('--gcov', default='gcov')
    o = parser.parse_args()
    taken = {}
    for group in groups.GROUPS:
        if o.only not in (None, pathlib.Path(group.program).stem):
            continue
        place = o.scratch.resolve() / pathlib.Path(group.program).stem
        place.mkdir(parents=True)
        objects = []
        for n, unit in enumerate(groups.units_of(group, ROOT, place)):
            objects.append(str(place / f'{n}.o'))
            # Counters that threads share: some branches are counted as the difference of others.
            subprocess.run([o.cxx, '-std=c++20', '-O0', '--coverage', '-fprofile-update=atomic', '-ffp-contract=off', '-w',
                            *group.coverage_flags, '-I', str(ROOT), '-c', str(ROOT / unit), '-o', objects[-1]],
                           check=True, cwd=ROOT)
        program = str(place / 'kill')
        subprocess.run([o.cxx, '--coverage', *objects, '-o', program, *group.libraries], check=True)
        subprocess.run([program, *(str(ROOT / a) for a in group.arguments)], check=True)
        add(taken, place, set(group.files), o.gcov)
    (o.scratch / 'coverage.json').write_text(json.dumps(
        {file: {number: list(map(int, branches)) for number, branches in lines.items()} for file, lines in taken.items()}))


if __name__ == '__main__':
    main()
