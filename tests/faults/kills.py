"""kill -9 at random moments, over and over, until the end is reached: is it that of an unbroken run?"""

import os
import signal
import time

import work
from table import Row
from whole import halves


def killed_at(process, seconds):
    """Kills the program and all that it has started. False if it had ended before."""
    try:
        process.wait(seconds)
    except Exception:
        pass
    had_ended = process.poll() is not None
    if not had_ended:
        os.killpg(process.pid, signal.SIGKILL)
    process.communicate()
    return not had_ended


def chain(what, out, unbroken, seconds, kills, random, row):
    """One run, killed again and again. It always goes on: where it comes to its end it begins anew."""
    places = 0
    while kills > 0:
        folder = out / f"{what.name}{places}"
        places += 1
        arguments = what.arguments(folder)
        while kills > 0:
            # Mostly early, so that what is under way is met everywhere; sometimes up to the end.
            process = work.start(arguments)
            if not killed_at(process, random.uniform(0.0, 1.05 * seconds)):
                break
            kills -= 1
            torn = halves(folder) if folder.exists() else []
            row.tried(not torn, f"{what.name}: torn: {', '.join(torn)}")
            arguments = what.going_on(folder)
            if random.random() < 0.4:
                break
        ended = work.run(what.going_on(folder))
        if ended.code != 0:
            row.lost(f"{what.name}: does not go on: exit {ended.code}: {ended.err.strip()}")
        elif difference := what.difference(folder, unbroken):
            row.lost(f"{what.name}: {difference} differs in {folder}")


def rows(place, random, short):
    kinds = [(work.Burn(), 4 if short else 40), (work.verify(), 2 if short else 20), (work.figure(), 2 if short else 20),
             (work.short_ledger() if short else work.ledger(), 2 if short else 20)]
    for what, kills in kinds:
        row = Row(f"kill -9, {what.name}")
        unbroken = place / f"unbroken-{what.name}"
        began = time.time()
        ended = work.run(what.arguments(unbroken))
        if ended.code != 0:
            row.lost(f"unbroken: exit {ended.code}: {ended.err.strip()}")
        else:
            chain(what, place, unbroken, time.time() - began, kills, random, row)
            row.saw("goes on, and ends in the same bits")
        yield row
