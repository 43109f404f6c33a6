#!/usr/bin/env python3
"""The paper's table: intersection tests, hits and their share with object boxes, what need not be computed, and times.

    docs/tracer_table.py PROGRAM [--methods M,M…] [--accel boxes] SCENE…

Renders each scene with each method on one thread (the reports of `render --stats`) and prints two Markdown tables. The
counts are the same for all exact methods; they are those of the first method given.
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
    options = parser.parse_args()
    methods = options.methods.split(",")

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
