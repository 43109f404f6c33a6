# Untrusted text through every field of every command: what reaches the terminal, Markdown and HTML of it.
# usage: untrusted.py EVERY PROGRAM PLUGIN RESULTS…, in an empty directory; exits with 1 and says where something got
# through. Of all runs, one in EVERY is made: 1 is the long form.
import copy
import hashlib
import json
import os
import re
import subprocess
import sys

every, program = int(sys.argv[1]), sys.argv[2]

TAG = "<script>alert(1)</script>"
EVERYTHING = ("\x1b[31mred\x1b]0;title\x07\nFORGED: line\r\x00\x7f\u009b31m\u202egnp.exe\u2066\u2028\ufeff" + TAG +
              "|`code`[link](x)*b*&amp;$x_1$\\")
HOSTILE = [EVERYTHING, EVERYTHING + "w" * 10_000, "plain\nFORGED: line"]
# A file's name or an option holds no NUL.
ON_COMMAND_LINE = [h.replace("\x00", "") for h in HOSTILE] + ["\udcff\udcc3(latin\udce9"]

HIDDEN = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ufeff]")
problems, runs, turns = [], 0, 0


def complain(where, what):
    problems.append(where)
    if len(problems) <= 40:
        print(f"{where}: {what}", file=sys.stderr, flush=True)


def look_at(where, name, data):
    """Nothing in the bytes steers a terminal, and no line of them is one that the text made."""
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        return complain(where, f"{name} is not UTF-8: {error}")
    if found := HIDDEN.search(text):
        complain(where, f"{name} holds {found.group()!r} in {text[max(0, found.start() - 40):found.end() + 40]!r}")
    if re.search("^FORGED", text, re.M):
        complain(where, f"{name} holds a line that the text made")
    return text


def look_at_files(where, directory):
    for folder, _, names in os.walk(directory):
        for name in names:
            if not name.endswith((".md", ".html")):
                continue
            text = look_at(where, name, open(os.path.join(folder, name), "rb").read().replace(b"\t", b" ")) or ""
            if TAG in text:
                complain(where, f"{name} holds the tag")
            if name.endswith(".md") and re.search(r"(?<!\\)`code`|(?<!\\)\|`|\[link\]\(", text):
                complain(where, f"{name} holds markup")


def is_due():
    global runs, turns
    turns += 1
    if turns % every:
        return False
    runs += 1
    return True


def run(where, *arguments, out=None):
    """Runs the program and looks at all it says; of an error, at its one line. None if it is not due."""
    if not is_due():
        return None
    done = subprocess.run([program, *arguments], capture_output=True, stdin=subprocess.DEVNULL, timeout=120)
    where = f"{arguments[0]}, {where}"
    said, error = look_at(where, "standard output", done.stdout), look_at(where, "standard error", done.stderr)
    if done.returncode in (0, 1, 8):
        if error and done.returncode != 1:
            complain(where, f"exit {done.returncode} with {error!r}")
    elif done.returncode not in (2, 3, 7):
        complain(where, f"exit {done.returncode}: {error!r}")
    elif error is None or error.count("\n") != 1 or not error.endswith("\n") or len(error.encode()) > 1200 or said:
        complain(where, f"no single line of an error: {(error or '')[:200]!r}, {(said or '')[:200]!r}")
    if out:
        look_at_files(where, out)
    return done.returncode


def fresh(name):
    subprocess.run(["rm", "-rf", name], check=True)
    return name


def write(name, text):
    with open(name, "wb") as file:
        file.write(text if isinstance(text, bytes) else text.encode("utf-8", "surrogateescape"))
    return name


def lines(objects):
    return "".join(json.dumps(o) + "\n" for o in objects)


def raw_lines(objects):
    """The same with characters as they are, but for those that JSON must escape."""
    return "".join(json.dumps(o, ensure_ascii=False) + "\n" for o in objects)


