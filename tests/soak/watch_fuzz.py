#!/usr/bin/python3
"""Runs fuzz for a time and watches it: watch_fuzz.py TRIBUNAL triangles|polygons SECONDS OUT

Memory is what /proc says; the rate is of cases a second of processor time, so that other work on the machine does not count;
the cases so far are read off the progress line, which fuzz draws on a terminal. The first quarter of the run is warm-up, and so is
the time to the first checkpoint, which is when the table of all counts is made beside those of the threads; of the rest the last third is held against the first: the median of memory, since writing a checkpoint takes some for a moment, and the
rate. Writes OUT.count ("tried broke") and OUT.say, what was seen in words.
"""
import json
import os
import pty
import re
import select
import statistics
import subprocess
import sys
import time

RIGHT, CAUGHT = "sf-filtered", "sf-double"
MORE_MEMORY, LESS_RATE = 1.05, 0.85  # of the last third over the first
PROGRESS = re.compile(rb"([0-9.]+(?:e\+?[0-9]+)?)( [kMG])? cases  ")
UNITS = {None: 1, b" k": 1e3, b" M": 1e6, b" G": 1e9}
FIRST_CHECKPOINT = 70  # seconds, after 60
TICKS = os.sysconf("SC_CLK_TCK")


def family_options(tribunal, operands):
    """Fuzz asks all families of triangles unless told otherwise; those of polygons are named by its help."""
    if operands == "triangles":
        return []
    said = subprocess.run([tribunal, "fuzz", "--help"], capture_output=True, text=True, check=True).stdout
    return ["--family", ",".join(sorted(set(re.findall(r"\bpolygon-[a-z0-9-]+", said))))]


def status_of(pid):
    """Resident bytes and seconds of processor time."""
    with open(f"/proc/{pid}/stat", encoding="ascii", errors="replace") as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return int(fields[21]) * os.sysconf("SC_PAGE_SIZE"), (int(fields[11]) + int(fields[12])) / TICKS


def watch(command, seconds):
    """Samples (seconds, resident bytes, processor seconds, cases) of one run, its exit code and what it printed."""
    terminal, end = pty.openpty()
    output = open(os.devnull, "w", encoding="ascii")
    process = subprocess.Popen(command, stdout=output, stderr=end)
    os.close(end)
    began, samples, told, shown, drawn = time.monotonic(), [], 0.0, 0.0, b""
    while process.poll() is None:
        if select.select([terminal], [], [], 0.1)[0]:
            try:
                drawn = (drawn + os.read(terminal, 65536))[-4096:]
            except OSError:
                break
            found = PROGRESS.findall(drawn)
            if not found:
                continue
            cases = float(found[-1][0]) * UNITS[found[-1][1] or None]
            now = time.monotonic() - began
            if cases > 0 and now - told >= min(1, seconds / 200):
                samples.append((now, *status_of(process.pid), cases))
                told = now
            if now - shown >= 60:
                print(f"  {now:.0f} s: {cases:.4g} cases, {samples[-1][1] / 1e6:.0f} MB", flush=True)
                shown = now
    code = process.wait()
    os.close(terminal)
    return samples, code, drawn.decode(errors="replace")


def thirds(samples, seconds):
    start = max(seconds / 4, FIRST_CHECKPOINT if seconds > 2 * FIRST_CHECKPOINT else 0)
    warm = [s for s in samples if s[0] > start]
    return warm[: len(warm) // 3], warm[-(len(warm) // 3) :]


def rate(samples):
    """Cases a second of processor time."""
    return (samples[-1][3] - samples[0][3]) / max(samples[-1][2] - samples[0][2], 1e-9)


def drift(samples, seconds):
    """What was seen, in words, and what of it is too much."""
    first, last = thirds(samples, seconds)
    if len(first) < 5:
        return f"only {len(samples)} samples", ["too few samples to see a drift"]
    memory = [statistics.median(s[1] for s in part) / 1e6 for part in (first, last)]
    peak = max(s[1] for s in samples) / 1e6
    rates = [rate(part) for part in (first, last)]
    words = (f"memory {memory[0]:.1f} MB, later {memory[1]:.1f} MB, at most {peak:.1f} MB; "
             f"{rates[0]:.4g} cases a second of processor time, later {rates[1]:.4g}")
    broken = []
    if memory[1] > memory[0] * MORE_MEMORY:
        broken.append("memory grew")
    if rates[1] < rates[0] * LESS_RATE:
        broken.append("the rate fell")
    return words, broken


def verdict(out):
    """Cases, families, and what is broken."""
    with open(out + "/summary.json", encoding="utf-8") as file:
        summary = json.load(file)
    wrong = {RIGHT: 0, CAUGHT: 0}
    for row in summary["counts"]:
        wrong[row["method"]] += row["wrong"]
    broken = [f"{wrong[RIGHT]} wrong answers of {RIGHT}"] if wrong[RIGHT] else []
    if wrong[CAUGHT] == 0:
        broken.append(f"{CAUGHT} was never caught")
    return summary["cases"], len(summary["families"]), broken


def main(tribunal, operands, seconds, out):
    seconds = float(seconds)
    print(f"fuzz, {operands}: {seconds:.0f} s", flush=True)
    samples, code, drawn = watch([tribunal, "fuzz", "--method", f"{RIGHT},{CAUGHT}", "--seconds", str(seconds), "--threads",
                                  str(os.cpu_count()), "--out", out, *family_options(tribunal, operands)], seconds)
    cases, families, broken = 0, 0, []
    if code != 1:
        broken.append(f"exit {code}: {drawn.splitlines()[-1] if drawn else ''}")
    else:
        cases, families, broken = verdict(out)
    words, drifted = drift(samples, seconds)
    broken += drifted
    with open(out + ".count", "w", encoding="ascii") as file:
        print(cases, len(broken), file=file)
    with open(out + ".say", "w", encoding="utf-8") as file:
        print(f"{operands}: {cases:,} cases of {families} families in {seconds:.0f} s; {words}", file=file)
        for what in broken:
            print(f"{operands}: BROKEN: {what}", file=file)
    return 1 if broken else 0


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
