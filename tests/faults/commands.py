"""Small runs of every command, to be run again and again under faults."""
import os
import re
import shutil
import subprocess

# Each in a folder of its own; "@" stands for the folder of inputs, which `prepare` makes.
COMMANDS = {
    "version": "--version",
    "help": "--help",
    "methods": "methods",
    "classify": "classify --method sf-filtered,sf-rational,sf-epeck,cgal-epick,mt-float --in @/cases.jsonl --out answers.jsonl",
    "classify-polygons": "classify --method sf-filtered,haines-double --in @/polygons.jsonl",
    "cases": "cases --family affine,ulp,near --fmt binary64 --count 12 --out cases.jsonl",
    "judge": "judge --cases @/cases.jsonl --answers @/answers.jsonl --out judged",
    "check": "check @/cases.jsonl --method sf-double --exact",
    "fuzz": "fuzz --method sf-double,mt-float --count 40 --family affine,ulp --threads 1 --out findings",
    "fuzz-threads": "fuzz --method sf-double,mt-float --count 40 --family affine,ulp --threads 3 --out findings",
    "shrink": "shrink @/findings/counterexamples.jsonl",
    "replay": "replay @/findings/counterexamples.jsonl",
    "certify": "certify --method sf-double --budget quick --threads 2 --out certificate",
    "verify": "verify @/certificate",
    "render": "render @/scene.json --method sf-double --against sf-filtered --threads 1 -o image.png --stats stats.json",
    "render-threads": "render @/scene.json --method sf-double --threads 3 -o image.png",
    "leak": "leak @/octahedron.off --method woop-float,sf-filtered --rays 200 --threads 1 --out leaks",
    "sweep": "sweep --method mt-double --axis scale --count 20 --threads 1 --out sweep",
    "sweep-map": "sweep --map edge --probe ray --method mt-double --map-size 6 --threads 1 --out sweep",
    "report": "report @/findings --out page.html",
    "isolated": "classify --plugin @/plugin.so --isolate --time-limit 60 --method my-mt --in @/cases.jsonl",
    "redraw": "chart --redraw @/chart",
}
SLOW = {"certify", "verify", "sweep", "sweep-map", "redraw"}  # seconds a run

OCTAHEDRON = """OFF
6 8 0
1 0 0
-1 0 0
0 1 0
0 -1 0
0 0 1
0 0 -1
3 0 2 4
3 2 1 4
3 1 3 4
3 3 0 4
3 2 0 5
3 1 2 5
3 3 1 5
3 0 3 5
"""
SCENE = """{"camera": {"eye": [3, 2, 2], "look_at": [0, 0, 0], "up": [0, 0, 1], "fov": 40, "width": 8, "height": 6},
 "solids": [{"mesh": "octahedron.off", "reflection": 0.3}], "lights": [{"position": [4, 1, 5]}]}
"""
POLYGONS = """{"id":"in","seg":[[1,1,-1],[1,1,1]],"rings":[[[0,0,0],[4,0,0],[4,4,0],[0,4,0]],[[2,2,0],[3,2,0],[3,3,0],[2,3,0]]]}
{"id":"hole","seg":[[2.5,2.5,-1],[2.5,2.5,1]],"rings":[[[0,0,0],[4,0,0],[4,4,0],[0,4,0]],[[2,2,0],[3,2,0],[3,3,0],[2,3,0]]]}
"""


def words(command, inputs):
    return COMMANDS[command].replace("@", inputs).split()