def variants(value, text, path=()):
    """(path, changed value), for each string, key, number or list in it, which the text replaces."""
    if isinstance(value, dict):
        yield path + ("a key",), {**value, text: 1}
        for key in value:
            for p, changed in variants(value[key], text, path + (key,)):
                yield p, {**value, key: changed}
    elif isinstance(value, list):
        yield path, text
        if value:
            for p, changed in variants(value[0], text, path + (0,)):
                yield p, [changed] + value[1:]
    else:
        yield path, text


TRIANGLE = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
CASE = {"id": "a", "fmt": "binary64", "seg": [[0.25, 0.25, 1], [0.25, 0.25, -1]], "tri": TRIANGLE, "expect": 1,
        "class": "C017", "source": "s",
        "finding": {"method": "sf-double", "outcome": "false miss", "severity": "plain", "cause": "logic",
                    "answered": 0, "expected": 1, "origin": {"family": "affine", "file": "f"}, "detail": "d",
                    "fault": "threw", "answers": {"sf-double": 1}}}


def right_class():
    """The class of the case, which its finding and its claim need."""
    done = subprocess.run([program, "classify", "--method", "sf-rational", "--in", write("case.jsonl", lines([{k: CASE[k] for k in ("id", "seg", "tri")}]))],
                          capture_output=True, check=True)
    return json.loads(done.stdout)["class"]


def try_cases():
    CASE["class"] = right_class()
    wrong = {**CASE, "expect": 0}
    wrong.pop("class")
    write("answers.jsonl", lines([{"id": "a", "hit": 1}]))
    commands = [("classify", "--method", "sf-double,mt-float", "--in"), ("check", "--method", "sf-double", "--exact"),
                ("replay",), ("replay", "--emit", "c"), ("replay", "--emit", "gtest"), ("replay", "--emit", "python"),
                ("shrink",), ("shrink", "--method", "sf-double"), ("judge", "--answers", "answers.jsonl", "--cases"),
                ("fuzz", "--count", "10", "--method", "sf-double", "--cases")]
    for number, text in enumerate(HOSTILE):
        changed = [(p, c) for base in (CASE, wrong) for p, c in variants(base, text)]
        for path, case in changed:
            name = write("hostile.jsonl", (lines if number % 2 else raw_lines)([case]))
            deep = len(path) > 1 and path[0] in ("seg", "tri")
            for command in commands[:1] if deep or (number == 1 and path[0] == "finding") else commands:
                run(f"{path} of a case is text {number}", *command, name)
    # Claims and answers about a case of this id.
    for number, text in enumerate(HOSTILE):
        for name, case in (("wrong.jsonl", {**wrong, "id": text}), ("right.jsonl", {**CASE, "id": text})):
            write(name, lines([case]))
            for hit in (0, 1, None):
                write("answers.jsonl", lines([{"id": text, "hit": hit} if hit is not None else {"id": "b", "hit": 1}]))
                run(f"an id is text {number}", "judge", "--cases", name, "--answers", "answers.jsonl", "--out", fresh("judged"), out="judged")
        write("twice.jsonl", lines([{**CASE, "id": text}] * 2))
        run(f"an id twice is text {number}", "judge", "--cases", "twice.jsonl", "--answers", "answers.jsonl")
        nonfinite = {"id": text, "seg": [["nan", 0, 0], [0, 0, 0]], "tri": TRIANGLE}
        write("nonfinite.jsonl", lines([nonfinite]))
        write("answers.jsonl", lines([{"id": text, "hit": 1}]))
        run(f"an id is text {number}, not finite", "judge", "--cases", "nonfinite.jsonl", "--answers", "answers.jsonl", "--out", fresh("judged"), out="judged")
        for command in commands[:8]:
            run(f"an id is text {number}, not finite", *command, "nonfinite.jsonl")
    for broken in (b'{"id":"\xff\xfe","seg":1}\n', b'{"id":"\xc3("}', b"\xff\n", b"\x1b[31m\n", b'{"id":"a\x1b[31m"}\n', b'{"a":1,"\x1b\\u001b":2,"a":3}'):
        run(f"a line is {broken!r}", "classify", "--method", "sf-double", "--in", write("broken.jsonl", broken))
        run(f"a line is {broken!r}", "judge", "--cases", "right.jsonl", "--answers", "broken.jsonl")


