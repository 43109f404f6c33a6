#!/usr/bin/env python3
"""Draws docs/images/torus.png: python3 docs/plot_torus.py PROGRAM OUT.png

A sweep finds the scale at which a test with a tolerance begins to miss; then the torus of the sweep is rendered there and
at 10⁻⁶, by the tolerance and by the certified test, and the pixels that differ are counted by the program.
"""
import os
import re
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

METHOD, EXACT = "mt-eps-double", "sf-filtered"


def run(*words):
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def scale_of_first_miss(program, folder):
    """The last scale without a false miss and the first with one, as exponents of two, in binary64."""
    said = run(program, "sweep", "--method", METHOD, "--axis", "scale,afar", "--count", "984", "--out", folder)
    for line in said.splitlines():
        found = re.match(r"\s*scale -\s+binary64 false miss\s+(-?\d+): none .*?, (-?\d+): ", line)
        if found:
            return int(found[1]), int(found[2])
    sys.exit(f"no false miss of {METHOD} towards smaller scales:\n{said}")


def render(program, folder, scale, name):
    """The picture by the tolerance, that of the pixels that differ, and how many these are."""
    out = os.path.join(folder, name)
    said = run(program, "render", os.path.join(folder, "afar.off"), "--scale", repr(scale), "--method", METHOD, "--against",
               EXACT, "--size", "400x300", "--max-cases", "0", "-o", out + ".png")
    lost, pixels = map(int, re.search(r"(\d+) of (\d+) pixels differ in colour", said).groups())
    return plt.imread(out + ".png"), plt.imread(out + ".diff.png"), lost, pixels


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__.splitlines()[0])
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        none_at, some_at = scale_of_first_miss(program, folder)
        between = 2.0 ** ((none_at + some_at) / 2)
        eaten, _, eaten_pixels, pixels = render(program, folder, between, "between")
        lost, differing, lost_pixels, _ = render(program, folder, 1e-6, "small")
        exact = os.path.join(folder, "exact.png")
        run(program, "render", os.path.join(folder, "afar.off"), "--scale", "1e-6", "--method", EXACT, "--size", "400x300",
            "-o", exact)
        exact = plt.imread(exact)
    panels = [(eaten, f"ε test, scale {between:.2g}", f"{eaten_pixels:,} pixels lost"),
              (lost, "ε test, scale 10⁻⁶", f"{lost_pixels:,} pixels lost"),
              (exact, "exact, scale 10⁻⁶", "none lost"),
              (differing, "what differs", f"{lost_pixels:,} of {pixels:,}")]
    figure, axes = plt.subplots(1, 4, figsize=(12.8, 3.2))
    figure.subplots_adjust(left=0.002, right=0.998, top=0.76, bottom=0.01, wspace=0.012)
    for ax, (picture, title, note) in zip(axes, panels):
        ax.imshow(picture, interpolation="antialiased")
        ax.axis("off")
        ax.text(0, 1.155, title, transform=ax.transAxes, fontsize=17, fontweight="bold", va="bottom", family="DejaVu Sans")
        ax.text(0, 1.02, note, transform=ax.transAxes, fontsize=16, va="bottom", color="#333333", family="DejaVu Sans")
    figure.savefig(sys.argv[2], dpi=100, metadata={"Software": None})
    print(f"{METHOD}: no miss at 2^{none_at}, misses at 2^{some_at}; {lost_pixels} of {pixels} pixels lost at 1e-6, "
          f"{eaten_pixels} at {between:.4g}")


if __name__ == "__main__":
    main()
