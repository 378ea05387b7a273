"""Hold any code's numbers against an order, and its fields against exact solutions.

    import crawford
    crawford.gate(h, errors, order=2, within=0.1, reason="central differences")
    T = crawford.truth("slab", material="AP")(x, y)["temperature"]

All numbers are SI. NumPy arrays come back where NumPy is installed, lists where it is not.
"""

import csv
import json
import os
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Any, Dict, Iterable, List, Mapping, Optional, Tuple, Union

from .engine import InputError, NumericalFailure
from . import engine as _engine

try:
    import numpy as _np
except ImportError:
    _np = None

__all__ = ["order", "gate", "truth", "truths", "judge", "read_history", "read_snapshot",
           "InputError", "NumericalFailure"]


def _numbers(values: Iterable[float]) -> List[float]:
    return [float(value) for value in values]


def order(h: Iterable[float], values: Iterable[float], *, kind: str = "value",
          expect: Optional[float] = None, within: float = 0.1, scatter: float = 0.2,
          size: float = 1.0, name: str = "values") -> Dict[str, Any]:
    """The observed order of values on several grids, and how far they are from their limit.

    h: cell sizes, any unit, in any order. values: one for each.
    kind: "value" (limit not known) or "error" (falls to zero).
    expect, within: the order they must have; `passed` is None without.
    scatter: how far a pairwise order may lie from the fit. size: of the truth of errors; below
    1e-12 of it is round-off.

    A dict as one of the `quantities` of `crawford order --json`: h, values, pairwise_orders, fit,
    verdict, passed, failure, estimate (the name of the one to believe), estimates.
    """
    if kind not in ("value", "error"):
        raise InputError(f'kind = "{kind}" must be "value" or "error"')
    found, _ = _engine.judged(name, kind == "error", _numbers(h), _numbers(values), expect, within,
                              scatter, size, "expected")
    return json.loads(found)


def gate(h: Iterable[float], errors: Iterable[float], order: float = 2.0, within: float = 0.1,
         reason: str = "", scatter: float = 0.2, size: float = 1.0, name: str = "error") -> None:
    """Does nothing if the errors fall at this order; else AssertionError with the table.

    h: cell sizes, any unit. errors: one for each, falling to zero. order, within: what the fit over
    all grids must be. reason: why this order, for who reads the failure. scatter, size: as in
    order(). Two grids, a NaN, equal errors, round-off, errors that rise in between and an order
    that is too high never pass.
    """
    if not reason:
        raise InputError("gate: say the reason for this order")
    found, table = _engine.judged(name, True, _numbers(h), _numbers(errors), float(order), within,
                                  scatter, size, reason)
    if not json.loads(found)["passed"]:
        raise AssertionError(f"{table}because {reason}")


class _Truth:
    """An exact solution; call it with points [m] and a time [s]."""

    def __init__(self, name: str, given: Mapping[str, Union[float, str]]):
        self.name = name
        self._truth = _engine.Truth(name, dict(given))
        #: name -> (unit, meaning)
        self.fields: Dict[str, Tuple[str, str]] = {
            field.name: (field.unit, field.meaning) for field in self._truth.fields}

    def __call__(self, x: Any, y: Any, t: float = 0.0) -> Dict[str, Any]:
        """All fields at the points (x, y) [m] at the time t [s], SI: name -> array."""
        if _np is None:
            found = self._truth.values(_numbers(x), _numbers(y), t)
            return dict(zip(self.fields, found))
        x, y = _np.broadcast_arrays(_np.asarray(x, float), _np.asarray(y, float))
        found = self._truth.values(x.ravel().tolist(), y.ravel().tolist(), t)
        return {name: _np.reshape(values, x.shape) for name, values in zip(self.fields, found)}


def truth(name: str, **parameters: Union[float, str]) -> _Truth:
    """The exact solution of this name (truths()); parameters are SI numbers or texts.

    `crawford truth NAME --help` lists parameters, units, limits and fields. InputError for a wrong
    one, or a point outside.
    """
    return _Truth(name, parameters)


