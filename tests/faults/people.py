"""Signals; checkpoints that are damaged; two runs in one folder; names and places that people give."""

import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import time
from pathlib import Path

import work
from table import Row
from whole import halves


def signals(place, random, short):
    row = Row("SIGINT, SIGTERM")
    for what in (work.Burn(), work.verify(), work.figure(), work.short_ledger()):
        unbroken = place / f"unbroken-{what.name}"
        began = time.time()
        work.run(what.arguments(unbroken))
        seconds = time.time() - began
        for k in range(2 if short else 8):
            number, code = ((signal.SIGINT, 130), (signal.SIGTERM, 143))[k % 2]
            folder = place / f"{what.name}{k}"
            process = work.start(what.arguments(folder))
            time.sleep(random.uniform(0.1, 0.9) * seconds)
            process.send_signal(number)
            ended = work.end_of(process, began)
            wrong = interrupted(what, folder, unbroken, ended, {code, -number})
            row.tried(not wrong, f"{what.name}, {number.name}: {wrong}")
    row.saw("130 or 143; the command that it prints goes on to the same bits")
    yield row


def interrupted(what, folder, unbroken, ended, codes):
    if ended.code == 0:
        return what.difference(folder, unbroken)
    if ended.code not in codes:
        return f"exit {ended.code}: {ended.err.strip()}"
    if folder.exists() and (torn := halves(folder)):
        return "torn: " + ", ".join(torn)
    printed = re.search(r"[Gg]o on with: (.*)", ended.out + ended.err)
    if printed is None and ended.code > 0:
        return "no command that goes on"
    # A signal that came before anything was begun: nothing is printed, and nothing is there.
    command = shlex.split(printed[1]) if printed else [work.PROGRAM, *what.arguments(folder)]
    if what.name == "burn" and printed:
        if json.loads((folder / "manifest.json").read_text())["outcome"] != "interrupted":
            return "the manifest does not say that it was interrupted"
        # Its last state has a checkpoint and a snapshot of their own, which the unbroken run has not.
    again = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    if again.returncode != 0:
        return f"{command} does not go on: {again.stderr}"
    if what.name == "burn" and printed:
        return same_end(folder, unbroken)
    return what.difference(folder, unbroken)


def same_end(folder, unbroken):
    """History and last checkpoint."""
    for name in ("sandwich_history.csv", sorted(f.name for f in unbroken.glob("*_checkpoint_*"))[-1]):
        if (folder / name).read_bytes() != (unbroken / name).read_bytes():
            return name
    return ""


def damaged_checkpoints(place, random, short):
    row = Row("checkpoints cut and flipped")
    burn = work.Burn(steps=15)
    folder = place / "sound"
    work.run(burn.arguments(folder))
    last = folder / "sandwich_checkpoint_000010.h5"
    sound = last.read_bytes()
    command = burn.arguments(folder) + ["--restart", last]
    for k in range(4 if short else 100):
        damaged = bytearray(sound)
        if k % 2 == 0:
            at = random.choice([random.randrange(600), random.randrange(len(sound))])
            damaged[at] ^= 1 << random.randrange(8)
            what = f"bit of byte {at}"
        else:
            at = random.choice([random.randrange(600), random.randrange(len(sound))])
            del damaged[at:]
            what = f"cut at {at}"
        last.write_bytes(damaged)
        ended = work.run(command)
        wrong = "" if ended.code == 2 and len(ended.says()) == 1 and "is damaged" in ended.err else \
            f"exit {ended.code}: {ended.err.strip()}"
        row.tried(not wrong, f"{what}: {wrong}")
    last.write_bytes(sound)
    if work.run(command).code != 0:
        row.lost("the sound one does not go on")
    row.saw("exit 2 and one line, before HDF5 opens it")
    yield row


def two_in_one_folder(place, random, short):
    row = Row("two runs in one folder")
    burn = work.Burn()
    unbroken = place / "unbroken"
    work.run(burn.arguments(unbroken))
    for k in range(1 if short else 5):
        folder = place / f"both{k}"
        pair = [work.start(burn.arguments(folder)) for _ in range(2)]
        ends = sorted((work.end_of(p, time.time()) for p in pair), key=lambda e: e.code)
        wrong = ""
        if [e.code for e in ends] == [0, 2]:
            wrong = "" if "is being written into by" in ends[1].err else ends[1].err
        elif [e.code for e in ends] != [0, 0]:  # the second may have begun when the first had ended
            wrong = f"exit {ends[0].code} and {ends[1].code}: {ends[0].err}{ends[1].err}"
        wrong = wrong or burn.difference(folder, unbroken)
        row.tried(not wrong, wrong)
    for what in (work.verify(), work.figure()):
        unbroken = place / f"unbroken-{what.name}"
        work.run(what.arguments(unbroken))
        folder = place / f"both-{what.name}"
        pair = [work.start(what.arguments(folder)) for _ in range(2)]
        ends = [work.end_of(p, time.time()) for p in pair]
        wrong = next((f"exit {e.code}: {e.err}" for e in ends if e.code != 0), "") or what.difference(folder, unbroken)
        row.tried(not wrong, f"{what.name}: {wrong}")
    row.saw("one burn is refused; verify and run wait for each other")
    yield row


NAMES = [b"a b", b"it's", b'say "so"', b"$HOME;`x`&", b"not\xffutf8", "füße".encode()]


