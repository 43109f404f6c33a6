#!/usr/bin/env python3
"""Mutation run over what decides: changes one token at a time and asks whether a program of checks notices.

    run.py [--every K] [--first I] [--quick] [--jobs N] [--cxx g++] [FILE ...]

Files are judged in groups (groups.py), each by one program kill_*.cpp, which includes all that it tests. A mutant that
does not compile is invalid and not counted; one that fails or exceeds the time limit is killed. A survivor must be listed
in equivalents.tsv (file, mutated line, argument), or the run fails. --every K takes every K-th mutant, from the I-th on.

Most mutants share one program (schemata.py), which is told at its start which of them it is; those that cannot, and those
that survive there, are compiled by themselves.
"""
import argparse
import collections
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor

import groups
import schemata
from groups import GROUPS, GROUP_OF
from mutants import mutants_of

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
TIME_LIMIT = 120  # seconds; the unchanged programs take about two, and other things may run beside them
FEWEST_TOGETHER = 6  # mutants of a file; fewer are sooner compiled one by one
VERDICTS = ('killed', 'argued', 'survived', 'invalid')


class Judge:
    """Builds a group's program against mutated copies of its files, and runs it. What does not depend on the copy, library
    headers among it, is compiled once."""

    def __init__(self, group, cxx, scratch):
        self.group, self.scratch, self.objects, self.lock = group, scratch, {}, threading.Lock()
        scratch.mkdir()
        self.command = [cxx, '-std=c++20', '-O1', '-ffp-contract=off', '-w']
        self.units = groups.units_of(group, ROOT, scratch)
        self.reach = {unit: groups.reached_from(unit, ROOT) for unit in self.units}
        (scratch / 'libraries.h').write_text('#pragma once\n' + '\n'.join(self.libraries()) + '\n')
        subprocess.run(self.command + ['-x', 'c++-header', str(scratch / 'libraries.h'), '-o',
                                       str(scratch / 'libraries.h.gch')], check=True)

    def libraries(self):
        """The headers of libraries that the program includes, through whatever files of ours."""
        program = self.units[0]
        texts = [(ROOT / f).read_text() for f in self.reach[program]]
        # Highway's headers are read once for each instruction set, and differ.
        return sorted({name for text in texts for name in re.findall(r'^#include <(?!hwy/)[^>]*>', text, re.M)})

    def compiled(self, unit, to, place=None):
        """The compiler's complaints."""
        source = place / unit if place and (place / unit).exists() else ROOT / unit
        overlay = ['-I', str(place)] if place else []
        built = subprocess.run(self.command + ['-include', str(self.scratch / 'libraries.h'), *overlay, '-I', str(ROOT),
                                               '-c', str(source), '-o', str(to)],
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors='replace')
        return built.stderr if built.returncode else ''

    def object_of(self, unit):
        with self.lock:
            if unit not in self.objects:
                to = self.scratch / f'unit{len(self.objects)}.o'
                complaints = self.compiled(unit, to)
                if complaints:
                    sys.exit(f'{unit} does not compile:\n{complaints}')
                self.objects[unit] = to
            return self.objects[unit]

    def build(self, name, file, text):
        """The program's path, or the compiler's complaints."""
        place = self.scratch / name
        (place / file).parent.mkdir(parents=True)
        (place / file).write_text(text)
        objects = []
        for n, unit in enumerate(self.units):
            if file not in self.reach[unit]:
                objects.append(self.object_of(unit))
                continue
            objects.append(place / f'{n}.o')
            complaints = self.compiled(unit, objects[-1], place)
            if complaints:
                return None, complaints
        program = place / 'kill'
        linked = subprocess.run(self.command + [str(o) for o in objects] + ['-o', str(program), *self.group.libraries],
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors='replace')
        for o in objects:
            if o.parent == place:
                o.unlink()
        return (program, '') if linked.returncode == 0 else (None, linked.stderr)

    def survives(self, program, chosen=0):
        try:
            run = subprocess.run([str(program), *(str(ROOT / a) for a in self.group.arguments)], timeout=TIME_LIMIT,
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                 env=dict(os.environ, MUTANT=str(chosen)))
        except subprocess.TimeoutExpired:
            return False
        return run.returncode == 0

    def alone(self, name, mutant):
        program, _ = self.build(name, mutant.file, mutant.text())
        if program is None:
            return 'invalid'
        survived = self.survives(program)
        program.unlink()
        return 'survived' if survived else 'killed'

    def require_right(self):
        program, complaints = self.build('unchanged', self.group.files[0], (ROOT / self.group.files[0]).read_text())
        if program is None or not self.survives(program):
            sys.exit(f'{self.group.program} kills the unchanged files\n{complaints}')

    def together(self, name, file, mutants):
        """The one program of as many of them as fit, and which these are; invalid ones are told apart."""
        fit, invalid = schemata.fitting(mutants), set()
        while fit:
            text, owners = schemata.merged(fit)
            program, complaints = self.build(f'{name}-{len(fit)}', file, text)
            if program is not None:
                return program, fit, invalid
            blamed, hopeless = schemata.blamed(complaints, file, owners)
            invalid |= hopeless
            fit = [m for m in fit if m not in blamed] if blamed else []
        return None, [], invalid

    def verdicts(self, file, mutants, pool):
        """mutant -> verdict."""
        found = {}
        if len(mutants) >= FEWEST_TOGETHER:
            program, fit, invalid = self.together(file.replace('/', '-'), file, mutants)
            found.update((m, 'invalid') for m in invalid)
            if program is not None:
                if not self.survives(program):
                    sys.exit(f'{self.group.program} kills the unchanged {file} among its mutants')
                survivors = pool.map(lambda m: self.survives(program, schemata.number_of(m)), fit)
                found.update((m, 'killed') for m, s in zip(fit, survivors) if not s)
        rest = [m for m in mutants if m not in found]
        alone = pool.map(lambda n: self.alone(f'{file.replace("/", "-")}@{n}', rest[n]), range(len(rest)))
        found.update(zip(rest, alone))
        return found