def truths() -> Dict[str, str]:
    """Every exact solution: name -> what it is."""
    return dict(_engine.truths())


def _program() -> str:
    beside = Path(__file__).resolve().parents[2] / "crawford"
    found = os.environ.get("CRAWFORD") or (str(beside) if beside.is_file() else
                                           shutil.which("crawford"))
    if not found:
        raise InputError("the program crawford is not found; set CRAWFORD to its path")
    return found


def _units_of(case: str) -> Dict[str, str]:
    run = subprocess.run([_program(), "judge", case, "--describe", "--json", "-"],
                         capture_output=True, text=True)
    if run.returncode != 0:
        raise InputError(run.stderr.strip())
    return {field["name"]: field["unit"] for field in json.loads(run.stdout)["fields"]}


def _write_results(file: Path, fields: Mapping[str, Any], units: Mapping[str, str]) -> None:
    columns = {name: _numbers(values) for name, values in fields.items()}
    if len({len(values) for values in columns.values()}) != 1:
        raise InputError("x, y and the fields differ in length")
    heading = {"x": "m", "y": "m", "weight": "1", **units}
    with open(file, "w", newline="") as stream:
        writer = csv.writer(stream)
        writer.writerow([f"{name} [{heading.get(name, '1')}]" for name in columns])
        writer.writerows([repr(value) for value in row] for row in zip(*columns.values()))


def judge(case: str, results: Mapping[int, Mapping[str, Any]], *, expect: Optional[float] = None,
          within: float = 0.1, parameters: Optional[Mapping[str, str]] = None,
          time: str = "0 s") -> Dict[str, Any]:
    """Fields of another code against the exact solution of a case, as `crawford judge` does.

    results: cells along the refined side -> {"x": [m], "y": [m], "temperature": [K], ...}, SI, and
    "weight" where points do not all count alike. parameters: {"depth": "300 um"}. The dict of
    `crawford judge --json`: `passed` (None without gates), `gates`, `not_gated`.
    """
    units = _units_of(case)
    with tempfile.TemporaryDirectory() as directory:
        command = [_program(), "judge", case, "--time", time]
        for key, value in (parameters or {}).items():
            command += ["--set", f"{key}={value}"]
        if expect is not None:
            command += ["--expect", repr(expect), "--within", repr(within)]
        for grid, fields in results.items():
            file = Path(directory) / f"{grid}.csv"
            _write_results(file, fields, units)
            command.append(f"{grid}={file}")
        run = subprocess.run(command + ["--json", "-"], capture_output=True, text=True)
    if run.returncode not in (0, 1):
        raise InputError(run.stderr.strip())
    return json.loads(run.stdout)


def read_history(file: Union[str, Path]) -> Dict[str, Any]:
    """The history of a burn (NAME_history.csv): "heading [unit]" -> numbers."""
    with open(file, newline="") as stream:
        rows = [row for row in csv.reader(stream) if row and not row[0].startswith("#")]
    columns = zip(*([float(cell or "nan") for cell in row] for row in rows[1:]))
    return {name: _np.array(values) if _np is not None else list(values)
            for name, values in zip(rows[0], columns)}


def read_snapshot(file: Union[str, Path]) -> Dict[str, Any]:
    """A snapshot (NAME_000123.hdf): "time" [s], "points" [m], then the fields at points and cells.

    name -> array, SI; the last dimension of stress is XX YY ZZ XY YZ XZ. Needs h5py.
    """
    import h5py

    with h5py.File(file) as stream:
        grid = stream["VTKHDF"]
        found = {"time": float(stream["crawford/time"][()]), "points": grid["Points"][:]}
        for place in ("PointData", "CellData"):
            found.update({name: grid[place][name][:] for name in grid[place]})
    return found
