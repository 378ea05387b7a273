"""Crawford beside a code of one's own, under pytest: the slab that is right passes, the slip is caught.

    make python
    python3 -m pytest examples/python
"""

import crawford
import pytest
import slab
import slab_first_order

CELLS = (32, 64, 128, 256)


def largest_errors(solve):
    exact = crawford.truth("slab", **slab.PARAMETERS)
    errors = []
    for cells in CELLS:
        y, temperature = solve(cells)
        truth = exact([0.0] * len(y), y)["temperature"]
        errors.append(max(abs(a - b) for a, b in zip(temperature, truth)))
    return [slab.DEPTH / cells for cells in CELLS], errors


def test_the_slab_is_second_order():
    h, errors = largest_errors(slab.solve)
    crawford.gate(h, errors, order=2, within=0.1, reason="central differences throughout")


def test_the_slip_at_the_surface_is_caught():
    h, errors = largest_errors(slab_first_order.solve)
    with pytest.raises(AssertionError, match=r"order 0\.9\d+ is outside|order 1\.0\d+ is outside"):
        crawford.gate(h, errors, order=2, within=0.1, reason="central differences throughout")


def judged(solve):
    results = {}
    for cells in CELLS:
        y, temperature = solve(cells)
        results[cells] = {"x": [0.0] * len(y), "y": y, "temperature": temperature}
    return crawford.judge("slab", results, parameters={
        "model": "thermal", "heat_of_reaction": "0 J/kg", "depth": "300 um"})


def test_the_judge_says_the_same():
    assert judged(slab.solve)["passed"] is True
    assert judged(slab_first_order.solve)["passed"] is False
