"""A disk that is full at every write in turn, one that is read-only, a file where a folder should be; too little
memory; a clock that is set back; a comma for a point."""

import errno
import json
import os
import re
import resource
import shutil
import subprocess
from pathlib import Path

import work
from table import Row
from whole import halves


def with_preload(place, **variables):
    made = place / "failing_write.so"
    source = Path(__file__).with_name("failing_write.c")
    if not made.exists():
        subprocess.run(["cc", "-O1", "-shared", "-fPIC", "-o", made, source, "-ldl"], check=True)
    return {**os.environ, "LD_PRELOAD": str(made), **{k: str(v) for k, v in variables.items()}}


def one_line(ended, codes):
    """What is wrong with how it ended and what it said; empty if nothing."""
    if ended.code not in codes:
        return f"exit {ended.code}: {ended.err.strip()[-300:]}"
    if ended.code == 0:
        return ""
    told = [line for line in ended.says() if line.startswith("crawford") and ": remark:" not in line]
    if not told:
        return f"exit {ended.code}, and no line that says why: {ended.err.strip()[-300:]}"
    return "says: " + told[-1] if "internal error" in told[-1] else ""


def goes_on(what, folder, unbroken):
    # With the library still there: records know by which libraries they were made.
    again = work.run(what.going_on(folder) if folder.exists() else what.arguments(folder),
                     env=with_preload(unbroken.parent))
    if again.code != 0:
        return f"does not go on: exit {again.code}: {again.err.strip()[-300:]}"
    return what.difference(folder, unbroken)


def unbroken_run(what, place, row):
    folder = place / f"unbroken-{what.name}"
    count = place / f"count-{what.name}"
    ended = work.run(what.arguments(folder), env=with_preload(place, FAULT_COUNT=count))
    if ended.code != 0:
        row.lost(f"unbroken: exit {ended.code}: {ended.err.strip()}")
    return folder, int(count.read_text())


def full_disks(place, random, short):
    every = 10**6
    for what, most in ((work.Burn(steps=15), 5 if short else every), (work.verify(), 5 if short else every),
                       (work.figure(), 1 if short else 20), (work.short_ledger(), 2 if short else 20)):
        row = Row(f"disk full, {what.name}")
        unbroken, writes = unbroken_run(what, place, row)
        for at in sorted(random.sample(range(1, writes + 1), min(most, writes))):
            folder = place / f"full-{what.name}-{at}"
            ended = work.run(what.arguments(folder), env=with_preload(place, FAULT_AT=at))
            wrong = one_line(ended, {2, 3})
            if not wrong and folder.exists() and (torn := halves(folder)):
                wrong = "torn: " + ", ".join(torn)
            wrong = wrong or goes_on(what, folder, unbroken)
            row.tried(not wrong, f"write {at} of {writes}: {wrong}")
            shutil.rmtree(folder, ignore_errors=True)
        places = f"any of {writes} writes" if most >= writes else f"{most} of {writes} writes"
        row.saw(f"exit 2 at {places}; then goes on to the same bits")
        yield row


def no_place(place, random, short):
    row = Row("read-only, a file for a folder")
    file = place / "file"
    file.write_text("a file\n")
    sound = place / "sound"
    work.run(work.Burn(steps=15).arguments(sound))
    before = sorted(f.name for f in sound.iterdir())
    commands = [work.Burn(steps=15), work.verify(), work.figure(), work.Again("ledger", ["ledger"], [])]
    for what in commands:
        for folder, more in ((file, {}), (file / "below", {}),
                             (place / "new", {"env": with_preload(place, FAULT_AT=1, FAULT_ERRNO=errno.EROFS)})):
            ended = work.run(what.arguments(folder), **more)
            wrong = one_line(ended, {2})
            row.tried(not wrong, f"{what.name} into {folder}: {wrong}")
    burn = work.Burn(steps=15)
    ended = work.run(burn.arguments(sound), env=with_preload(place, FAULT_AT=1, FAULT_ERRNO=errno.EROFS))
    wrong = one_line(ended, {2}) or ("" if sorted(f.name for f in sound.iterdir()) == before else "results are gone")
    row.tried(not wrong, f"burn where results are: {wrong}")
    row.saw("exit 2 and one line; nothing there is touched")
    yield row


def little_memory(place, random, short):
    row = Row("out of memory")
    megabytes = [100, 200, 300] if short else range(40, 600, 20)
    # Where a burn just starts and just does not end, each of its libraries is once the one that finds nothing.
    at_the_edge = random.sample(range(80, 140), 6) if short else range(70, 140)
    for what in (work.Burn(steps=15), work.verify(), work.figure(), work.short_ledger()):
        unbroken, _ = unbroken_run(what, place, row)
        for size in [*megabytes, *(at_the_edge if isinstance(what, work.Burn) else [])]:
            folder = place / f"memory-{what.name}-{size}"
            limit = size << 20
            ended = work.run(what.arguments(folder),
                             preexec_fn=lambda limit=limit: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
            if "shared libraries" in ended.err or "GnuTLS initialization" in ended.err:
                continue  # not enough to load the program and its libraries: they say so
            wrong = one_line(ended, {0, 3})
            if not wrong and folder.exists() and (torn := halves(folder)):
                wrong = "torn: " + ", ".join(torn)
            row.tried(not wrong, f"{what.name} in {size} MB: {wrong}")
            shutil.rmtree(folder, ignore_errors=True)
    row.saw("done, or exit 3 and one line")
    yield row


def seconds_in(json_value):
    if isinstance(json_value, dict):
        for key, value in json_value.items():
            if key.endswith("seconds"):
                yield value
            yield from seconds_in(value)
    if isinstance(json_value, list):
        for value in json_value:
            yield from seconds_in(value)


def clock_set_back(place, random, short):
    row = Row("clock set back an hour")
    for what in (work.Burn(steps=15), work.verify()):
        unbroken, _ = unbroken_run(what, place, row)
        for after in ((1, 3) if short else range(0, 20, 2)):
            folder = place / f"clock-{what.name}-{after}"
            ended = work.run(what.arguments(folder), env=with_preload(place, CLOCK_BACK=after))
            wrong = one_line(ended, {0}) or what.difference(folder, unbroken)
            for file in [f for p in ("*.json", "records/*.jsonl") for f in folder.glob(p)] if not wrong else []:
                for line in file.read_text().splitlines() if file.suffix == ".jsonl" else [file.read_text()]:
                    if any(s is None or s < 0 or s > 600 for s in seconds_in(json.loads(line))):
                        wrong = f"{file.name} has strange seconds"
            row.tried(not wrong, f"{what.name}, after {after} looks: {wrong}")
    row.saw("same bits, seconds of the steady clock")
    yield row


def comma_locale(place, random, short):
    row = Row("comma for a point")
    made = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", place / "de_DE.UTF-8"], capture_output=True)
    if made.returncode != 0 and not (place / "de_DE.UTF-8").exists():
        row.saw("not tried: no localedef (Debian: locales)")
        yield row
        return
    env = {**os.environ, "LOCPATH": str(place), "LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8"}
    for what in (work.Burn(steps=15), work.verify(), work.figure()):
        unbroken = place / f"point-{what.name}"
        work.run(what.arguments(unbroken))
        folder = place / f"comma-{what.name}"
        ended = work.run(what.arguments(folder), env=env)
        wrong = one_line(ended, {0}) or what.difference(folder, unbroken)
        row.tried(not wrong, f"{what.name}: {wrong}")
    row.saw("same bits")
    yield row

