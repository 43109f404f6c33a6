#!/usr/bin/env python3
"""The paper's table: intersection tests, hits and their share with object boxes, what need not be computed, and times.

    docs/tracer_table.py PROGRAM [--methods M,M…] [--accel boxes] SCENE…
    docs/tracer_table.py PROGRAM [--methods M,M…] --against sf-filtered SCENE…

Renders each scene with each method on one thread (the reports of `render --stats`) and prints two Markdown tables. The
counts are the same for all exact methods; they are those of the first method given. With --against it prints instead on how
many pixels each method decides otherwise: visibility / shadow / secondary, and in brackets those on which the two
differ in the start of a ray alone.
"""
import argparse
import json
import subprocess
import sys
import tempfile


def rendered(program, scene, method, accel):
    with tempfile.TemporaryDirectory() as scratch:
        command = [program, "render", scene, "--method", method, "--accel", accel, "--threads", "1",
                   "-o", scratch + "/image.png", "--stats", scratch + "/stats.json"]
        printed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        row = next(line for line in printed.splitlines() if line.startswith(method + " "))
        with open(scratch + "/stats.json") as stats:
            return json.load(stats), row.split()[-1]  # the last column is seconds: files hold nothing that varies


def difference(program, scene, method, against):
    with tempfile.TemporaryDirectory() as scratch:
        subprocess.run([program, "render", scene, "--method", method, "--against", against, "--threads", "2",
                        "--max-cases", "1000000", "-o", scratch + "/image.png", "--stats", scratch + "/stats.json"],
                       check=True, stdout=subprocess.DEVNULL)
        with open(scratch + "/stats.json") as stats:
            d = json.load(stats)["difference"]
    if d["pixels"] == 0:
        return "0"
    return (f"{d['parted_on_visibility']} / {d['parted_on_shadow']} / {d['parted_on_secondary']} "
            f"({d['parted_on_start_only']})")


def print_differences(options, methods):
    print(f"| against {options.against} | " + " | ".join(methods) + " |\n|---|" + "---|" * len(methods))
    for scene in options.scenes:
        cells = [difference(options.program, scene, m, options.against) for m in methods]
        print(f"| {name_of(scene)} | " + " | ".join(cells) + " |", flush=True)


def name_of(scene):
    return scene.rsplit("/", 1)[-1].removesuffix(".json")


def count_row(scene, stats):
    m = stats["methods"][0]
    rays = sum(kind["cast"] for kind in m["rays"].values())
    tests, hits = m["triangle_tests"] + m["polygon_tests"], m["triangle_hits"] + m["polygon_hits"]
    return (f"| {name_of(scene)} | {stats['triangles']} + {stats['polygons']} | {stats['depth']} | {rays:,} | {tests:,} | "
            f"{hits:,} | {100 * hits / tests:.1f} % | {100 - 100 * hits / tests:.1f} % | "
            f"{m['points_computed']:,} | {m['starts']['tests']:,} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("scenes", nargs="+")
    parser.add_argument("--methods", default="sf-filtered,sf-double,sf-epick,feito-double,mt-double")
    parser.add_argument("--accel", default="boxes")
    parser.add_argument("--against")
    options = parser.parse_args()
    methods = options.methods.split(",")
    if options.against:
        return print_differences(options, methods)

    counts, times = [], []
    for scene in options.scenes:
        seconds = []
        for method in methods:
            stats, time = rendered(options.program, scene, method, options.accel)
            seconds.append(time)
            if method == methods[0]:
                counts.append(count_row(scene, stats))
        times.append(f"| {name_of(scene)} | " + " | ".join(seconds) + " |")
        print(times[-1], file=sys.stderr)

    print("| scene | triangles + polygons | depth | rays | tests | hits | share | points avoided | points computed | tests for "
          "starts |\n|---|---|---|---|---|---|---|---|---|---|\n" + "\n".join(counts))
    print("\n| seconds, one thread | " + " | ".join(methods) + " |\n|---|" + "---|" * len(methods) + "\n" +
          "\n".join(times))


main()