def names(place, random, short):
    row = Row("blanks, quotes, other bytes in names")
    for name in NAMES[:1] + NAMES[2:3] + NAMES[4:5] if short else NAMES:
        here = os.fsencode(place) + b"/" + name
        os.makedirs(here)
        for label, command, codes in commands_in(here):
            ended = subprocess.run([os.fsencode(work.PROGRAM), *(os.fsencode(str(a)) if not isinstance(a, bytes) else a
                                                                for a in command)],
                                   capture_output=True, stdin=subprocess.DEVNULL)
            if label == "truth":
                Path(os.fsdecode(here + b"/truth.csv")).write_bytes(ended.stdout)
            told = ended.stderr.decode(errors="replace").strip()
            wrong = f"exit {ended.returncode}: {told[-300:]}" if ended.returncode not in codes or \
                "internal error" in told else ""
            row.tried(not wrong, f"{label} in {name!r}: {wrong}")
        if not short or name == NAMES[0]:
            wrong = interrupted_in(here)
            row.tried(not wrong, f"goes on in {name!r}: {wrong}")
    row.saw("every command works there")
    yield row


def commands_in(here):
    scene = here + b"/my scene.toml"
    shutil.copy(work.SCENE, scene)
    table = here + b"/table.csv"
    Path(os.fsdecode(table)).write_text("h,error\n0.1,0.01\n0.05,0.0025\n0.025,0.000625\n")
    points = here + b"/points.csv"
    Path(os.fsdecode(points)).write_text("x [m],y [m]\n0,-1e-5\n0,-2e-5\n")
    short = work.Burn(steps=15).arguments(here + b"/burn")
    short[1] = scene
    yield "burn", short, {0}
    yield "verify", ["verify", "stress-work", "-q", "--out", here + b"/verify", "--junit", here + b"/j.xml"], {0}
    yield "run", ["run", "fig05", "--fidelity", "draft", "-q", "--out", here + b"/run"], {0}
    yield "ledger", ["ledger", "-q", "--out", here + b"/run"], {0}
    yield "report", ["report", "--out", here + b"/run"], {0}
    yield "order", ["order", table, "--json", here + b"/order.json"], {0}
    pack = Path(os.fsdecode(here)) / "a pack.toml"
    shutil.copy(work.TREE / "cases/scenes/random_pack.toml", pack)
    yield "pack", ["pack", os.fsencode(pack), "--out", here + b"/pack.csv"], {0}
    yield "truth", ["truth", "slab", "--points", points], {0}
    yield "judge", ["judge", "slab", b"32=" + here + b"/truth.csv", "--out", here + b"/judge"], {0, 1}
    yield "list", ["list"], {0}


def interrupted_in(here):
    """The command that an interrupted burn prints can be typed as it stands."""
    burn = work.Burn(steps=3000)
    out = os.fsdecode(here + b"/long")
    process = subprocess.Popen([os.fsencode(str(a)) for a in [work.PROGRAM, *burn.arguments(out)]],
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    while not list(burn.checkpoints(out)) and process.poll() is None:
        time.sleep(0.05)
    process.send_signal(signal.SIGTERM)
    text = process.communicate()[0]
    printed = re.search(rb"go on with: (.*)", text)
    if printed is None:
        return f"nothing printed: {text!r}"
    again = subprocess.Popen(["sh", "-c", b"exec " + printed[1]], stderr=subprocess.PIPE, stdout=subprocess.PIPE)
    time.sleep(0.7)
    again.send_signal(signal.SIGTERM)
    told = again.communicate()
    return "" if again.returncode in (143, 0, -15) else f"exit {again.returncode}: {told[1]!r}"


def make_from_such_a_place(place, random, short):
    row = Row("make from such a place")
    tree = place / "a b" / "it's"
    tree.parent.mkdir()
    files = subprocess.run(["git", "ls-files", "-z"], cwd=work.TREE, capture_output=True, check=True).stdout
    for name in filter(None, files.split(b"\0")):
        source = Path(os.fsdecode(name))
        if (work.TREE / source).is_file():
            (tree / source).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(work.TREE / source, tree / source)
    goals = ["-n", "program"] if short else ["program"]
    made = subprocess.run(["make", *goals, "JOBS=2"], cwd=tree, capture_output=True, text=True)
    row.tried(made.returncode == 0, made.stdout[-600:] + made.stderr[-600:])
    if not short and made.returncode == 0:
        ended = subprocess.run([tree / "build/crawford", "run", "fig05", "--fidelity", "draft", "-q", "--out", tree / "o"],
                               capture_output=True, text=True)
        row.tried(ended.returncode == 0, ended.stderr)
        row.tried(*ensemble_in(tree))
    row.saw("make -n program" if short else "make program, a figure and an ensemble there")
    yield row


def ensemble_in(tree):
    """Four tiny burns through Snakemake: whether their page is there, and what was said."""
    few = (tree / "workflow/tiny.yaml").read_text().replace("last: 250", "last: 1")
    (tree / "few.yaml").write_text(few)
    ended = subprocess.run(["make", "ensemble", "ENSEMBLE=few.yaml", "OUT=o p"], cwd=tree, capture_output=True, text=True)
    return (tree / "o p/ensemble/ensemble.html").is_file(), ended.stdout[-600:] + ended.stderr[-600:]
