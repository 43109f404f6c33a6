#!/usr/bin/env python3
"""Static analysis by a chosen set of checks: every finding is mended, or argued in accepted.tsv.

    analyse.py --list                        accepted.tsv against the sources: files and lines are there, each with an argument
    analyse.py SCRATCH [--only REGEX] [--tool clang-tidy|cppcheck] [--jobs N]

clang-tidy.yaml has the checks of clang-tidy, with a reason for each of a group that is left out; CPPCHECK below those of
cppcheck.
An accepted finding is a check, a file, the text of its line (numbers move) and an argument. One that is not found any more
fails too, unless --only or --tool leaves something out. Before anything else each tool must find faults planted for it.
"""
import argparse
import collections
import json
import os
import pathlib
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
ROOMS = ('core', 'exact', 'tracer', 'tests')
TOOLS = ('clang-tidy', 'cppcheck')
# Not asked for: `style`, which clang-format and the compilers' warnings are for, and `unusedFunction`, which sees no templates.
CPPCHECK = ['--std=c++20', '--library=googletest,gnu,posix', '--enable=warning,performance,portability',
            '--inconclusive', '--quiet', '--template={file}:{line}:{column}: {severity}: {message} [{id}]']
FINDING = re.compile(r'^(\S[^:\n]*):(\d+):\d+: (?!note\b)(\w+): (.*) \[([\w.+-]+)(?:,-warnings-as-errors)?\]$', re.M)
PLANTED = """#include <utility>
#include <vector>
int after_move(std::vector<int> v) {
  const std::vector<int> taken = std::move(v);
  return static_cast<int>(v.size() + taken.size());
}
int past_the_end() {
  int few[2] = {1, 2};
  return few[2];
}
"""
FINDS = {'clang-tidy': 'bugprone-use-after-move', 'cppcheck': 'arrayIndexOutOfBounds'}


def run(command, **options):
    """What it prints, and whether it ended by itself."""
    done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors='replace', **options)
    return done.stdout, done.returncode >= 0


def name_of(path):
    """The file's name in the repository, or nothing."""
    path = pathlib.Path(path).resolve()
    return str(path.relative_to(ROOT)) if path.is_relative_to(ROOT) else None


def lines_of(file):
    return [line.strip() for line in (ROOT / file).read_text().splitlines()]


