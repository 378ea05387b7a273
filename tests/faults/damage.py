"""JSON that can be parsed and says something else: a member is missing, or is of another kind."""

import copy
import json
import shutil

import work
from table import Row

OTHERS = [5, -1, 1.5, 1e300, "x", "", None, True, [], [1], {}]
GONE = object()


def damaged_json(place, random, short):
    row = Row("JSON that says something else")
    for file, commands in read_by(place):
        sound = file.read_bytes()
        for command in commands:
            for _ in range(1 if short else 30):
                what = damage(file, sound, random)
                beside = {f: f.read_bytes() for f in file.parent.iterdir() if f.suffix == ".h5"}
                ended = work.run(command)
                wrong = misbehaved(ended)
                if ended.code == 2 and any(not f.exists() or f.read_bytes() != data for f, data in beside.items()):
                    wrong = "refused, and a checkpoint is not what it was"
                row.tried(not wrong, f"{command[0]}, {file.name}, {what}: {wrong}")
        file.write_bytes(sound)
    row.saw("done, or exit 2 and one line that names it; what lies beside it stays")
    yield row


def read_by(place):
    """Files of finished runs, and who reads them."""
    burn, out, ledger = work.Burn(steps=15), place / "out", place / "out/figures/ledger.json"
    for what, folder in ((burn, place / "burn"), (work.verify(), out), (work.figure(), out)):
        work.run(what.arguments(folder))
    shutil.copy(work.TREE / "results/ledger.json", ledger)
    report, draw = ["report", "--out", out], work.figure().arguments(out)
    gather = ["gather", place / "burn", "--out", place / "table"]
    yield place / "burn/manifest.json", [burn.arguments(place / "burn") + ["--resume"], ["runs", "--out", place / "burn"],
                                         gather]
    yield place / "burn/sandwich.hdf.series", [burn.going_on(place / "burn")]
    yield out / "verify.json", [report, ["verify", "stress-work", "--quiet", "--against", out / "verify.json", "--out",
                                         place / "now"]]
    yield out / "figures/fig05_manifest.json", [report, draw]
    yield out / "records/fig05.jsonl", [report, draw]
    yield ledger, [report, ["ledger", "--out", out]]


def damage(file, sound, random):
    """Changes one member of the document, or of the last of several, and says what."""
    *before, last = sound.splitlines() if file.suffix == ".jsonl" else [sound]
    document = json.loads(last)
    path = random.choice(list(members(document)))
    other = random.choice([*OTHERS, GONE])
    file.write_bytes(b"\n".join([*before, json.dumps(changed(document, path, other)).encode()]) + b"\n")
    return f"{'/'.join(map(str, path))} {'gone' if other is GONE else json.dumps(other)}"


def members(value, path=()):
    """The way to each member; into a list by its first item."""
    inside = value.items() if isinstance(value, dict) else enumerate(value[:1]) if isinstance(value, list) else ()
    for key, part in inside:
        yield (*path, key)
        yield from members(part, (*path, key))


def changed(document, path, other):
    document = copy.deepcopy(document)
    holder = document
    for key in path[:-1]:
        holder = holder[key]
    if other is GONE:
        del holder[path[-1]]
    else:
        holder[path[-1]] = other
    return document


def misbehaved(ended):
    if ended.code not in (0, 1, 2):
        return f"exit {ended.code}: {ended.err.strip()}"
    if ended.code == 2 and len(ended.says()) != 1:
        return f"not one line: {ended.err.strip()}"
    return f"in the words of a library: {ended.err.strip()}" if "exception" in ended.err else ""
