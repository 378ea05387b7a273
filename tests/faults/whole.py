"""Whether all that lies under a final name is whole."""

import hashlib
import json
import uuid
import xml.etree.ElementTree as ElementTree
from pathlib import Path

SEAL = 512
MARK = b"crawford, digest of what follows these 512 bytes: "


def digest(content):
    """As base/digest.hpp says: a UUID, version 5, of a name in the space of object identifiers."""
    sha1 = hashlib.sha1(uuid.NAMESPACE_OID.bytes + content).digest()
    return str(uuid.UUID(bytes=sha1[:16], version=5))


def whole_checkpoint(data):
    seal = (MARK + digest(data[SEAL:]).encode() + b"\n").ljust(SEAL, b"\0")
    return data[:SEAL] == seal


def whole_lines(text, every_line):
    """All lines but a last one without its end."""
    lines = text.split(b"\n")[:-1]
    return all(every_line(line) for line in lines)


def is_json(text):
    try:
        json.loads(text)
        return True
    except ValueError:
        return False


def whole_table(data, may_be_torn):
    lines = data.split(b"\n")
    if not may_be_torn and lines[-1]:
        return False
    rows = [line for line in lines[:-1] if line and not line.startswith(b"#")]
    return not rows or all(row.count(b",") == rows[0].count(b",") for row in rows)


def is_whole(file):
    data = file.read_bytes()
    name = file.name
    if name.endswith(".lock") or name == ".owner" or ".owner." in name or name.endswith(".part"):
        return True  # not results: locks, and halves under a name of their own
    if file.suffix in (".json", ".series"):
        return is_json(data)
    if file.suffix == ".jsonl":
        return whole_lines(data, is_json)
    if file.suffix == ".csv":
        return whole_table(data, name.endswith("_history.csv"))
    if file.suffix == ".h5":
        return whole_checkpoint(data)
    if file.suffix == ".hdf":
        # Superblock of version 0: the end of the file is told at byte 40 (HDF5 file format, II.A).
        return data.startswith(b"\x89HDF\r\n\x1a\n") and int.from_bytes(data[40:48], "little") == len(data)
    if file.suffix == ".svg":
        try:
            ElementTree.fromstring(data)
            return True
        except ElementTree.ParseError:
            return False
    if file.suffix == ".html":
        return data.rstrip().endswith(b"</html>")
    return True



def halves(folder):
    """Names the files that are not whole."""
    return [str(f.relative_to(folder)) for f in sorted(Path(folder).rglob("*")) if f.is_file() and not is_whole(f)]
