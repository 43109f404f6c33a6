#!/usr/bin/env python3
"""Mutation run over the predicate headers: changes one token at a time and asks whether kill.cpp notices.

    run.py [--every K] [--first I] [--jobs N] [--cxx g++] [HEADER ...]

Each mutant is a copy of one header with one token changed; kill.cpp is compiled against it and run. A mutant that does
not compile is invalid and not counted; one that fails or exceeds the time limit is killed. A survivor must be listed in
equivalents.tsv (header, mutated line, argument), or the run fails. --every K takes every K-th mutant, from the I-th on.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
HEADERS = ['core/sign.h', 'core/vec3.h', 'core/signed_volume.h', 'core/kernel.h', 'core/coplanar.h',
           'core/segura_feito.h', 'exact/classes/chirotope.h']
TIME_LIMIT = 30  # seconds; the unchanged program takes about two

# What replaces what. clang-format puts spaces around binary operators and none around template brackets.
OPERATORS = [(' < ', ' <= '), (' > ', ' >= '), (' <= ', ' < '), (' >= ', ' > '), (' == ', ' != '), (' != ', ' == '),
             (' + ', ' - '), (' - ', ' + '), (' * ', ' + '), (' && ', ' || '), (' || ', ' && '), (' += ', ' = '),
             (' |= ', ' &= '), (' |= ', ' = '), ('++', '--'), ('--', '++')]
WORDS = [('x', 'y'), ('y', 'z'), ('z', 'x'), ('u', 'v'), ('v', 'u'), ('a', 'b'), ('b', 'c'), ('c', 'a'), ('p', 'q'),
         ('q', 'p'), ('i', 'j'), ('j', 'k'), ('k', 'i'), ('f', 'g'), ('g', 'f'), ('s', 't'), ('lo', 'hi'), ('hi', 'lo'),
         ('num', 'den'), ('den', 'num'), ('positive', 'negative'), ('negative', 'positive'), ('zero', 'positive'),
         ('true', 'false'), ('false', 'true'), ('first', 'second'), ('second', 'first'), ('edge', 'vertex'),
         ('vertex', 'interior'), ('interior', 'edge'), ('source', 'target'), ('target', 'source'),
         ('source_side', 'target_side'), ('target_side', 'source_side'), ('near_end', 'far_end'),
         ('far_end', 'near_end'), ('source_of_ab', 'target_of_ab'), ('a_of_probe', 'b_of_probe'),
         ('between', 'source')]
STATEMENTS = [(r'return miss\(\);', 'return hit_at(Contact::coplanar);'),
              (r'\bif \(.*\) return [^;]*;', ';'), (r'\bcontinue;', ';'), (r'(?<=[(,?:=] )-|(?<=\()-|(?<=return )-', ''),
              (r'!(?=[\w(])', '')]


def code_lines(text):
    """Line numbers and lines of code: no comments, no preprocessor, no declarations that only the compiler reads."""
    in_concept = False
    for number, line in enumerate(text.split('\n')):
        bare = re.sub(r' /\*.*?\*/', '', line.split('//')[0])
        in_concept |= 'concept ' in bare
        skip = in_concept or bare.lstrip().startswith(('#', 'template', 'using', 'static_assert', 'namespace', '*'))
        if in_concept and bare.startswith('};'):
            in_concept = False
        if not skip and bare.strip():
            yield number, bare.rstrip()


def variants(line):
    """Every line that differs from this one by one token."""
    for old, new in OPERATORS:
        for m in re.finditer(re.escape(old), line):
            yield line[:m.start()] + new + line[m.end():]
    for old, new in WORDS:
        for m in re.finditer(r'\b%s\b' % old, line):
            yield line[:m.start()] + new + line[m.end():]
    for m in re.finditer(r'(?<![\w.:])\d+(?![\w.])', line):
        for n in {0: [1], 1: [0, 2]}.get(int(m.group()), [int(m.group()) - 1, int(m.group()) + 1]):
            yield line[:m.start()] + str(n) + line[m.end():]
    for pattern, new in STATEMENTS:
        for m in re.finditer(pattern, line):
            yield line[:m.start()] + new + line[m.end():]


def mutants(header):
    text = (ROOT / header).read_text()
    lines = text.split('\n')
    for number, line in code_lines(text):
        for changed in dict.fromkeys(variants(line)):
            yield header, number + 1, line.strip(), changed.strip(), '\n'.join(
                lines[:number] + [changed] + lines[number + 1:])


class Compiler:
    """Compiles kill.cpp against a mutated header, its library headers compiled once."""

    def __init__(self, cxx, scratch):
        self.scratch = scratch
        self.command = [cxx, '-std=c++20', '-O1', '-ffp-contract=off', '-w']
        sources = [HERE / 'kill.cpp', ROOT / 'core/query.h', ROOT / 'core/answer.h'] + [ROOT / h for h in HEADERS]
        libraries = {m for s in sources for m in re.findall(r'#include <[^>]*>', s.read_text())}
        (scratch / 'libraries.h').write_text('#pragma once\n' + '\n'.join(sorted(libraries)) + '\n')
        subprocess.run(self.command + ['-x', 'c++-header', str(scratch / 'libraries.h'), '-o',
                                       str(scratch / 'libraries.h.gch')], check=True)

    def verdict(self, name, header, text):
        place = self.scratch / name
        (place / header).parent.mkdir(parents=True)
        (place / header).write_text(text)
        program = place / 'kill'
        built = subprocess.run(self.command + ['-include', str(self.scratch / 'libraries.h'), '-I', str(place), '-I',
                                               str(ROOT), str(HERE / 'kill.cpp'), '-o', str(program)],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        if built.returncode != 0:
            return 'invalid'
        try:
            run = subprocess.run([str(program), str(ROOT / 'data/classes163.tsv'), str(ROOT / 'data/ray_classes.tsv')], timeout=TIME_LIMIT,
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        except subprocess.TimeoutExpired:
            return 'killed'
        finally:
            program.unlink()
        return 'survived' if run.returncode == 0 else 'killed'


def argued():
    rows = (line.split('\t') for line in (HERE / 'equivalents.tsv').read_text().splitlines()[1:])
    return {(header, mutant): why for header, mutant, why in rows}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--every', type=int, default=1)
    parser.add_argument('--first', type=int, default=0)
    parser.add_argument('--jobs', type=int, default=1)
    parser.add_argument('--cxx', default='g++')
    parser.add_argument('headers', nargs='*', default=HEADERS)
    o = parser.parse_args()
    chosen = [m for h in o.headers for m in mutants(h)][o.first::o.every]
    known, unargued = argued(), 0
    counts = {h: {'killed': 0, 'survived': 0, 'argued': 0, 'invalid': 0} for h in o.headers}
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(o.jobs) as pool:
        compiler = Compiler(o.cxx, pathlib.Path(scratch))
        unchanged = compiler.verdict('unchanged', HEADERS[0], (ROOT / HEADERS[0]).read_text())
        if unchanged != 'survived':
            sys.exit('kill.cpp kills the unchanged headers')
        verdicts = pool.map(lambda n: compiler.verdict(str(n), chosen[n][0], chosen[n][4]), range(len(chosen)))
        for (header, number, line, changed, _), verdict in zip(chosen, verdicts):
            if verdict == 'survived' and (header, changed) in known:
                verdict = 'argued'
            counts[header][verdict] += 1
            if verdict == 'survived':
                unargued += 1
                print(f'{header}:{number}: survived\n    {line}\n    {changed}', flush=True)
    total = {v: sum(c[v] for c in counts.values()) for v in ('killed', 'survived', 'argued', 'invalid')}
    print(f'{"header":32} {"killed":>7} {"argued":>7} {"survived":>9} {"invalid":>8}')
    for name, c in list(counts.items()) + [('all', total)]:
        print(f'{name:32} {c["killed"]:7} {c["argued"]:7} {c["survived"]:9} {c["invalid"]:8}')
    judged = total['killed'] + total['survived'] + total['argued']
    if total['killed'] == 0:
        sys.exit('no mutant was killed')
    print(f'score {total["killed"]}/{judged} killed, {total["argued"]} argued equivalent, {total["survived"]} open')
    sys.exit(1 if unargued else 0)


if __name__ == '__main__':
    main()
