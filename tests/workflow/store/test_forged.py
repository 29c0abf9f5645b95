"""Shards and journals that contradict themselves, with the right checksums: none is believed."""

import json

import netCDF4
import numpy as np
import pytest

from elastomer_friction.workflow.store import journal
from elastomer_friction.workflow.store.merge import merge_into
from elastomer_friction.workflow.store.shard import ARRAYS, FORMAT, decode, digest
from elastomer_friction.workflow.store.verify import Verified
from tests.support.faults import endless
from tests.support.shards import BATCH, WORK, assert_holds, filled, held, records, reopened
from tests.support.small import MAKER, random_result

SOUND = {
    "chunk": np.array([[1, 0, 2]]),
    "key": np.ones((1, 16), np.uint8),
    "scalars": np.ones((2, 6)),
    "curves": np.ones((2, 5)),
}


def forged(folder, makers=(MAKER,), **arrays):
    """Return the bytes of a shard with some arrays in place of sound ones; None leaves one out.

    A tuple is the shape of numbers that nobody writes, which take no room.
    """
    with netCDF4.Dataset(folder / "forged", "w") as data:
        data.format, data.makers = FORMAT, json.dumps(makers)
        for name, values in (SOUND | arrays).items():
            if values is None:
                continue
            shape = getattr(values, "shape", values)
            dims = [*ARRAYS[name][1:], "more"][: len(shape)]
            for i, size in enumerate(shape):
                if len(data.dimensions.get(dims[i], range(size))) != size:
                    dims[i] = f"{dims[i]}_of_{name}"
                if dims[i] not in data.dimensions:
                    data.createDimension(dims[i], size)
            kind = str(getattr(values, "dtype", "f8"))
            variable = data.createVariable(name, str if kind == "object" else kind, dims)
            if shape is not values:
                variable[:] = values
    return (folder / "forged").read_bytes()


def chunks(*rows):
    """Return what tells batches."""
    return {"chunk": np.array(rows)}


VAST = 10**12
FORGED = {
    "more records told than held": chunks([1, 0, 3]),
    "fewer records told than held": chunks([1, 0, 1]),
    "records without end": chunks([1, 0, VAST]),
    "more tasks than keys": chunks([2, 0, 1]),
    "tasks and blocks less than none": chunks([-1, 0, -2], [2, 0, 0]),
    "a block before the first": chunks([1, -1, 2]),
    "a batch of nothing": chunks([1, 0, 2], [0, 0, 5]),
    "no batch": {"chunk": np.zeros((0, 3), int)},
    "batches of two numbers": chunks([1, 0]),
    "batches that are no whole numbers": chunks([1.0, 0.0, 2.0]),
    "keys of another length": {"key": np.ones((1, 32), np.uint8)},
    "more scalars": {"scalars": np.ones((2, 7))},
    "more curves than scalars": {"curves": np.ones((3, 5))},
    "curves in single precision": {"curves": np.ones((2, 5), np.float32)},
    "curves over three dims": {"curves": np.ones((2, 5, 1))},
    "curves that are words": {"curves": np.full((2, 5), "a", object)},
    "no curves": {"curves": None},
    "more than its bytes hold": {"scalars": (VAST, 6), "curves": (VAST, 5), **chunks([1, 0, VAST])},
    "makers that are numbers": {"makers": [[1, 2]]},
    "makers of three words": {"makers": [["a", "b", "c"]]},
}


def test_what_is_forged_would_be_sound_without_its_fault(tmp_path):
    content = forged(tmp_path)
    found = decode(digest(content), content)
    assert found.records == [("01" * 16, 0), ("01" * 16, 1)]


def test_shards_that_contradict_themselves_are_left_out_everywhere(tmp_path, capsys):
    stores = [filled(tmp_path / name, WORK[:1])[0].folder for name in ("ours", "theirs")]
    (sound,) = stores[0].glob("*.nc")
    contents = [forged(tmp_path, **how) for how in FORGED.values()]
    contents.append(endless(sound.read_bytes()))
    for content in contents:
        (stores[0] / f"{digest(content)}.nc").write_bytes(content)
    names = sorted(map(digest, contents))
    assert len(names) == len(FORGED) + 1
    said = "it is not made as a shard is: "
    for fault, name in zip(sorted(Verified(stores[0]).faults), names, strict=True):
        assert fault.startswith(f"{name}.nc: damaged ({said}")
    *left_out, taken = merge_into(*stores)
    for line, name in zip(left_out, names, strict=True):
        assert line.startswith(f"left out    {name}.nc: {said}")
    assert taken == f"taken over  0 of {len(names) + 1} shards, 0 records that are new"
    assert held(reopened(stores[0])) == set(records(WORK[0]))
    for line, name in zip(capsys.readouterr().err.splitlines(), names, strict=True):
        assert line.startswith(f"warning: {stores[0] / name}.nc is damaged ({said}")
        assert digest((stores[0] / f"{name}.damaged").read_bytes()) == name


def shard_of_journal(**told):
    """Return a change of what the journal tells of a shard."""
    return lambda entry: {**entry, **told} if "shard" in entry else entry


LINES = {
    "records without end": shard_of_journal(chunks=[["PART", 0, VAST]], records=4 * VAST),
    "a block before the first": shard_of_journal(chunks=[["PART", -4, 4]]),
    "blocks that are words": shard_of_journal(chunks=[["PART", 0, "4"]]),
    "batches of two numbers": shard_of_journal(chunks=[["PART", 0]]),
    "no batches": lambda entry: {k: v for k, v in entry.items() if k != "chunks"},
    "a size in words": shard_of_journal(bytes="many"),
    "makers of makers": shard_of_journal(by=[["a"]]),
    "a shard without a name": shard_of_journal(shard=3),
    "keys in a list": lambda entry: {**entry, "keys": []} if "part" in entry else entry,
    "a maker of numbers": lambda entry: {**entry, "versions": 3} if "maker" in entry else entry,
    "a failure without why": lambda entry: {"failed": "0" * 32} if "maker" in entry else entry,
    "a result without digest": lambda entry: {"result": "a"} if "maker" in entry else entry,
}


@pytest.mark.parametrize("change", LINES.values(), ids=LINES)
def test_a_line_of_the_journal_that_is_not_made_as_lines_are_is_as_one_that_is_spoilt(
    tmp_path, change
):
    filled(tmp_path, [BATCH])
    entries = [entry for entry, _ in journal.entries(tmp_path)]
    (part,) = (entry["part"] for entry in entries if "part" in entry)
    text = json.dumps([change(entry) for entry in entries]).replace("PART", part)
    (tmp_path / journal.NAME).write_bytes(journal.encoded(json.loads(text)))
    assert Verified(tmp_path).faults[0].startswith("journal, line ")
    for _ in range(2):
        assert_holds(reopened(tmp_path), BATCH, random_result(BATCH, 0))


@pytest.mark.parametrize("text", [b"words", b"[" * 10**5, b'["a list"]', b"\xff", b"3"])
def test_a_line_of_the_journal_that_is_no_entry_is_as_one_that_is_spoilt(tmp_path, text):
    filled(tmp_path, [BATCH])
    with (tmp_path / journal.NAME).open("ab") as file:
        file.write(journal.line(text))
    assert Verified(tmp_path).faults == ["journal, line 4: spoilt"]
    assert_holds(reopened(tmp_path), BATCH, random_result(BATCH, 0))