def try_answers():
    write("case.jsonl", lines([CASE]))
    answers = [{"id": "a", "method": "mine", "hit": 0, "status": "ok", "t": 2, "weights": [0.5, 0.5]},
               {"id": "a", "method": "mine", "hit": 1, "contact": "edge", "side": "front", "class": "C017", "at": "between", "stage": "exact"},
               {"id": "a", "method": "mine", "status": "failed", "fault": "threw", "detail": "d"}]
    for number, text in enumerate(HOSTILE):
        for answer in answers:
            for path, changed in variants(answer, text):
                write("answers.jsonl", lines([changed]))
                code = run(f"{path} of an answer is text {number}", "judge", "--cases", "case.jsonl", "--answers", "answers.jsonl", "--out", fresh("judged"), out="judged")
                if path[0] == "method" and code not in (None, 3):
                    complain("judge", f"a method's name is text {number}: exit {code}, expected 3")
    for name in ("", "2fast", "a b", "a/b", "naïve", "<b>", "a|b", "a" * 33):
        write("answers.jsonl", lines([{"id": "a", "method": name, "hit": 1}]))
        if run(f"a method's name is {name!r}", "judge", "--cases", "case.jsonl", "--answers", "answers.jsonl") not in (None, 3):
            complain("judge", f"the method's name {name!r} is taken")


def try_meshes():
    write("tetra.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")
    ray = {"id": "1", "fmt": "binary64", "ray": {"o": [0.25, 0.25, 5], "d": [0, 0, -1]}, "aimed_at": "face 1"}
    answers = [{"id": "1", "method": "mine", "closest": {"face": 7, "t": 0.5, "normal": [0, 0, 1], "side": "front"}, "any": 1, "all": [{"face": 1, "t": 1}], "inside": 0},
               {"id": "1", "method": "mine", "status": "failed", "fault": "crashed", "detail": "SIGSEGV"}]
    judge = ("judge", "--mesh", "tetra.off", "--rays", "rays.jsonl", "--answers", "answers.jsonl", "--out")
    for number, text in enumerate(HOSTILE):
        write("answers.jsonl", lines([{"id": "1", "any": 1}]))
        for path, changed in variants(ray, text):
            write("rays.jsonl", lines([changed]))
            run(f"{path} of a ray is text {number}", *judge, fresh("judged"), out="judged")
        write("rays.jsonl", lines([ray]))
        for answer in answers:
            for path, changed in variants(answer, text):
                write("answers.jsonl", lines([changed]))
                run(f"{path} of an answer to a ray is text {number}", *judge, fresh("judged"), out="judged")
        word = text.split("\n")[0] + text.split("\n")[1].replace("\x00", "") if number < 2 else "word"
        for name, content in (("x.off", f"{word}\n3 1 0\n"), ("x.off", f"OFF\n3 1 0\n0 0 {word}\n"), ("x.obj", f"{word} 1 2\n"), ("x.obj", f"v 0 0 {word}\n"),
                              ("x.ply", f"ply\nformat {word} 1.0\nelement {word} 1\n"), ("x.ply", f"ply\nformat ascii 1.0\nelement vertex 1\nproperty {word} x\nend_header\n"),
                              ("x.stl", f"solid {word}\n{word}\n"), ("x.stl", word), ("x.ply", text), ("x.off", text), ("x.obj", text)):
            write(name, content)
            run(f"a word of {name} is text {number}", "leak", name, "--method", "sf-double")
            run(f"a word of {name} is text {number}", "render", name, "--method", "sf-double", "-o", "x.png")
    for extension in ("off", "obj", "ply", "stl"):
        run(f"bytes that are no UTF-8 in {extension}", "leak", write("x." + extension, b"OFF\xff\x9b\n\x1b 1 0\n"), "--method", "sf-double")