def prepare(program, source, inputs, names):
    """Makes the inputs of the named commands in a new folder."""
    os.makedirs(inputs)

    def write(name, text):
        with open(os.path.join(inputs, name), "w", encoding="utf-8") as file:
            file.write(text)

    def run(expected, *arguments):
        done = subprocess.run([program, *arguments], cwd=inputs, capture_output=True, text=True)
        if done.returncode != expected:
            raise SystemExit(f"tribunal {' '.join(arguments)}: exit {done.returncode}\n{done.stderr}")
        return done.stdout

    with open(os.path.join(source, "data/cases/classes163.jsonl"), encoding="utf-8") as file:
        write("cases.jsonl", "".join(file.readlines()[60:66]))
    write("octahedron.off", OCTAHEDRON)
    write("scene.json", SCENE)
    write("polygons.jsonl", POLYGONS)
    run(0, "classify", "--method", "sf-double", "--in", "cases.jsonl", "--out", "answers.jsonl")
    run(1, "fuzz", "--method", "sf-double,mt-float", "--count", "40", "--family", "ulp", "--threads", "1", "--out", "findings")
    lines = open(os.path.join(inputs, "findings/counterexamples.jsonl"), encoding="utf-8").readlines()
    write("findings/counterexamples.jsonl", lines[0])
    if "verify" in names:
        run(1, "certify", "--method", "sf-double", "--budget", "quick", "--threads", "2", "--out", "certificate")
    if "isolated" in names:
        compiled = [os.environ.get("CC", "cc"), "-O2", "-shared", "-fPIC", "-I", os.path.join(source, "exact/plugin"),
                    "-o", os.path.join(inputs, "plugin.so"), os.path.join(source, "docs/examples/moeller_trumbore.c"), "-lm"]
        subprocess.run(compiled, check=True)
    if "redraw" in names:
        run(0, "chart", "--quick", "--out", "chart")


def without_times(content):
    """The same with times and rates masked: at the end of a line, before a unit, in JSON."""
    return re.sub(rb'"seconds": ?[\d.e+-]+|[\d.]+ ?([kMG]?/s|s\b|(?=\n))', b"#", content)


class Result:
    """What a run left: its exit code, both streams, and the files of its folder."""

    def __init__(self, exit_code, out, err, files):
        self.exit, self.out, self.err = exit_code, without_times(out), err
        self.files = {n: without_times(b) if n.endswith(".json") else b for n, b in files.items()}


def run(program, command, inputs, folder, environment, seconds=120):
    """The result of a run in a new folder, which is removed. The exit code of one that does not end is None."""
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    try:
        done = subprocess.run([program, *words(command, inputs)], cwd=folder, env={**os.environ, **environment},
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=seconds)
        exit_code, out, err = done.returncode, done.stdout, done.stderr
    except subprocess.TimeoutExpired as late:
        exit_code, out, err = None, late.stdout or b"", late.stderr or b""
    files = {}
    for root, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(root, name)
            with open(path, "rb") as file:
                files[os.path.relpath(path, folder)] = file.read()
    shutil.rmtree(folder)
    return Result(exit_code, out, err, files)


class Expected:
    """What a run leaves without faults. Files that differ between two such runs hold other figures that are measured, and are only to exist."""

    def __init__(self, program, command, inputs, folder, environment):
        first = run(program, command, inputs, folder, environment)
        second = run(program, command, inputs, folder, environment)
        if first.exit is None or first.exit < 0 or first.exit != second.exit or first.files.keys() != second.files.keys():
            raise SystemExit(f"{command}: exit {first.exit}, {second.exit} without faults\n{first.err.decode()}")
        if first.exit not in (0, 1, 8):
            raise SystemExit(f"{command}: exit {first.exit} without faults\n{first.err.decode()}")
        self.exit, self.out = first.exit, first.out if first.out == second.out else None
        self.files = {n: b if second.files[n] == b else None for n, b in first.files.items()}

    def differences(self, got):
        """Why the result is another, as a list; empty where it is the same."""
        why = []
        if got.exit != self.exit:
            why.append(f"exit {got.exit}, expected {self.exit}")
        if self.out is not None and got.out != self.out:
            pairs = zip(got.out.splitlines() + [b""], self.out.splitlines() + [b""])
            lines = next((f"{g!r}, expected {e!r}" for g, e in pairs if g != e), "its end")
            why.append(f"other bytes on standard output: {lines}")
        for name in sorted(self.files.keys() | got.files.keys()):
            if name not in self.files or name not in got.files:
                why.append(f"{name} is {'missing' if name in self.files else 'left'}")
            elif self.files[name] is not None and self.files[name] != got.files[name]:
                why.append(f"other bytes in {name}")
        return why

    def half_results(self, got):
        """What a run that failed has left and should not have."""
        why = []
        if self.out is not None and not self.out.startswith(got.out):
            why.append("other bytes on standard output")
        for name, content in got.files.items():
            if name not in self.files:
                why.append(f"{name} is left")
            elif self.files[name] is not None and self.files[name] != content:
                why.append(f"half a file {name}")
        return why


def one_line(got):
    return got.err.count(b"\n") == 1 and got.err.endswith(b"\n")
