#!/usr/bin/env python3
"""Checks counterexample files of polygons with nothing but fractions (and check_counterexample.py beside it):
  python3 check_polygon_counterexample.py counterexamples.jsonl
For each line: contact and planarity of "finding.exact" are computed again, and the answer blamed is held against them.
Ring edges are met or not by Caratheodory's theorem; inside is an odd number of half-open crossings, exactly where the
probe meets the plane; of a polygon that is not planar, an odd signed count of the covering's triangles, those pierced
on a spoke counting half. Cases with "tri" among them are checked as there. Exit code 0: everything is confirmed."""
import sys
from fractions import Fraction

from check_counterexample import check as check_triangle, cross, det, is_wrong, meet, number, read_cases, report, sign, sub

def dot(u, v): return sum(a * b for a, b in zip(u, v))
def edges(rings): return [(ring[i - 1], v) for ring in rings for i, v in enumerate(ring)]

def meets(probe, points):
    """Does the probe meet the hull of one or two points?"""
    p, q = probe["from"], probe["to"]
    if probe["ray"]: return meet([sub(v, p) for v in points] + [[-x for x in q]], len(points))
    return meet([sub(v, s) for s in (p, q) for v in points], 2 * len(points))

def normal_of(vertices):
    """Of three vertices that are not on a line; zero if there are none."""
    spokes = [sub(v, vertices[0]) for v in vertices[1:]]
    return next((n for u in filter(any, spokes) for w in spokes if any(n := cross(u, w))), [0] * 3)

def crossing(probe, o, n):
    """Where the probe crosses the plane through o, if it does: exactly, by t in [0, 1] or [0, infinity)."""
    slope = dot(n, probe["d"])
    if slope == 0: return None
    t = dot(n, sub(o, probe["from"])) / slope
    return [a + t * b for a, b in zip(probe["from"], probe["d"])] if t >= 0 and (probe["ray"] or t <= 1) else None

def inside(x, rings, n):
    """The parity of half-open crossings, projected along an axis on which n does not vanish. x is on no ring edge."""
    drop = next(k for k in range(3) if n[k])
    i, j = (k for k in range(3) if k != drop)
    odd = False
    for a, b in edges(rings):
        if (a[j] > x[j]) != (b[j] > x[j]):
            odd ^= x[i] < a[i] + (b[i] - a[i]) * (x[j] - a[j]) / (b[j] - a[j])
    return odd

def covering_is_crossed(probe, rings):
    o, total = rings[0][0], Fraction(0)
    for a, b in edges(rings):
        n = cross(sub(a, o), sub(b, o))
        x = crossing(probe, o, n) if any(n) else None
        if x is None: continue
        weights = [dot(n, cross(sub(v, x), sub(w, x))) for v, w in ((a, b), (b, o), (o, a))]
        if min(weights) >= 0: total += sign(dot(n, probe["d"])) * Fraction(1, 1 if min(weights[1:]) > 0 else 2)
    return total.denominator == 1 and total % 2 == 1

def exact_answer(case):
    rings = [[[number(x) for x in v] for v in ring] for ring in case["rings"]]
    ends = [[number(x) for x in v] for v in (case["seg"] if "seg" in case else (case["ray"]["o"], case["ray"]["d"]))]
    probe = {"from": ends[0], "to": ends[1], "ray": "ray" in case, "d": ends[1] if "ray" in case else sub(*ends[::-1])}
    vertices = sum(rings, [])
    o, n = vertices[0], normal_of(vertices)
    planar = all(dot(n, sub(v, o)) == 0 for v in vertices)
    in_plane = planar and dot(n, sub(probe["from"], o)) == dot(n, probe["d"]) == 0
    if any(meets(probe, e) for e in edges(rings)):
        contact = "coplanar" if in_plane else "vertex" if any(meets(probe, [v]) for v in vertices) else "edge"
    elif not planar:
        contact = "interior" if covering_is_crossed(probe, rings) else "none"
    else:
        x = probe["from"] if in_plane else crossing(probe, o, n)
        hit = any(n) and x is not None and inside(x, rings, n)
        contact = ("coplanar" if in_plane else "interior") if hit else "none"
    return {"contact": contact, "planar": planar}

def check(case):
    if "rings" not in case: return check_triangle(case)
    exact, finding = exact_answer(case), case.get("finding", {})
    hit = exact["contact"] != "none"
    due = int(hit and not (exact["contact"] == "coplanar" and finding.get("convention") == "transversal"))
    if not finding: return case.get("expect", hit) == hit
    return finding["exact"] == exact and case["expect"] == hit and is_wrong(finding, due, **exact)

if __name__ == "__main__":
    report(read_cases(sys.argv[1]) if len(sys.argv) == 2 else sys.exit(__doc__), check)
