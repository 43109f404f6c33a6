#!/usr/bin/python3
"""Holds one run of a benchmark against another: python3 docs/compare_benches.py FIRST.txt SECOND.txt

Both files hold what `./run bench NAME` prints; of that, lines `ratio NAME MEDIAN [LOW, HIGH]` count. A ratio of the second
run agrees if its median lies within the interval of the first. Exit code 0: all agree; 1: some do not; 2: nothing to compare.
"""
import re
import sys

RATIO = re.compile(r"^ratio (\S+) ([0-9.e+-]+) \[([0-9.e+-]+), ([0-9.e+-]+)\]$")


def ratios(path):
    with open(path, encoding="utf-8") as lines:
        found = (RATIO.match(line.rstrip("\n")) for line in lines)
        return {m[1]: tuple(float(m[i]) for i in (2, 3, 4)) for m in found if m}


def main(first_path, second_path):
    first, second = ratios(first_path), ratios(second_path)
    common = [name for name in first if name in second]
    if not common:
        print(f"compare_benches: {first_path} and {second_path} have no ratio in common", file=sys.stderr)
        return 2
    outside = [name for name in common if not first[name][1] <= second[name][0] <= first[name][2]]
    print(f"{len(common) - len(outside)} of {len(common)} medians of this run lie within the intervals of the run before")
    for name in outside:
        median, low, high = first[name]
        print(f"  outside: {name} {second[name][0]:g}, before {median:g} [{low:g}, {high:g}]")
    return 1 if outside else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
