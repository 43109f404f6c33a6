"""many_cases.py BASE COUNT: the cases of the file BASE over and over, COUNT lines, each with an id of its own."""
import sys

lines = [line.split('","', 1)[1] for line in open(sys.argv[1], encoding="ascii")]
count = int(sys.argv[2])
for begin in range(0, count, 10000):
    end = min(count, begin + 10000)
    sys.stdout.write("".join(f'{{"id":"case-{k}","{lines[k % len(lines)]}' for k in range(begin, end)))
