"""Judges answers about the rays of a mesh in fractions, by docs/leak.md alone, and holds the counts against those of
`tribunal judge --json`: leak_oracle.py MESH RAYS ANSWERS JUDGED. Closed, oriented meshes without flat faces."""
import json
import math
import random
import sys
from collections import Counter
from fractions import Fraction as Q


def number(x):
    return float.fromhex(x) if isinstance(x, str) else float(x)


def sub(u, v):
    return [a - b for a, b in zip(u, v)]


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


class Mesh:
    def __init__(self, path):
        words = open(path).read().split()
        count, faces = int(words[1]), int(words[2])
        rest = iter(words[4:])
        self.vertices = [[Q(float(next(rest))) for _ in range(3)] for _ in range(count)]
        self.faces = [[int(next(rest)) for _ in range(int(next(rest)))] for _ in range(faces)]
        self.of_vertex = [{f for f, c in enumerate(self.faces) if v in c} for v in range(count)]
        corners = [[self.vertices[v] for v in c] for c in self.faces]
        self.corners, self.normals = corners, [cross(sub(b, a), sub(c, a)) for a, b, c in corners]

    def share(self, f, g):
        return bool(set(self.faces[f]) & set(self.faces[g]))


def weights(mesh, o, d, f):
    """t and the three weights where the line meets the plane of the face; None along it."""
    a, b, c = mesh.corners[f]
    n = mesh.normals[f]
    if dot(n, d) == 0:
        return None
    t = dot(n, sub(a, o)) / dot(n, d)
    p = [x + t * y for x, y in zip(o, d)]
    return t, [dot(n, cross(sub(w, v), sub(p, v))) for v, w in ((b, c), (c, a), (a, b))]


def crosses(mesh, o, d, f):
    found = weights(mesh, o, d, f)
    return found[0] if found and found[0] >= 0 and min(found[1]) >= 0 else None


def lies_along(mesh, o, d, f):
    """Whether the ray meets the face in its plane: by projection along the largest coordinate of its normal."""
    n, (a, b, c) = mesh.normals[f], mesh.corners[f]
    if dot(n, d) != 0 or dot(n, sub(o, a)) != 0:
        return False
    first, last = Q(0), None
    for v, w in ((a, b), (b, c), (c, a)):
        inward = cross(n, sub(w, v))
        at, slope = dot(inward, sub(o, v)), dot(inward, d)
        if slope == 0 and at < 0:
            return False
        if slope > 0:
            first = max(first, -at / slope)
        if slope < 0:
            last = -at / slope if last is None else min(last, -at / slope)
    return last is None or first <= last


class Ray:
    def __init__(self, mesh, o, d, ulp):
        self.mesh, self.o, self.d = mesh, o, d
        places = {}
        for f in range(len(mesh.faces)):
            t = crosses(mesh, o, d, f)
            if t is not None:
                places.setdefault(t, []).append(f)
        self.places = [places[t] for t in sorted(places)]
        self.along = [f for f in range(len(mesh.faces)) if lies_along(mesh, o, d, f)]
        self.on_surface = 0 in places or any(self.on_face(f) for f in self.along)
        self.met = {f for p in self.places for f in p} | set(self.along)
        self.ulp = ulp
        # A ray beside this one, in general position, crosses what all of them cross.
        tiny = [Q(random.randint(1, 10**9), 10**60) * max(map(abs, d)) for _ in range(3)]
        beside = [x + y for x, y in zip(d, tiny)]
        self.through = {f: 1 if dot(mesh.normals[f], beside) < 0 else -1
                        for f in range(len(mesh.faces)) if crosses(mesh, o, beside, f) is not None}
        self.near = {}
        self.passages = self.find_passages() if not self.on_surface else []

    def on_face(self, f):
        n = self.mesh.normals[f]
        return all(dot(n, cross(sub(w, v), sub(self.o, v))) >= 0
                   for v, w in zip(self.mesh.corners[f], self.mesh.corners[f][1:] + self.mesh.corners[f][:1]))

    def limit(self, *points):
        return 16 * self.ulp(max(abs(x) for p in (self.o, *points) for x in p))

    def near_vertex(self, v):
        if v not in self.near:
            p = self.mesh.vertices[v]
            k = sub(p, self.o)
            along = dot(k, self.d)
            gap = dot(k, k) - along * along / dot(self.d, self.d)
            self.near[v] = along >= 0 and gap <= self.limit(p) ** 2
        return self.near[v]

    def near_edge(self, v, w):
        key = (min(v, w), max(v, w))
        if key not in self.near:
            a, b = (self.mesh.vertices[i] for i in key)
            e, k, d = sub(b, a), sub(a, self.o), self.d
            det = dot(d, d) * dot(e, e) - dot(d, e) ** 2
            self.near[key] = False
            if det != 0:
                t = (dot(e, e) * dot(d, k) - dot(d, e) * dot(e, k)) / det
                u = (dot(d, e) * dot(d, k) - dot(d, d) * dot(e, k)) / det
                gap = [k[i] + u * e[i] - t * d[i] for i in range(3)]
                self.near[key] = t >= 0 and 0 <= u <= 1 and dot(gap, gap) <= self.limit(a, b) ** 2
        return self.near[key]

    def around(self, f):
        """Faces that share a near vertex or a near edge with this one."""
        corners, found = self.mesh.faces[f], set()
        for i, v in enumerate(corners):
            if self.near_vertex(v):
                found |= self.mesh.of_vertex[v]
            w = corners[(i + 1) % 3]
            if self.near_edge(v, w):
                found |= self.mesh.of_vertex[v] & self.mesh.of_vertex[w]
        return found

    def find_passages(self):
        passages, left = [], list(range(len(self.places)))
        while left:
            faces, new = set(), set(self.places[left[0]])
            while new:
                faces |= new
                new = set().union(*(self.around(f) for f in new)) - faces
            mine = [i for i in left if set(self.places[i]) & faces]
            left = [i for i in left if i not in mine]
            passages.append((mine, faces, sum(s for f, s in self.through.items() if f in faces) != 0))
        return passages

    def is_front(self, f):
        return dot(self.mesh.normals[f], sub(self.o, self.mesh.corners[f][0]))

    def stands_for(self, i, faces, g):
        if g in faces:
            return True
        side = self.is_front(g)
        return any(self.mesh.share(f, g) and (side == 0 or side * self.is_front(f) > 0) for f in self.places[i])

    def is_interior(self, i):
        return any(min(weights(self.mesh, self.o, self.d, f)[1]) > 0 for f in self.places[i])

    def is_passed(self, i):
        if self.is_interior(i):
            return True
        return not self.along and sum(f in self.through for f in self.places[i]) % 2 == 1

    def touches(self, g):
        return any(self.mesh.share(f, g) for f in self.met)

    def place_of(self, f):
        return next((i for i, p in enumerate(self.places) if f in p), None)


