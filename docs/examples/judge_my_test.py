#!/usr/bin/env python3
"""Answers the cases of a file with a test of one's own, for `tribunal judge`; linked with nothing.

    tribunal cases --family affine,ulp --fmt binary64 --count 10000 --out cases.jsonl
    python3 judge_my_test.py cases.jsonl >answers.jsonl
    tribunal judge --cases cases.jsonl --answers answers.jsonl --out judged

Put your own test in place of `meets`. With --exact the same lines compute with fractions, and `judge` finds nothing
wrong with them, as long as the triangle has an area and the segment is not in its plane: elsewhere this test has no
opinion, and says so; of rays and polygons it knows nothing, and says that too."""
import json
import sys
from fractions import Fraction


def number(x):
    """A coordinate: a JSON number or a C99 hex-float string."""
    return float.fromhex(x) if isinstance(x, str) else float(x)


def sub(u, v):
    return [a - b for a, b in zip(u, v)]


def signed_volume(a, b, c, x):
    """det(b - a, c - a, x - a), in the arithmetic of its operands."""
    u, v, w = sub(b, a), sub(c, a), sub(x, a)
    return (w[0] * (u[1] * v[2] - u[2] * v[1]) + w[1] * (u[2] * v[0] - u[0] * v[2])
            + w[2] * (u[0] * v[1] - u[1] * v[0]))


def meets(p, q, a, b, c):
    """Do the closed segment [p, q] and the closed triangle abc meet? None: outside of what this test can tell."""
    above, below = signed_volume(a, b, c, p), signed_volume(a, b, c, q)
    if above == 0 and below == 0:
        return None
    if (above > 0 and below > 0) or (above < 0 and below < 0):
        return False
    sides = [signed_volume(p, q, u, v) for u, v in ((a, b), (b, c), (c, a))]
    return all(s >= 0 for s in sides) or all(s <= 0 for s in sides)


def answer(case, arithmetic):
    line = {"id": case["id"], "method": "mine-" + arithmetic.__name__.lower()}
    if "seg" not in case or "tri" not in case:
        return line | {"status": "unsupported"}
    points = [[arithmetic(number(x)) for x in point] for point in case["seg"] + case["tri"]]
    hit = meets(*points)
    return line | ({"status": "unsupported"} if hit is None else {"hit": int(hit)})


if __name__ == "__main__":
    files = [word for word in sys.argv[1:] if word != "--exact"]
    if len(files) != 1:
        sys.exit(__doc__)
    try:
        for text in open(files[0], encoding="utf-8"):
            if text.strip():
                print(json.dumps(answer(json.loads(text), Fraction if "--exact" in sys.argv else float)))
    except OSError as error:
        sys.exit(f"{files[0]}: cannot read: {error.strerror}")
