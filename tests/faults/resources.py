#!/usr/bin/env python3
"""Makes every n-th allocation, mapping and thread start of small runs of each command fail, once or for good.

Each run must end with exit code 7 and one line, or with the result of a run without faults. Allocations fail in copies of a
single run (resources.c): a copy that does not end at once as it should is tried again as a run of its own. Prints what was tried,
and a last line `tried N, broke M: …`; exits with 1 where anything broke.
"""
import argparse
import concurrent.futures
import os
import subprocess
import sys
import tempfile

import commands

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--program", required=True)
parser.add_argument("--source", required=True)
parser.add_argument("--most", type=int, default=100, metavar="N", help="runs of their own, a command and kind of fault, spread evenly")
parser.add_argument("--copies", type=int, default=0, metavar="N", help="copies of a run, about; 0: one for every allocation")
parser.add_argument("--jobs", type=int, default=1)
parser.add_argument("--scratch")
parser.add_argument("--commands", default=",".join(commands.COMMANDS), metavar="NAME,…")
parser.add_argument("--kinds", default="memory,map,threads")
options = parser.parse_args()
names = options.commands.split(",")
scratch = os.path.abspath(tempfile.mkdtemp(dir=options.scratch))
inputs, shim = os.path.join(scratch, "inputs"), os.path.join(scratch, "resources.so")
program = os.path.abspath(options.program)
subprocess.run([os.environ.get("CC", "cc"), "-shared", "-fPIC", "-O1", "-o", shim,
                os.path.join(options.source, "tests/faults/resources.c"), "-ldl"], check=True)
commands.prepare(program, options.source, inputs, names)
clean = {name: commands.Expected(program, name, inputs, os.path.join(scratch, "clean"), {}) for name in names}


def counted(name, kind, **more):
    """How often the run calls such a function, and in how many copies of it one failed."""
    count = os.path.join(scratch, "count")
    if os.path.exists(count):
        os.remove(count)
    got = commands.run(program, name, inputs, os.path.join(scratch, "counted"),
                       {"LD_PRELOAD": shim, "FAULT_WHAT": kind, "FAULT_AT": "0", "FAULT_COUNT": count, **more}, 3000)
    if not os.path.exists(count):
        raise SystemExit(f"{name}: no count; exit {got.exit}: {got.err.decode(errors='replace')}")
    why = clean[name].differences(got)
    if why:
        raise SystemExit(f"{name}: another result under the watch of {shim}: {'; '.join(why)}")
    with open(count, encoding="ascii") as file:
        return [int(word) for word in file.read().split()]


def others_in_copies(name, stride):
    """How many allocations failed in copies of the run, and the numbers of those after which one did not end as it should."""
    others = os.path.join(scratch, "others")
    open(others, "w", encoding="ascii").close()
    _, copies = counted(name, "memory", FAULT_ON="each", FAULT_AT=str(stride), FAULT_OTHERS=others,
                        FAULT_LINE="tribunal: out of memory\n")
    with open(others, encoding="ascii") as file:
        return copies, [int(line) for line in file]


def chosen(total, most):
    """Which calls fail: all of them, or the first and the last few and as many as that between."""
    if total <= most:
        return list(range(1, total + 1))
    edge = most // 4
    inner = most - 2 * edge
    between = [edge + 1 + (total - 2 * edge) * i // inner for i in range(inner)]
    return sorted({*range(1, edge + 1), *between, *range(total - edge + 1, total + 1)})


def fault_in(name, kind, on, n):
    """Whether the fault happened, and what was wrong with the run's end, or nothing."""
    folder = os.path.join(scratch, f"{name}.{kind}.{on}.{n}")
    fired = folder + ".fired"
    got = commands.run(program, name, inputs, folder,
                       {"LD_PRELOAD": shim, "FAULT_WHAT": kind, "FAULT_ON": on, "FAULT_AT": str(n), "FAULT_FIRED": fired})
    happened = os.path.exists(fired)
    if happened:
        os.remove(fired)
    if got.exit == 7:
        why = clean[name].half_results(got)
        if not happened:
            why.append("exit 7 without a fault")
        if not commands.one_line(got):
            why.append("not one line")
    else:
        why = clean[name].differences(got)
    return happened, f"{'; '.join(why)}: {got.err.decode(errors='replace').strip()[:300]}" if why else ""


tried, broken = 0, []


def report(name, kind, on, total, happened, wrong):
    global tried, broken
    tried += happened
    broken += wrong
    if total:
        print(f"{name:18} {kind:8} {on:6} {total:8} calls, {happened:6} made to fail, broke {len(wrong)}", flush=True)
    for n, why in wrong[:5]:
        print(f"    {kind} {on} {n}: {why}", flush=True)


def singly(name, kind, on, picked):
    """Runs of their own; how many faults happened, and what broke."""
    results = list(pool.map(lambda n: fault_in(name, kind, on, n), picked))
    return sum(1 for fault, _ in results if fault), [(n, why) for n, (_, why) in zip(picked, results) if why]


with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
    for name in names:
        for kind in options.kinds.split(","):
            total = counted(name, kind)[0]
            if kind == "memory":
                stride = max(1, total // options.copies) if options.copies else 1
                copies, others = others_in_copies(name, stride)
                report(name, kind, "each", total, copies, singly(name, kind, "once", others[:200])[1])
            for on in ("once", "after"):
                most = min(options.most, 12) if name in commands.SLOW else options.most
                report(name, kind, on, total, *singly(name, kind, on, chosen(total, most)))
print(f"tried {tried}, broke {len(broken)}: allocations, mappings and thread starts that fail")
sys.exit(1 if broken or tried == 0 else 0)
