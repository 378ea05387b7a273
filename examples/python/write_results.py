"""Writes what both slabs find, a CSV file for each grid: python3 write_results.py DIRECTORY"""

import sys
from pathlib import Path

import slab
import slab_first_order

for name, solve in (("right", slab.solve), ("slip", slab_first_order.solve)):
    directory = Path(sys.argv[1]) / name
    directory.mkdir(parents=True, exist_ok=True)
    for cells in (32, 64, 128, 256):
        y, temperature = solve(cells)
        rows = "".join(f"0,{1e6 * a!r},{b - 273.15!r}\n" for a, b in zip(y, temperature))
        (directory / f"{cells}.csv").write_text("x [um],y [um],temp\n" + rows)
