"""The gate of examples/ci/orders.yml, run as it stands there on the table that it begins with."""

import pathlib
import re
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TEMPLATE = (ROOT / "examples/ci/orders.yml").read_text(encoding="utf-8")


def gate():
    return re.search(r"- name: Orders\n\s+run: (.*)", TEMPLATE).group(1)


def table():
    lines = re.findall(r"^#     (.*)$", TEMPLATE, re.MULTILINE)
    return "\n".join(lines) + "\n"


def run(folder, errors):
    (folder / "crawford").symlink_to(ROOT)
    (folder / "errors.csv").write_text(errors, encoding="utf-8")
    return subprocess.run(gate(), shell=True, cwd=folder, capture_output=True, text=True, check=False)


def test_passes_second_order(tmp_path):
    done = run(tmp_path, table())
    assert done.returncode == 0, done.stdout + done.stderr
    assert '<testcase' in (tmp_path / "orders.xml").read_text(encoding="utf-8")
    assert (tmp_path / "orders.svg").stat().st_size > 0


@pytest.mark.parametrize("bad", ["1.0e-4", "1.3e-5"])
def test_fails_when_one_error_does_not_fall(tmp_path, bad):
    done = run(tmp_path, table().replace(bad, bad.replace("e-", "e-0").replace("1.", "3.")))
    assert done.returncode == 1, done.stdout + done.stderr
    assert "<failure" in (tmp_path / "orders.xml").read_text(encoding="utf-8")
