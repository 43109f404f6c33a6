"""great_face.py SHAPE N: one face of about N corners, as OFF."""
import math
import random
import sys


def comb(n):
    return [(i, 1000 * (i % 2)) for i in range(n)] + [(n, -10), (-1, -10)]


def star(n):
    corners = []
    for i in range(n // 2):
        x, y = math.cos(4 * math.pi * i / n), math.sin(4 * math.pi * i / n)
        corners += [(x, y), (x * 2.0**30 - y * 2.0**-20, y * 2.0**30 + x * 2.0**-20)]
    return corners


def wild(n):
    draw = random.Random(9)
    turns = (2 * math.pi * i / n for i in range(n))
    return [(math.ldexp(math.cos(t), e), math.ldexp(math.sin(t), e))
            for t in turns for e in [draw.randrange(-1000, 1000)]]


def zigzag(n):
    return [(i if k == 0 else n - i, 0) for i in range(n // 2) for k in range(2)] + [(n, n)]


SHAPES = {"comb": comb, "turned-comb": lambda n: [(-y, x) for x, y in comb(n)], "star": star, "wild": wild,
          "zigzag": zigzag}
corners = SHAPES[sys.argv[1]](int(sys.argv[2]))
sys.stdout.write(f"OFF\n{len(corners)} 1 0\n")
sys.stdout.writelines(f"{x!r} {y!r} 0\n" for x, y in corners)
sys.stdout.write(f"{len(corners)} {' '.join(map(str, range(len(corners))))}\n")
