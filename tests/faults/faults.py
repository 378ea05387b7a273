#!/usr/bin/env python3
"""The fault campaign: breaks runs of crawford in every way that happens, and looks whether anything is lost.

    make faults                 all of it; make faults-short: a few tries of each fault
    tests/faults/faults.py --short --only kill --seed 7

Ends with a table, and with exit code 1 if anything was lost. The seed decides when and where things break; it is
printed, and the same seed breaks the same places as far as the machine keeps pace.
"""

import argparse
import random
import shutil
import sys
import tempfile
import time
from pathlib import Path

import damage
import disks
import kills
import people
import table

CAMPAIGNS = {
    "kill": kills.rows, "disk": disks.full_disks, "place": disks.no_place, "memory": disks.little_memory,
    "clock": disks.clock_set_back, "comma": disks.comma_locale, "signals": people.signals,
    "checkpoints": people.damaged_checkpoints, "json": damage.damaged_json, "two": people.two_in_one_folder,
    "names": people.names, "make": people.make_from_such_a_place}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--short", action="store_true", help="a few tries of each")
    parser.add_argument("--only", choices=CAMPAIGNS, action="append", help="may be repeated")
    parser.add_argument("--seed", type=int, default=random.randrange(10**6))
    parser.add_argument("--keep", action="store_true", help="leave the folders of the runs where they are")
    options = parser.parse_args()
    place = Path(tempfile.mkdtemp(prefix="crawford-faults-"))
    rows = []
    began = time.time()
    print(f"faults, seed {options.seed}, in {place}", flush=True)
    try:
        for name in options.only or CAMPAIGNS:
            folder = place / name
            folder.mkdir()
            for row in CAMPAIGNS[name](folder, random.Random(options.seed), options.short):
                rows.append(row)
                print(f"{row.fault}: {row.tries} tries, {len(row.losses)} lost; {time.time() - began:.0f} s",
                      flush=True)
                for loss in row.losses:
                    print("  lost:", loss, flush=True)
            if not any(row.losses for row in rows) and not options.keep:
                shutil.rmtree(folder)
    except KeyboardInterrupt:
        print(f"interrupted in {name}: the rows that had ended are\n\n" + (table.text(rows) if rows else "none"))
        return 130
    print("\n" + table.text(rows))
    if any(row.losses for row in rows):
        print(f"what was lost lies in {place}")
        return 1
    if not options.keep:
        shutil.rmtree(place)
    return 0


sys.exit(main())
