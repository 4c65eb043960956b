"""What the scripts of this folder share: how checks are counted and commands run, and how the programs of tests/nopanic are built and found."""

import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CRATE = ROOT / "tests" / "nopanic"
BUILDS = ROOT / os.environ.get("CARGO_TARGET_DIR", "target") / "nopanic"
TARGETS = ["thumbv6m", "thumbv7m"]
PROGRAMS = sorted(path.stem for path in (CRATE / "src" / "bin").glob("*.rs"))


class Report:
    """Counts and prints the checks."""

    def __init__(self):
        self.passed = 0
        self.failed = 0

    def check(self, good, what, why=()):
        """Prints one check, with the reasons if it failed; gives back whether it is good."""
        self.passed, self.failed = self.passed + bool(good), self.failed + (not good)
        print(f"{'ok     ' if good else 'FAILED '} {what}", flush=True)
        for line in () if good else why:
            print(f"        {line}", flush=True)
        return good

    def run(self, what, command, **options):
        """A check that a command succeeds. Gives what it printed, or None."""
        done = run(command, **options)
        good = self.check(done.returncode == 0, what, (done.stdout + done.stderr).splitlines()[-20:])
        return done.stdout if good else None

    def end(self):
        print(f"{self.passed} passed, {self.failed} failed")
        return 1 if self.failed else 0


def run(command, cwd=ROOT, **environment):
    """Runs a command to its end, with further variables of the environment."""
    environment = os.environ | environment
    return subprocess.run(command, cwd=cwd, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True)


def build(target, level, place, programs, *more):
    """Links into a folder what can be linked. Gives what cargo said."""
    bins = [word for program in programs for word in ("--bin", program)]
    places = ["--manifest-path", CRATE / "Cargo.toml", "--target-dir", BUILDS / place]
    options = ["--release", "--keep-going", "--config", f'profile.release.opt-level={level if level == "3" else repr(level)}']
    done = run([ROOT / ".ci" / "fwcargo", f"{target}-none-eabi", "build", *options, *places, *bins, *more])
    return done.stdout + done.stderr


def elf_of(target, place, program):
    return BUILDS / place / f"{target}-none-eabi" / "release" / program


def some_of(words, wanted):
    """Those that are wanted, or all."""
    return [word for word in words if word in wanted] or words
