"""peak.py OUT PROGRAM ARG…: runs the program, with its standard output in the file OUT, and prints its exit code, its peak
memory in KiB, and its wall-clock and processor seconds."""
import resource
import subprocess
import sys
import time

with open(sys.argv[1], "wb") as out:
    start = time.monotonic()
    code = subprocess.run(sys.argv[2:], stdout=out, check=False).returncode
    wall = time.monotonic() - start
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print(code, used.ru_maxrss, f"{wall:.3f}", f"{used.ru_utime + used.ru_stime:.3f}")
