#!/usr/bin/env python3
"""Answers the rays of a mesh with a program of one's own, for `tribunal judge --mesh`; linked with nothing.

    tribunal leak mesh.off --rays 20000 --format binary64 --rays-out rays
    python3 judge_my_tree.py rays/binary64.off rays/binary64.jsonl >answers.jsonl
    tribunal judge --mesh rays/binary64.off --rays rays/binary64.jsonl --answers answers.jsonl --convention transversal

Put your own tree in place of `hits`. With --exact the same lines compute with fractions, and `judge` finds nothing
wrong with them."""
import json
import sys
from fractions import Fraction


def number(x):
    """A coordinate: a JSON number or a C99 hex-float string."""
    return float.fromhex(x) if isinstance(x, str) else float(x)


def sub(u, v):
    return [a - b for a, b in zip(u, v)]


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def read_mesh(path, arithmetic):
    """The corners of each face. The file holds what the rays were aimed at: triangles, and coordinates exact in the
    format of the rays."""
    words = open(path, encoding="utf-8").read().split()
    vertices, faces = int(words[1]), int(words[2])
    numbers = iter(words[4:])
    points = [[arithmetic(float(next(numbers))) for _ in range(3)] for _ in range(vertices)]
    return [[points[int(next(numbers))] for _ in range(int(next(numbers)))] for _ in range(faces)]


def meets(o, d, a, b, c):
    """t where the ray crosses the closed triangle (Möller & Trumbore 1997), or None. No face is met edge-on."""
    ab, ac, ao = sub(b, a), sub(c, a), sub(o, a)
    p = cross(d, ac)
    det = dot(ab, p)
    if det == 0:
        return None
    q, inverse = cross(ao, ab), 1 / det
    u, v, t = dot(ao, p) * inverse, dot(d, q) * inverse, dot(ac, q) * inverse
    return t if u >= 0 and v >= 0 and u + v <= 1 and t >= 0 else None


def hits(o, d, faces):
    """All (t, face), the nearest first."""
    found = ((meets(o, d, *corners), face) for face, corners in enumerate(faces))
    return sorted((t, face) for t, face in found if t is not None)


def answer(ray, faces, arithmetic):
    o, d = ([arithmetic(number(x)) for x in ray["ray"][key]] for key in "od")
    found = [{"face": face, "t": float(t)} for t, face in hits(o, d, faces)]
    line = {"id": ray["id"], "method": "mine-" + arithmetic.__name__.lower(), "all": found, "any": int(bool(found)),
            "closest": found[0] if found else None}
    if found:
        a, b, c = faces[found[0]["face"]]
        line["closest"]["normal"] = [float(x) for x in cross(sub(b, a), sub(c, a))]
    return line


if __name__ == "__main__":
    files = [word for word in sys.argv[1:] if word != "--exact"]
    if len(files) != 2:
        sys.exit(__doc__)
    arithmetic = Fraction if "--exact" in sys.argv else float
    try:
        mesh = read_mesh(files[0], arithmetic)
        for text in open(files[1], encoding="utf-8"):
            if text.strip():
                print(json.dumps(answer(json.loads(text), mesh, arithmetic)))
    except OSError as error:
        sys.exit(f"{error.filename}: cannot read: {error.strerror}")
