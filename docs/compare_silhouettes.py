#!/usr/bin/env python3
"""Draws an exported scene with POV-Ray and compares which solid each pixel shows.

    python3 docs/compare_silhouettes.py SCENE.pov [POVRAY]

Needs POV-Ray 3.7 and matplotlib (Debian: povray, python3-matplotlib).
SCENE.ids.png, written beside the scene by `render --export-pov`, holds the method's answers. Prints each pixel that
differs with both answers (at most 20) and their number; fails if more than one pixel in a thousand differs.
"""
import subprocess
import sys
import tempfile

try:
    import matplotlib.image
except ImportError:
    sys.exit("compare_silhouettes.py: no module matplotlib (Debian: python3-matplotlib)")


def levels(path):
    try:
        picture = matplotlib.image.imread(path)
    except OSError as error:
        sys.exit(f"{path}: cannot read: {error.strerror}")
    grey = picture if picture.ndim == 2 else picture[:, :, 0]
    return (grey * 255).round().astype(int)


def name(level):
    return "nothing" if level == 0 else f"solid {level - 1}"


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    scene, povray = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else "povray"
    ours = levels(scene.removesuffix(".pov") + ".ids.png")
    height, width = ours.shape
    with tempfile.TemporaryDirectory() as scratch:
        picture = scratch + "/ids.png"
        try:
            subprocess.run([povray, f"+I{scene}", f"+O{picture}", f"+W{width}", f"+H{height}", "+FN8", "-D", "-A",
                            "+WT1", "File_Gamma=1.0", "Declare=Ids=1"], check=True, capture_output=True)
        except OSError as error:
            sys.exit(f"{povray}: cannot run: {error.strerror} (Debian: povray)")
        except subprocess.CalledProcessError as error:
            sys.exit(f"{povray} failed on {scene}: exit code {error.returncode}")
        theirs = levels(picture)
    differing = [(x, y) for y in range(height) for x in range(width) if ours[y, x] != theirs[y, x]]
    for x, y in differing[:20]:
        print(f"pixel {x},{y}: exactly {name(ours[y, x])}, POV-Ray shows {name(theirs[y, x])}")
    seen = sorted(set(ours.flat))
    print(f"{scene}: {len(differing)} of {width * height} pixels differ; {len(seen)} different answers")
    sys.exit(0 if len(differing) * 1000 <= width * height and len(seen) > 1 else 1)


main()