def argued():
    rows = (line.split('\t') for line in (HERE / 'equivalents.tsv').read_text().splitlines()[1:])
    return {(file, mutant): why for file, mutant, why in rows}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--every', type=int, default=1)
    parser.add_argument('--first', type=int, default=0)
    parser.add_argument('--jobs', type=int, default=1)
    parser.add_argument('--cxx', default='g++')
    parser.add_argument('--quick', action='store_true', help='leave out what takes long to compile')
    parser.add_argument('files', nargs='*', default=list(GROUP_OF))
    o = parser.parse_args()
    if o.quick:
        o.files = [f for f in o.files if not GROUP_OF[f].slow]
    known = argued()
    chosen = [m for f in o.files for m in mutants_of(ROOT, f)][o.first::o.every]
    by_file = collections.defaultdict(list)
    for m in chosen:
        by_file[m.file].append(m)
    counts = {f: collections.Counter() for f in by_file}
    print(f'{"file":40} ' + ' '.join(f'{v:>8}' for v in VERDICTS), flush=True)
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(o.jobs) as pool:
        for group in GROUPS:
            files = [f for f in group.files if f in by_file]
            if not files:
                continue
            judge = Judge(group, o.cxx, pathlib.Path(scratch) / pathlib.Path(group.program).stem)
            judge.require_right()
            for file in files:
                verdicts = judge.verdicts(file, by_file[file], pool)
                for m in by_file[file]:
                    verdict = verdicts[m]
                    if verdict == 'survived' and (file, m.changed) in known:
                        verdict = 'argued'
                    counts[file][verdict] += 1
                    if verdict == 'survived':
                        print(f'{file}:{m.number}: survived\n    {m.line}\n    {m.changed}', flush=True)
                print(f'{file:40} ' + ' '.join(f'{counts[file][v]:8}' for v in VERDICTS), flush=True)
    total = sum(counts.values(), collections.Counter())
    judged = total['killed'] + total['survived'] + total['argued']
    if total['killed'] == 0:
        sys.exit('no mutant was killed')
    print(f'score {total["killed"]}/{judged} killed, {total["argued"]} argued equivalent, {total["survived"]} open, '
          f'{total["invalid"]} invalid')
    print(f'tried {judged}, broke {total["survived"]}: mutants, and those that survive unargued')
    sys.exit(1 if total['survived'] else 0)


if __name__ == '__main__':
    main()
