"""What the campaign runs: commands of crawford whose ends can be compared bit by bit, and how each goes on."""

import json
import os
import re
import signal
import subprocess
import time
from pathlib import Path

TREE = Path(__file__).resolve().parents[2]
PROGRAM = Path(os.environ.get("CRAWFORD", TREE / "build" / "crawford"))
SCENE = TREE / "cases" / "scenes" / "sandwich.toml"

# Times, and what a run that went on says of itself.
MEMBERS_OF_ITS_OWN = {
    "manifest", "seconds", "cost", "wall_seconds", "cpu_seconds", "peak_memory_bytes", "started", "ended", "command",
    "to_go"}


def start(arguments, **more):
    """The program, under way; a session of its own, so that it can be killed with all that it has started."""
    return subprocess.Popen([str(PROGRAM), *map(str, arguments)], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, start_new_session=True, **more)


class Ended:
    def __init__(self, code, out, err, seconds):
        self.code, self.out, self.err, self.seconds = code, out, err, seconds

    def says(self):
        return self.err.strip().splitlines()


# Nothing that the campaign runs takes a tenth of it.
LONGEST = 900  # s


def end_of(process, began):
    try:
        out, err = process.communicate(timeout=LONGEST)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        out, err = process.communicate()
        return Ended("none", "", f"it hung for {LONGEST} s and was killed", time.time() - began)
    return Ended(process.returncode, out.decode(errors="replace"), err.decode(errors="replace"), time.time() - began)


def run(arguments, **more):
    began = time.time()
    return end_of(start(arguments, **more), began)


def without_times(json_value):
    if isinstance(json_value, dict):
        return {k: without_times(v) for k, v in json_value.items() if k not in MEMBERS_OF_ITS_OWN}
    if isinstance(json_value, list):
        return [without_times(v) for v in json_value]
    return json_value


class Burn:
    """A sandwich of 16 by 24 cells, 300 steps, a checkpoint every fifth."""
    name = "burn"

    def __init__(self, steps=300):
        self.steps = steps

    def arguments(self, out):
        # Steps of 20 us.
        return ["burn", SCENE, "--set", "domain.nx=16", "--set", "domain.ny=24", "--set", "time.until_steady=",
                "--set", f"time.end={20 * self.steps} us", "--set", "output.checkpoint_every=0.1 ms",
                "--set", "output.snapshots_every=0.5 ms", "--quiet", "--out", out]

    def checkpoints(self, out):
        return sorted(Path(out).glob("sandwich_checkpoint_*.h5"))

    def going_on(self, out):
        """From the last checkpoint before the end, as a user would."""
        last = f"sandwich_checkpoint_{self.steps:06d}.h5"
        found = [c for c in self.checkpoints(out) if c.name != last]
        return self.arguments(out) + (["--restart", found[-1]] if found else [])

    def difference(self, out, unbroken):
        """Names what is not as in an unbroken run; empty if nothing."""
        ours, theirs = ({f.name: f.read_bytes() for f in Path(d).iterdir()
                         if f.suffix != ".json" and ".owner" not in f.name}
                        for d in (out, unbroken))
        for name in sorted(ours.keys() | theirs.keys()):
            if ours.get(name) != theirs.get(name):
                return name
        results = [json.loads((Path(d) / "manifest.json").read_text())["results"] for d in (out, unbroken)]
        return "" if results[0] == results[1] else "results of manifest.json"


class Again:
    """A command that goes on when it is typed again."""

    def __init__(self, name, words, compared):
        self.name, self.words, self.compared = name, words, compared

    def arguments(self, out):
        return [*self.words, "--quiet", "--out", out]

    def going_on(self, out):
        return self.arguments(out)

    def difference(self, out, unbroken):
        for pattern in self.compared:
            names = {f.relative_to(d) for d in (out, unbroken) for f in Path(d).glob(pattern)}
            if not names:
                return "nothing of " + pattern
            for name in sorted(names):
                pair = [Path(d) / name for d in (out, unbroken)]
                if not all(f.exists() for f in pair):
                    return f"{name} is missing"
                if contents(pair[0]) != contents(pair[1]):
                    return str(name)
        return ""


def contents(file):
    if file.suffix == ".json":
        return without_times(json.loads(file.read_text()))
    if file.suffix == ".jsonl":
        # Records are kept in the order in which they were made.
        return sorted(json.dumps(without_times(json.loads(line)), sort_keys=True)
                      for line in file.read_text().splitlines())
    return re.sub(rb"out=\S+", b"", file.read_bytes())


def verify():
    return Again("verify", ["verify", "rotation", "stress-work"], ["verify.json", "records/*.jsonl"])


def figure():
    return Again("run", ["run", "fig05", "--fidelity", "draft"],
                 ["figures/*.csv", "records/*.jsonl", "burns/*/*_history.csv", "burns/*/*.h5"])


def ledger():
    """With burns and runs of its own: all readings and refinements of the sandwich."""
    return Again("ledger", ["ledger", "--settle", "--figure", "fig11", "--fidelity", "draft"],
                 ["figures/ledger-fig11.json", "records/*.jsonl", "burns/*/*_history.csv", "burns/*/*.h5"])


def short_ledger():
    """Of a figure that burns nothing."""
    return Again("ledger", ["ledger", "--settle", "--figure", "fig12", "--fidelity", "draft"],
                 ["figures/ledger-fig12.json", "figures/*.csv", "records/*.jsonl"])