def try_scenes():
    solid = {"description": "d", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "faces": [[0, 1, 2]]}
    scene = {"description": "d", "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0], "fov": 40, "width": 4, "height": 4},
             "solids": [{"name": "n", "vertices": solid["vertices"], "faces": solid["faces"]}], "depth": 1}
    render = ("render", "scene.json", "--method", "mt-float", "-o", "x.png", "--stats", "stats.json", "--against", "sf-filtered")
    for number, text in enumerate(HOSTILE):
        for path, changed in variants(scene, text):
            write("scene.json", json.dumps(changed))
            run(f"{path} of a scene is text {number}", *render)
        for key in ("mesh", "solid"):
            write("scene.json", json.dumps({**scene, "solids": [{key: text}]}))
            run(f"the {key} of a scene is text {number}", *render)
        write("scene.json", json.dumps({**scene, "solids": [{"solid": "solid.json"}]}))
        for path, changed in variants(solid, text):
            write("solid.json", json.dumps(changed))
            run(f"{path} of a solid is text {number}", *render)


def try_command_lines():
    """Each option with a value, and each argument, as the help lists them."""
    commands = re.findall(r"^  ([a-z]+) ", subprocess.run([program, "--help"], capture_output=True, text=True).stdout, re.M)
    assert len(commands) > 12
    for number, text in enumerate(ON_COMMAND_LINE):
        bytes_of = os.fsencode(text)
        for word in (bytes_of, b"--" + bytes_of):
            check_usage(f"text {number}", [word])
        for command in commands:
            usage = subprocess.run([program, command, "--help"], capture_output=True, text=True).stdout
            options = re.findall(r"(--[a-z-]+) [A-Z]", usage)
            check_usage(f"{command} text {number}", [command.encode(), bytes_of])
            for option in options:
                check_usage(f"{command} {option} text {number}", [command.encode(), option.encode(), bytes_of])
                check_usage(f"{command} {option}=text {number}", [command.encode(), option.encode() + b"=" + bytes_of])


def check_usage(where, arguments):
    if not is_due():
        return
    done = subprocess.run([os.fsencode(program), *arguments], capture_output=True, stdin=subprocess.DEVNULL, timeout=60)
    look_at(where, "standard error", done.stderr)
    if done.returncode != 2 or done.stderr.count(b"\n") != 1 or done.stdout or len(done.stderr) > 1200:
        complain(where, f"exit {done.returncode}, expected 2 and one line: {done.stderr[:200]!r}")


def sealed(records):
    """A log with a chain of hashes that holds."""
    head, text = "0" * 64, ""
    for record in records + [{"record": "end", "records": len(records)}]:
        dump = lambda r: json.dumps(r, ensure_ascii=False, separators=(",", ":"))
        head = hashlib.sha256((head + dump(record)).encode()).hexdigest()
        text += dump({**record, "sha256": head}) + "\n"
    return text


def places(value, path=()):
    """Each string, and each key of an object, once for all items of a list."""
    if isinstance(value, dict):
        for key in value:
            yield path + (key,), "key"
            yield from places(value[key], path + (key,))
    elif isinstance(value, list):
        for item in value[:2]:
            yield from places(item, path + (value.index(item),))
    elif isinstance(value, str):
        yield path, "value"


def replaced(value, path, kind, text):
    changed = copy.deepcopy(value)
    at = changed
    for step in path[:-1]:
        at = at[step]
    if kind == "key":
        at[text] = at.pop(path[-1])
    else:
        at[path[-1]] = text
    return changed


