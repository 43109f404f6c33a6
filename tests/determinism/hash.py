#!/usr/bin/python3
"""One hash for each command of manifest.txt: hash.py [OPTION…] PROGRAM FOLDER

  --threads N      threads of the commands that take them; without it their default
  --interrupt      stop the command with {resume} again and again, each time with other threads, until it is done
  --scale N        N times the cases
  --long           the lines of the long form too
  --across         leave out what says which build made a result: compiler, flags, revision, and hashes that cover them
  --only NAME…     these commands alone (comma-separated)

FOLDER is made, must not exist before, and keeps what the commands wrote. Prints `hash name`, the commands in their order.
"""
import argparse
import hashlib
import json
import os
import re
import signal
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
THREADS_OF_PARTS = (1, 2, 7, 64)
FROM_BUILD = re.compile(rb'\\?"(compiler|flags|revision)\\?": ?\\?"[^"]*"')
CHAIN = re.compile(rb'"sha256": ?"[0-9a-f]{64}"|\b[0-9a-f]{64}\b')


def manifest():
    with open(os.path.join(HERE, "manifest.txt"), encoding="utf-8") as lines:
        rows = [line.split() for line in lines if line.strip() and not line.startswith("#")]
    return [(row[0], int(row[1]), row[2:]) for row in rows]


class Runner:
    def __init__(self, options):
        self.options = options
        self.program = os.path.abspath(options.program)
        self.folder = options.folder
        self.made_by = []

    def words(self, arguments, threads, resume):
        said = []
        for word in arguments:
            if word == "{threads}":
                said += ["--threads", str(threads)] if threads else []
            elif word == "{resume}":
                said += ["--resume"] if resume else []
            else:
                said.append(re.sub(r"^%(\d+)$", lambda m: str(int(m[1]) * self.options.scale), word))
        return [self.program, *said]

    def start(self, words, output):
        environment = dict(os.environ)
        if "TRIBUNAL_PRELOAD" in environment:  # of the program, not of this one
            environment["LD_PRELOAD"] = environment.pop("TRIBUNAL_PRELOAD")
        return subprocess.Popen(words, cwd=self.folder, env=environment, stdin=subprocess.DEVNULL, stdout=output,
                                stderr=subprocess.PIPE)

    def run(self, name, expected, arguments):
        with tempfile.TemporaryFile() as output:
            process = self.start(self.words(arguments, self.options.threads, False), output)
            said = process.communicate()[1]
            self.require(name, process.returncode, expected, said)
            output.seek(0)
            return b"" if name.endswith("-") else output.read()

    def run_in_parts(self, name, expected, arguments):
        """Stopped after a second, or half of that where it was done too soon, and so on."""
        for wait in (1, 0.5, 0.25, 0.12, 0.06, 0.03):
            parts = 0
            while True:
                threads = THREADS_OF_PARTS[parts % len(THREADS_OF_PARTS)]
                process = self.start(self.words(arguments, threads, True), subprocess.DEVNULL)
                try:
                    said = process.communicate(timeout=wait if parts < 12 else None)[1]
                except subprocess.TimeoutExpired:
                    process.send_signal(signal.SIGINT)
                    said = process.communicate()[1]
                if process.returncode == expected:
                    break
                self.require(name, process.returncode, 130, said)
                parts += 1
            if parts > 0:
                return b""
        sys.exit(f"{name}: done before it could be interrupted")

    def require(self, name, status, expected, said):
        if status != expected:
            sys.exit(f"{name}: exit {status}, expected {expected}: {said.decode(errors='replace').strip()}")

    def normal(self, data):
        if not self.options.across:
            return data
        data = FROM_BUILD.sub(b"(of the build)", data)
        for text in self.made_by:
            data = data.replace(text, b"(of the build)")
        return CHAIN.sub(b"(hash)", data)

    def learn_build(self, path):
        """What this build says of itself, from a result, to be found again in prose."""
        with open(path, encoding="utf-8") as file:
            environment = json.load(file)["environment"]
        self.made_by = sorted((environment[key].encode() for key in ("compiler", "flags", "revision")), key=len, reverse=True)

    def hash_of(self, printed, before):
        digest = hashlib.sha256(self.normal(printed))
        made = sorted(set(self.files()) - before)
        if not made and not printed:
            sys.exit("a command wrote nothing")
        for path in made:
            with open(os.path.join(self.folder, path), "rb") as file:
                digest.update(path.encode() + b"\0" + self.normal(file.read()))
        return digest.hexdigest()

    def files(self):
        for folder, folders, names in os.walk(self.folder):
            if folder == self.folder:
                folders[:] = [f for f in folders if f != "data"]
            for name in names:
                yield os.path.relpath(os.path.join(folder, name), self.folder)


def main(options):
    runner = Runner(options)
    only = options.only.split(",") if options.only else None
    lines = [line for line in manifest() if options.long or not line[0].startswith("+")]
    lines = [line for line in lines if only is None or line[0].strip("+-") in only]
    if not lines:
        sys.exit("hash.py: no command")
    for name, expected, arguments in lines:
        before = set(runner.files())
        in_parts = options.interrupt and "{resume}" in arguments
        printed = (runner.run_in_parts if in_parts else runner.run)(name, expected, arguments)
        if options.across and not runner.made_by and os.path.exists(os.path.join(options.folder, "fuzz/summary.json")):
            runner.learn_build(os.path.join(options.folder, "fuzz/summary.json"))
        print(runner.hash_of(printed, before), name.strip("+-"), flush=True)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--threads", type=int)
    parser.add_argument("--interrupt", action="store_true")
    parser.add_argument("--scale", type=int, default=1)
    parser.add_argument("--long", action="store_true")
    parser.add_argument("--across", action="store_true")
    parser.add_argument("--only")
    parser.add_argument("program")
    parser.add_argument("folder")
    main(parser.parse_args())
