#!/usr/bin/env python3
"""Sets benchmarks beside a baseline: CPU time of each, their ratio, and the ratio as it would be on one machine.

    compare.py BASELINE.json NOW.json      both of --benchmark_out, or kept by the next
    compare.py --keep NOW.json BASELINE.json

Machines differ in dgemm; the last column takes that out: a step spends most of its time there. Above 1: slower.
"""
import json
import sys


def times(path):
    with open(path, encoding="utf-8") as file:
        found = json.load(file)
    return {one["name"]: one for one in found["benchmarks"] if one.get("run_type", "iteration") == "iteration"}


def compare(baseline, now):
    machine = now["dgemm"]["cpu_time"] / baseline["dgemm"]["cpu_time"]
    print(f"\n{'':44} {'baseline':>9} {'now':>9} {'ratio':>6} {'over dgemm':>10}")
    for name, one in now.items():
        if name not in baseline:
            print(f"{name:44} {'-':>9} {one['cpu_time']:6.2f} {one['time_unit']}")
            continue
        before = baseline[name]["cpu_time"]
        ratio = one["cpu_time"] / before
        unit = one["time_unit"]
        print(f"{name:44} {before:6.2f} {unit} {one['cpu_time']:6.2f} {unit} {ratio:6.2f} {ratio / machine:10.2f}")


def keep(source, target):
    kept = {name: {k: v for k, v in one.items() if isinstance(v, float) or k in ("name", "time_unit")}
            for name, one in times(source).items()}
    with open(target, "w", encoding="utf-8") as file:
        json.dump({"benchmarks": list(kept.values())}, file, indent=1)
        file.write("\n")


if len(sys.argv) == 4 and sys.argv[1] == "--keep":
    keep(sys.argv[2], sys.argv[3])
elif len(sys.argv) == 3:
    compare(times(sys.argv[1]), times(sys.argv[2]))
else:
    sys.exit(__doc__)
