#!/usr/bin/env python3
"""Changes the floating-point environment or the locale under small runs of each command: before main, in every new thread,
at the n-th allocation, and from a timer.

What is there from the start of a thread must change no byte of the result, and a locale must never change one. Where the
floating-point environment changes later, the run must end with that result, or with exit code 4 and one line. Prints what was
tried, and a last line `tried N, broke M: …`; exits with 1 where anything broke.
"""
import argparse
import os
import subprocess
import sys
import tempfile

import commands

FLOATING = ["ftz", "daz", "down", "up", "zero", "x87-53", "x87-24", "x87-up", "traps", "all"]
LOCALES = ["locale", "c++locale"]
THREADED = ["fuzz-threads", "render-threads", "certify", "verify"]

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--program", required=True)
parser.add_argument("--source", required=True)
parser.add_argument("--most", type=int, default=60, metavar="N", help="moments of a later change, a command and change")
parser.add_argument("--scratch")
parser.add_argument("--commands", default=",".join(commands.COMMANDS), metavar="NAME,…")
parser.add_argument("--changes", default=",".join(FLOATING + LOCALES), metavar="NAME,…")
parser.add_argument("--when", default="start,threads,malloc,timer")
options = parser.parse_args()
names = options.commands.split(",")
scratch = os.path.abspath(tempfile.mkdtemp(dir=options.scratch))
inputs, shim, locales = (os.path.join(scratch, name) for name in ("inputs", "environment.so", "locales"))
program = os.path.abspath(options.program)
subprocess.run([os.environ.get("CXX", "g++"), "-std=c++20", "-shared", "-fPIC", "-O1", "-o", shim,
                os.path.join(options.source, "tests/faults/environment.cpp"), "-ldl"], check=True)
os.makedirs(locales)
subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", os.path.join(locales, "de_DE.UTF-8")], check=True)
commands.prepare(program, options.source, inputs, names)
clean = {name: commands.Expected(program, name, inputs, os.path.join(scratch, "clean"), {}) for name in names}
tried, broken, happened = 0, [], set()


def attempt(name, change, when, expected_to_hold, after=0):
    """One run; notes what broke. Whether the change happened."""
    global tried
    changed = os.path.join(scratch, "changed")
    got = commands.run(program, name, inputs, os.path.join(scratch, "run"),
                       {"LD_PRELOAD": shim, "CHANGE_TO": change, "CHANGE_WHEN": str(when), "CHANGE_AFTER": str(after),
                        "CHANGED": changed, "LOCPATH": locales, "LC_ALL": "C"})
    did = os.path.exists(changed)
    if not did:
        return False
    os.remove(changed)
    tried += 1
    if got.exit == 4 and not expected_to_hold:
        why = clean[name].half_results(got) + ([] if commands.one_line(got) else ["not one line"])
    else:
        why = clean[name].differences(got)
    if why:
        broken.append((name, change, when))
        print(f"    {name} {change} {when}: {'; '.join(why)}: {got.err.decode(errors='replace').strip()[:300]}", flush=True)
    return True


for name in names:
    before = len(broken), tried
    for change in options.changes.split(","):
        is_locale = change in LOCALES
        for when in ("start", "threads"):
            if when in options.when and (when == "start" or name in THREADED) and attempt(name, change, when, True):
                happened.add(when)
        if "malloc" in options.when:
            step, n = 1, 3
            for _ in range(options.most):
                if not attempt(name, change, n, is_locale):
                    break
                happened.add("malloc")
                n += step
                step = max(step + 1, n // 6)
        if "timer" in options.when and not is_locale:
            for k in range(1, 1 + options.most // 6):
                if not attempt(name, change, "timer", False, 2000 * k):
                    break
                happened.add("timer")
    print(f"{name:18} {tried - before[1]:6} changes, broke {len(broken) - before[0]}", flush=True)
never = set(options.when.split(",")) - happened
if never:
    broken.append(never)
    print(f"no change ever happened: {', '.join(sorted(never))}")
print(f"tried {tried}, broke {len(broken)}: changes of the floating-point environment and the locale")
sys.exit(1 if broken or tried == 0 else 0)
