"""What the module promises to whoever calls it from a test."""

import math
import os
import subprocess
from pathlib import Path

import crawford
import pytest

H = [0.4, 0.2, 0.1]


@pytest.mark.parametrize("errors, words", [
    ([4.0, 2.0, 1.0], "order 1.000 is outside"),
    ([64.0, 8.0, 1.0], "order 3.000 is outside"),
    ([1.0, 1.0, 1.0], "same error"),
    ([4.0, math.nan, 0.25], "error is nan"),
    ([4e-16, 1e-16, 2.5e-17], "round-off"),
    ([1.0, 4.0, 0.25], "oscillating"),
])
def test_what_shows_no_second_order_never_passes(errors, words):
    with pytest.raises(AssertionError, match=words):
        crawford.gate(H, errors, order=2, within=0.1, reason="a test")


def test_two_grids_and_the_same_grid_twice_never_pass():
    with pytest.raises(AssertionError, match="2 of at least 3 grids"):
        crawford.gate([0.2, 0.1], [4.0, 1.0], reason="a test")
    with pytest.raises(AssertionError, match="same cell size"):
        crawford.gate([0.2, 0.1, 0.1], [4.0, 1.0, 1.0], reason="a test")


def test_a_gate_passes_in_any_order_of_grids():
    crawford.gate([0.1, 0.4, 0.2], [0.01, 0.16, 0.04], order=2, within=0.01, reason="a test")


def test_a_gate_needs_a_reason():
    with pytest.raises(ValueError, match="reason"):
        crawford.gate(H, [4.0, 1.0, 0.25])


def test_order_of_values_whose_limit_is_not_known():
    # Celik et al., J. Fluids Eng. 130(7), 078001 (2008), Table 1.
    h = [cells**-0.5 for cells in (18000, 8000, 4500)]
    found = crawford.order(h, [6.063, 5.972, 5.863])
    celik = found["estimates"][0]
    assert celik["name"] == "celik-2008"
    assert celik["order"] == pytest.approx(1.53, abs=0.005)
    assert celik["extrapolated"] == pytest.approx(6.1685, abs=5e-5)
    assert found["passed"] is None


def test_truths_name_what_is_wrong():
    with pytest.raises(ValueError, match="did you mean slab"):
        crawford.truth("slap")
    with pytest.raises(ValueError, match="did you mean depth"):
        crawford.truth("slab", dept=1.0)
    with pytest.raises(ValueError, match="y must be"):
        crawford.truth("slab")([0.0], [1.0])
    assert len(crawford.truths()) >= 32
    slab = crawford.truth("slab", material="binder")
    assert slab.fields["temperature"] == ("K", "T")
    assert slab([0.0], [0.0])["temperature"][0] > 300.0


def test_truths_answer_in_the_shape_of_the_points():
    np = pytest.importorskip("numpy")
    x, y = np.meshgrid(np.linspace(0.0, 1e-4, 3), np.linspace(-1e-4, 0.0, 5))
    found = crawford.truth("slab")(x, y)["temperature"]
    assert found.shape == (5, 3)
    assert (found[-1] > found[0]).all()
    assert crawford.truth("slab")(0.0, y)["temperature"].shape == (5, 3)


def test_what_a_burn_leaves_is_read(tmp_path):
    tree = Path(__file__).resolve().parents[2]
    program = os.environ.get("CRAWFORD", tree / "build" / "crawford")
    subprocess.run([program, "burn", tree / "cases/scenes/slab.toml", "--quiet", "--out", tmp_path,
                    "--set", "time.end=1 ms",
                    "--set", "output.snapshots_every=1 ms"], check=True)
    history = crawford.read_history(next(tmp_path.glob("*_history.csv")))
    time = next(name for name in history if name.startswith("time"))
    assert history[time][-1] == pytest.approx(1e-3)
    pytest.importorskip("h5py")
    snapshot = crawford.read_snapshot(sorted(tmp_path.glob("slab_0*.hdf"))[-1])
    assert snapshot["time"] == pytest.approx(1e-3)
    assert len(snapshot["temperature"]) == len(snapshot["points"])
    assert snapshot["stress"].shape[1] == 6