class Clang:
    """clang-tidy over what the build compiles; headers are read where they are included."""

    def __init__(self, scratch):
        self.build = scratch / 'configured'
        self.command = ['clang-tidy', '--quiet', f'--config-file={HERE / "clang-tidy.yaml"}',
                        f'--header-filter=^{ROOT}/({"|".join(ROOMS)})/']

    def sources(self):
        configured = subprocess.run(['cmake', '-S', str(ROOT), '-B', str(self.build), '-G', 'Ninja',
                                     '-DCMAKE_CXX_COMPILER=clang++', '-DCMAKE_BUILD_TYPE=Release', '-DTRIBUNAL_FUZZ=ON',
                                     '-DCMAKE_EXPORT_COMPILE_COMMANDS=ON'],
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if configured.returncode != 0:
            sys.exit(configured.stdout)
        commands = json.loads((self.build / 'compile_commands.json').read_text())
        return sorted({name for name in (name_of(c['file']) for c in commands)
                       if name and (name == 'main.cpp' or name.split('/')[0] in ROOMS)})

    def output(self, file):
        return run([*self.command, '-p', str(self.build), str(ROOT / file)])

    def planted(self, path):
        return run([*self.command, str(path), '--', '-std=c++20'])


class Cppcheck:
    """cppcheck over every source; it reads our headers where they are included, and no library's."""

    def __init__(self, scratch):
        self.cache = scratch / 'cppcheck'
        self.cache.mkdir(exist_ok=True)

    def sources(self):
        found = [p for room in ROOMS for kind in ('*.cpp', '*.c') for p in (ROOT / room).rglob(kind)] + [ROOT / 'main.cpp']
        return sorted(str(p.relative_to(ROOT)) for p in found)

    def output(self, file):
        return run(['cppcheck', *CPPCHECK, '-I', str(ROOT), file], cwd=ROOT)

    def planted(self, path):
        return run(['cppcheck', *CPPCHECK, str(path)])


def accepted():
    rows = [line.split('\t') for line in (HERE / 'accepted.tsv').read_text().splitlines()[1:]]
    return [tuple(row) if len(row) == 4 else (row[0], '', '', '') for row in rows]


def faults_of_list():
    for check, file, text, why in accepted():
        if not (ROOT / file).is_file():
            yield f'{check}: accepted in a file that is not there: {file}'
        elif text not in lines_of(file):
            yield f'{file}: {check} accepted in a line that is not there: {text}'
        elif len(why.split()) < 5:
            yield f'{file}: {check} accepted without an argument: {text}'
    for row, count in collections.Counter(row[:3] for row in accepted()).items():
        if count > 1:
            yield f'{row[1]}: {row[0]} accepted twice: {row[2]}'
    for room in ROOMS:
        for path in sorted(p for kind in ('*.h', '*.cpp', '*.c') for p in (ROOT / room).rglob(kind)):
            if re.search('NOLINT|cppcheck-suppress', path.read_text()):
                yield f'{path.relative_to(ROOT)}: silences a tool by itself, not in accepted.tsv'
    for line in (HERE / 'clang-tidy.yaml').read_text().splitlines():
        left_out = re.match(r'\s+-([\w.-]+),?$', line)
        if left_out and left_out[1] != '*' and not re.search(rf'^# {re.escape(left_out[1])}: (\S+ ){{4}}',
                                                             (HERE / 'clang-tidy.yaml').read_text(), re.M):
            yield f'clang-tidy.yaml: {left_out[1]} is left out without an argument'


def require_teeth(name, tool, scratch):
    planted = scratch / 'planted.cpp'
    planted.write_text(PLANTED)
    told, _ = tool.planted(planted)
    if not any(check == FINDS[name] for *_, check in FINDING.findall(told)):
        sys.exit(f'{name} does not find {FINDS[name]}:\n{told}')


def findings_in(told):
    """(check, file, line's text) -> how it reads, of what lies in the repository."""
    for path, number, _, message, check in FINDING.findall(told):
        name = name_of(ROOT / path)
        if name and not name.startswith('build/'):
            text = lines_of(name)[int(number) - 1] if int(number) > 0 else ''
            yield (check, name, text), f'{name}:{number}: {message} [{check}]'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('scratch', nargs='?', type=pathlib.Path)
    parser.add_argument('--list', action='store_true')
    parser.add_argument('--only', default='')
    parser.add_argument('--tool', choices=TOOLS)
    parser.add_argument('--jobs', type=int, default=os.cpu_count())
    o = parser.parse_args()
    faults, tried = list(faults_of_list()), len(accepted())
    if not o.list:
        if o.scratch is None:
            parser.error('a folder for scratch is needed')
        scratch = o.scratch.resolve()
        scratch.mkdir(parents=True, exist_ok=True)
        known, seen = {row[:3] for row in accepted()}, set()
        for name, make in zip(TOOLS, (Clang, Cppcheck)):
            if o.tool not in (None, name):
                continue
            tool = make(scratch)
            require_teeth(name, tool, scratch)
            files = [f for f in tool.sources() if re.search(o.only, f)]
            tried += len(files)
            with ThreadPoolExecutor(o.jobs) as pool:
                for file, (told, ended) in zip(files, pool.map(tool.output, files)):
                    found = dict(findings_in(told))
                    if not ended:
                        faults.append(f'{file}: {name} crashed')
                    new = {key: text for key, text in found.items() if key not in seen and key not in known}
                    seen.update(found)
                    faults += new.values()
                    print(f'{name} {file}: {len(new)} findings', *new.values(), sep='\n  ', flush=True)
        if tried == len(accepted()):
            sys.exit('no file matches')
        if not o.only and not o.tool:
            faults += [f'{file}: {check} accepted, and not found: {text}' for check, file, text in sorted(known - seen)]
    for fault in faults:
        print(fault)
    print(f'tried {tried}, broke {len(faults)}: files under clang-tidy and under cppcheck, and accepted findings')
    sys.exit(1 if faults else 0)


if __name__ == '__main__':
    main()