def judge_all(ray, hits, is_sorted):
    found, named = set(), [h["face"] for h in hits]
    reported = sorted(set(named))
    if len(reported) < len(named):
        found.add("double hit")
    order = [i for i in map(ray.place_of, named) if i is not None]
    if is_sorted and order != sorted(order):
        found.add("order")
    missed = [f for f in reported if f not in ray.met]
    for places, faces, due in ray.passages:
        told = any(f in faces or any(f in ray.places[i] for i in places) for f in reported if f in ray.met)
        for i in places:
            if any(f in ray.places[i] for f in reported) or not (due or ray.is_passed(i)):
                continue
            other = next((g for g in missed if ray.stands_for(i, faces, g)), None)
            if other is not None:
                found.add("neighbour")
                missed.remove(other)
                told = True
        if not told and due:
            found.add("leak")
        elif not told and any(map(ray.is_passed, places)):
            found.add("outline")
    found |= {"double hit" if ray.touches(g) else "false hit" for g in missed}
    if any(sum(f in p for f in reported) > 1 for p in ray.places):
        found.add("reported twice")
    return found | judge_none(ray, bool(hits))


def judge_none(ray, any_hit):
    """A ray from inside has a passage that is due."""
    return {"leak", "lost"} if not any_hit and any(due for _, _, due in ray.passages) else set()


def judge_any(ray, answer):
    return judge_none(ray, answer) | ({"false hit"} if answer and not ray.met else set())


def judge_closest(ray, hit):
    if hit is None:
        return judge_none(ray, False)
    f, found = hit["face"], set()
    if f in ray.along:
        return found
    if f not in ray.met and not ray.touches(f):
        found.add("false hit")
    for i in range(len(ray.places)):
        places, faces, due = next(p for p in ray.passages if i in p[0])
        if not due and f not in ray.places[i]:
            continue
        if any(f in ray.places[j] for j in places):
            return found
        beside = f not in ray.met and any(ray.stands_for(j, faces, f) for j in places)
        return found | ({"neighbour"} if beside else {"closest"})
    return found


def ulp_of(fmt):
    if fmt == "binary64":
        return lambda x: Q(math.ulp(float(x)))
    return lambda x: Q(2) ** (math.frexp(float(x))[1] - 24)


if __name__ == "__main__":
    mesh = Mesh(sys.argv[1])
    rays = {}
    for line in map(json.loads, open(sys.argv[2])):
        o, d = ([Q(number(x)) for x in line["ray"][k]] for k in "od")
        rays[line["id"]] = Ray(mesh, o, d, ulp_of(line["fmt"]))
    judged, counts = Counter(), {}
    for line in map(json.loads, open(sys.argv[3])):
        ray = rays[line["id"]]
        if ray.on_surface:
            continue
        for kind, outcomes in (("all", judge_all(ray, line["all"], True)), ("any", judge_any(ray, line["any"] == 1)),
                               ("closest", judge_closest(ray, line["closest"]))):
            judged[line["method"] + "/" + kind] += 1
            counts.setdefault(line["method"] + "/" + kind, Counter()).update(outcomes)
    wrong = 0
    for subject in json.load(open(sys.argv[4]))["trials"][0]["subjects"]:
        name, said = subject["name"], subject["all"]
        kinds = ("leak", "lost", "false hit", "double hit", "neighbour", "reported twice", "outline", "order", "closest")
        here = {k: counts[name][k] for k in kinds}
        there = {k: said[k] for k in kinds}
        print(name, here)
        if here != there or judged[name] != said["rays"]:
            print("  but judge says", there, judged[name], said["rays"])
            wrong += 1
    sys.exit(wrong)
