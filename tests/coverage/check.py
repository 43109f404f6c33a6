#!/usr/bin/env python3
"""Holds branch coverage to 100 % of the files listed here, but for the branches that exceptions.tsv argues for.

    check.py --list            the list and the exceptions against the sources: files and lines are there, each with an argument
    check.py COVERAGE.json [PROGRAM]
                               measure.py's figures too, of all files or of one program's: a branch that was not taken is an
                               exception, and an exception was not taken

An exception is a file, the text of its line (numbers move) and an argument why no operands can take the branch. It stands for
all branches of that line that were not taken.
"""
import collections
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(ROOT / 'tests/mutation'))
from groups import GROUP_OF  # noqa: E402

# What an answer is made of: the tests themselves, and the filters and exact numbers that give them signs. Each is
# measured by the program of checks that is for it.
FILES = sorted(GROUP_OF)


def exceptions():
    rows = [line.split('\t') for line in (HERE / 'exceptions.tsv').read_text().splitlines()[1:]]
    return [tuple(row) if len(row) == 3 else (row[0], '', '') for row in rows]


def faults_of_list():
    for file in FILES:
        if not (ROOT / file).is_file():
            yield f'{file}: not there'
    for file, text, why in exceptions():
        if file not in FILES:
            yield f'{file}: an exception about a file that is not in the list'
        elif len(why.split()) < 5:
            yield f'{file}: an exception without an argument: {text}'
        elif text not in lines_of(file):
            yield f'{file}: an exception about a line that is not there: {text}'
    for row, count in collections.Counter((f, t) for f, t, _ in exceptions()).items():
        if count > 1:
            yield f'{row[0]}: an exception twice: {row[1]}'


def lines_of(file):
    return [line.strip() for line in (ROOT / file).read_text().splitlines()]


def branches_of(file, measured):
    """Line's text -> number of its branches, and of those not taken."""
    source, found = lines_of(file), collections.defaultdict(lambda: [0, 0])
    for number, taken in measured.items():
        text = source[int(number) - 1]
        found[text][0] += len(taken)
        found[text][1] += taken.count(0)
    return found


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    faults, tried = list(faults_of_list()), len(FILES) + len(exceptions())
    if sys.argv[1] != '--list':
        measured = json.loads(pathlib.Path(sys.argv[1]).read_text())
        argued = {(file, text) for file, text, _ in exceptions()}
        for file in FILES:
            if len(sys.argv) == 3 and pathlib.Path(GROUP_OF[file].program).stem != sys.argv[2]:
                continue
            if file not in measured:
                faults.append(f'{file}: not measured')
                continue
            found = branches_of(file, measured[file])
            all_branches, missed = (sum(n[i] for n in found.values()) for i in (0, 1))
            tried += all_branches
            print(f'{file:45} {all_branches:5} branches, {missed:3} not taken')
            for text, (_, untaken) in found.items():
                if untaken and (file, text) not in argued:
                    faults.append(f'{file}: {untaken} not taken: {text}')
            for text in (t for f, t in argued if f == file and not found.get(t, (0, 0))[1]):
                faults.append(f'{file}: an exception, and all its branches are taken: {text}')
    for fault in faults:
        print(fault)
    print(f'tried {tried}, broke {len(faults)}: branches, files and exceptions')
    sys.exit(1 if faults else 0)


if __name__ == '__main__':
    main()
