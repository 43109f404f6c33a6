#!/usr/bin/env python3
"""Checks counterexample files with nothing but fractions:  python3 check_counterexample.py counterexamples.jsonl
For each line: the signs and t of "finding.exact" are computed again, whether segment (or ray) and triangle meet is
decided by Caratheodory's theorem, and the answer blamed is held against it. Exit code 0: everything is confirmed."""
import itertools, json, sys
from fractions import Fraction

def number(x): return Fraction(float.fromhex(x) if isinstance(x, str) else x)
def sign(x): return (x > 0) - (x < 0)
def sub(u, v): return [a - b for a, b in zip(u, v)]
def cross(u, v): return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
def det(u, v, w): return sum(a * b for a, b in zip(u, cross(v, w)))

def convex(coefficients, subset, points):
    """A dependency that is a convex combination: no two signs, and a point (not only the direction) takes part."""
    signs = set(map(sign, coefficients)) - {0}
    return len(signs) == 1 and any(c and i < points for c, i in zip(coefficients, subset))

def depends(w, subset, points):
    """Is 0 a convex combination of these one to four vectors, which depend on each other in one way or do not?"""
    if len(w) == 1:
        return subset[0] < points and not any(w[0])
    if len(w) == 2:
        return not any(cross(*w)) and any(convex((w[1][k], -w[0][k]), subset, points) for k in range(3))
    if len(w) == 3:
        c = [cross(w[1], w[2]), cross(w[2], w[0]), cross(w[0], w[1])]
        return det(*w) == 0 and any(convex([x[k] for x in c], subset, points) for k in range(3))
    return convex([(-1) ** k * det(*(w[:k] + w[k + 1:])) for k in range(4)], subset, points)

def meet(generators, points):
    """Is 0 in the hull of the first `points` generators plus the cone of the rest? All subsets of one to four."""
    subsets = (s for n in (1, 2, 3, 4) for s in itertools.combinations(range(len(generators)), n))
    return any(depends([generators[i] for i in s], s, points) for s in subsets)

def is_wrong(finding, due, contact, planar=True):
    """The answer blamed is the other one, or none (a fault); or the right one with something wrong told beside it."""
    if finding["expected"] != due: return False
    if finding.get("outcome") != "wrong contact": return finding.get("answered") != due
    told = finding["contact_told"], finding.get("planar_told", planar)
    turned = finding.get("side_told", "") != finding.get("side", "")
    return finding.get("answered") == due and (told != (contact, planar) or turned)

def along(o, d, t): return [x + t * v for x, v in zip(o, d)]

def part(ray, o, d, a, b, c):
    """Of a ray with bounds: the sides of the plane at tmin and tmax, and whether the part between meets the triangle."""
    start = along(o, d, number(ray["t"][0]))
    side = lambda x: sign(det(sub(b, a), sub(c, a), x))
    if ray["t"][1] == "inf":
        return side(sub(start, a)), side(d), meet([sub(v, start) for v in (a, b, c)] + [[-x for x in d]], 3)
    end = along(o, d, number(ray["t"][1]))
    return side(sub(start, a)), side(sub(end, a)), meet([sub(v, s) for s in (start, end) for v in (a, b, c)], 6)

def check(case):
    a, b, c = ([number(x) for x in v] for v in case["tri"])
    p, q = ([number(x) for x in v] for v in (case["seg"] if "seg" in case else (case["ray"]["o"], case["ray"]["d"])))
    near = det(sub(b, a), sub(c, a), sub(p, a))
    if "seg" in case:
        d, far = sub(q, p), det(sub(b, a), sub(c, a), sub(q, a))
        slope, hit = near - far, meet([sub(v, s) for s in (p, q) for v in (a, b, c)], 6)
    else:
        d, far = q, det(sub(b, a), sub(c, a), q)
        slope, hit = -far, meet([sub(v, p) for v in (a, b, c)] + [[-x for x in d]], 3)
    edges = [det(d, sub(u, p), sub(v, p)) for u, v in ((a, b), (b, c), (c, a))]
    exact = dict(zip(("abcp", "abcq", "pqab", "pqbc", "pqca"), map(sign, (near, far, *edges))))
    exact |= {"t": str(near / slope)} if slope else {}
    if "t" in case.get("ray", {}):
        exact["at_tmin"], exact["at_tmax"], hit = part(case["ray"], p, q, a, b, c)
    finding = case.get("finding", {"exact": None})
    coplanar = exact["abcp"] == exact["abcq"] == 0
    due = int(hit and not (coplanar and finding.get("convention") == "transversal"))
    contact = "coplanar" if coplanar else ("interior", "edge", "vertex", "vertex")[list(map(sign, edges)).count(0)]
    return finding["exact"] == exact and case["expect"] == hit and is_wrong(finding, due, contact)

def to_case(line):
    case = json.loads(line)
    if isinstance(case, dict) and "id" in case and case.keys() & {"seg", "ray"} and case.keys() & {"tri", "rings"}:
        return case
    raise ValueError("expected a case, with id, seg or ray, tri or rings")

def read_cases(path):
    """All cases of a file; or the end, with one line that says why."""
    cases, number = [], 0
    try:
        for number, line in enumerate(open(path, encoding="utf-8"), 1):
            if line.strip(): cases.append(to_case(line))
    except OSError as error: sys.exit(f"{path}: cannot read: {error.strerror}")
    except ValueError as error: sys.exit(f"{path}:{number}: {error}")
    return cases or sys.exit(f"{path}: holds no cases")

def report(cases, check):
    """Findings about a whole mesh carry no evidence of one triangle: they are counted, and left out."""
    of_meshes = [case for case in cases if isinstance(case.get("finding"), dict) and "method" in case["finding"] and
                 case["finding"].get("outcome") in ("leak", "lost", "false hit", "double hit", "parity", "closest", "order", "fault")
                 and "exact" not in case["finding"]]
    if of_meshes:
        print(f"{len(of_meshes)} of {len(cases)} cases are about a mesh: not checked")
        cases = [case for case in cases if case not in of_meshes] or sys.exit("no other case: nothing was checked")
    failed = [case["id"] for case in cases if not check(case)]
    print(f"{len(cases) - len(failed)} of {len(cases)} cases confirmed", *failed, sep="\n  ")
    sys.exit(bool(failed))

if __name__ == "__main__":
    cases = read_cases(sys.argv[1]) if len(sys.argv) == 2 else sys.exit(__doc__)
    rings = sum("rings" in case for case in cases)
    if rings: sys.exit(f"{sys.argv[1]}: {rings} of {len(cases)} cases have rings: ask check_polygon_counterexample.py")
    report(cases, check)