def try_logs():
    case = {k: CASE[k] for k in ("id", "seg", "tri")}
    write("case.jsonl", lines([case, {"id": "b", "seg": [["inf", 0, 0], [0, 0, 0]], "tri": TRIANGLE}]))
    write("answers.jsonl", lines([{"id": "a", "method": "mine", "status": "failed", "fault": "threw", "detail": "d"}, {"id": "b", "method": "mine", "hit": 1}]))
    subprocess.run([program, "judge", "--cases", "case.jsonl", "--answers", "answers.jsonl", "--out", fresh("log")], capture_output=True)
    records = [json.loads(line) for line in open("log/log.jsonl")][:-1]
    for r in records:
        del r["sha256"]
    text = sealed(records)
    if text != open("log/log.jsonl").read():
        complain("log", "sealed otherwise than by the program: this test is of no use")
    certificate = json.load(open("log/certificate.json"))
    for i, record in enumerate(records):
        for path, kind in places(record):
            for text in HOSTILE[:2] if len(path) == 1 else HOSTILE[:1]:
                write("log/log.jsonl", sealed(records[:i] + [replaced(record, path, kind, text)] + records[i + 1:]))
                run(f"{kind} {path} of record {i}", "verify", "log")
    write("log/log.jsonl", sealed(records))
    for path, kind in places(certificate):
        write("log/certificate.json", json.dumps(replaced(certificate, path, kind, EVERYTHING)))
        run(f"{kind} {path} of a certificate", "verify", "log")
        run(f"{kind} {path} of a certificate", "report", "log", "--out", "page.html", out=".")
        fresh("page.html")


def try_results(results):
    """Records of other commands, as report and redraw read them: each kind of place once."""
    for directory in results:
        for name in sorted(os.listdir(directory)):
            if not name.endswith((".json", ".jsonl")) or name == "log.jsonl":
                continue
            file = os.path.join(directory, name)
            kept = open(file, encoding="utf-8").read()
            record = json.loads(kept if name.endswith(".json") else kept.splitlines()[0]) if kept.strip() else {}
            rest = "" if name.endswith(".json") else "\n" + "\n".join(kept.splitlines()[1:])
            seen = set()
            for path, kind in places(record):
                general = (kind,) + tuple("*" if isinstance(p, int) else p for p in path)
                if general in seen or len(path) > 4:
                    continue
                seen.add(general)
                write(file, json.dumps(replaced(record, path, kind, EVERYTHING)) + rest)
                run(f"{kind} {path} of {file}", "report", directory, "--out", "page.html", out=".")
                fresh("page.html")
                redraw = {"sweep.json": "sweep", "chart.json": "chart"}.get(name)
                if redraw and len(path) < 3:
                    run(f"{kind} {path} of {file}", redraw, "--redraw", directory)
            write(file, kept)


def try_names(results):
    """Directories that report walks, and meshes that a scene names, may be called anything."""
    for number, text in enumerate(ON_COMMAND_LINE):
        name = os.fsencode(text).replace(b"/", b"")[:200]
        inner = os.path.join(os.fsencode(fresh("walked")), name)
        os.makedirs("walked")
        subprocess.run([b"cp", b"-r", os.fsencode(results[0]), inner], check=True)
        write(os.path.join(inner, name + b".off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        code = run(f"a directory is called text {number}", "report", "walked", "--out", "page.html", "--json", "page.json", out=".")
        if code != 0:
            complain(f"a directory is called text {number}", f"report: exit {code}")
        fresh("page.html")
        fresh("walked")


def try_plugin(library):
    for isolate in ([], ["--isolate"]):
        for command in (("fuzz", "--method", "faulty", "--family", "affine", "--count", "100", "--keep", "1", "--out", "found"),
                        ("replay", "found/counterexamples.jsonl"), ("shrink", "found/counterexamples.jsonl"),
                        ("classify", "--method", "faulty", "--in", "found/counterexamples.jsonl"),
                        ("check", "found/counterexamples.jsonl", "--method", "faulty"), ("report", "found", "--out", "found/page.html"), ("methods",)):
            plugin = [] if command[0] == "report" else ["--plugin", library, *isolate]
            run("what a plugin throws", *command, *plugin, out="found")


if __name__ == "__main__":
    library, results = sys.argv[3], sys.argv[4:]
    for part in (try_cases, try_answers, try_meshes, try_scenes, try_command_lines, try_logs):
        part()
    try_results(results)
    every = 1
    try_names(results)
    try_plugin(library)
    print(f"tried {runs}, broke {len(problems)}: runs with untrusted text in one field")
    sys.exit(1 if problems else 0)
