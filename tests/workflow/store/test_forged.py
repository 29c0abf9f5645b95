"""Shards and journals that contradict themselves, with the right checksums: all are refused."""

import io
import json
import tracemalloc
import zipfile

import numpy as np
import pytest

from elastomer_friction.workflow.simulate.tasks import SCALARS
from elastomer_friction.workflow.store import journal, shard
from elastomer_friction.workflow.store.merge import merge_into
from elastomer_friction.workflow.store.shard import SHARD_FORMAT, decode, digest, text_array
from elastomer_friction.workflow.store.verify import Verification
from tests.support.shards import BATCH, WORK, assert_holds, filled, held, records, reopened
from tests.support.small import MAKER, random_result

WIDTH = len(SCALARS)
SOUND = {
    "format": text_array(SHARD_FORMAT),
    "makers": text_array(json.dumps([MAKER])),
    "batches": np.array([[1, 0, 2]]),
    "keys": np.ones((1, 16), np.uint8),
    "scalars": np.ones((2, WIDTH)),
    "curves": np.ones((2, 5)),
}


def npy(values):
    """Return an array in the npy format; of a tuple, which is a shape, the header alone."""
    file = io.BytesIO()
    if isinstance(values, tuple):
        header = {"descr": "<f8", "fortran_order": False, "shape": values}
        np.lib.format.write_array_header_1_0(file, header)
    else:
        np.lib.format.write_array(file, values, allow_pickle=True)
    return file.getvalue()


def forged(compressed=(), **members):
    """Return the bytes of a shard with other members; None leaves one out."""
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        for name, values in (SOUND | members).items():
            if values is not None:
                content = values if isinstance(values, bytes) else npy(values)
                kind = zipfile.ZIP_DEFLATED if name in compressed else zipfile.ZIP_STORED
                archive.writestr(f"{name}.npy", content, kind)
    return file.getvalue()


def batches(*rows):
    """Return the table of batches."""
    return {"batches": np.array(rows)}


def makers(value):
    """Return the makers as they are stored."""
    return {"makers": text_array(json.dumps(value))}


VAST = 10**12
TRUNCATED = npy(SOUND["curves"])[:-8]
FORGED = {
    "fewer rows than the batches have": forged(**batches([1, 0, 3])),
    "more rows than the batches have": forged(**batches([1, 0, 1])),
    "vast batches": forged(**batches([1, 0, VAST])),
    "more tasks than keys": forged(**batches([2, 0, 1])),
    "negative numbers of tasks and blocks": forged(**batches([-1, 0, -2], [2, 0, 0])),
    "a negative block": forged(**batches([1, -1, 2])),
    "a batch without tasks": forged(**batches([1, 0, 2], [0, 0, 5])),
    "no batch": forged(batches=np.zeros((0, 3), int)),
    "batches of two numbers": forged(**batches([1, 0])),
    "batches of floats": forged(**batches([1.0, 0.0, 2.0])),
    "keys of another length": forged(keys=np.ones((1, 32), np.uint8)),
    "more scalars": forged(scalars=np.ones((2, WIDTH + 1))),
    "more curves than scalars": forged(curves=np.ones((3, 5))),
    "curves in single precision": forged(curves=np.ones((2, 5), np.float32)),
    "curves in Fortran order": forged(curves=np.asfortranarray(np.ones((2, 5)))),
    "curves of three dimensions": forged(curves=np.ones((2, 5, 1))),
    "curves of one dimension": forged(curves=np.ones(2)),
    "curves of big-endian numbers": forged(curves=np.ones((2, 5), ">f8")),
    "curves that are objects": forged(curves=np.full((2, 5), "a", object)),
    "no curves": forged(curves=None),
    "another member": forged(more=np.ones(3)),
    "a vast array": forged(curves=(2, VAST), **batches([1, 0, 2])),
    "a vast array of no numbers": forged(curves=(2, 0, VAST)),
    "a negative shape": forged(curves=(-2, -5)),
    "a truncated array": forged(curves=TRUNCATED),
    "bytes after an array": forged(curves=npy(SOUND["curves"]) + bytes(8)),
    "a member that is not an array": forged(curves=b"not an array"),
    "a header without end": forged(curves=b"\x93NUMPY\x01\x00\xff\xff" + b"(" * 65535),
    "another version of npy": forged(curves=b"\x93NUMPY\x02" + npy(SOUND["curves"])[7:]),
    "a zip bomb": forged(["curves"], curves=np.zeros((2, 10**6))),
    "makers that are numbers": forged(**makers([[1, 2]])),
    "makers of three words": forged(**makers([["a", "b", "c"]])),
    "makers nested without end": forged(makers=text_array("[" * 10**5)),
    "makers that are not JSON": forged(makers=text_array("{")),
    "a truncated archive": forged()[:-30],
    "no archive": b"no archive, but of the format " + SHARD_FORMAT.encode(),
}


def test_the_forged_shards_are_sound_without_their_faults():
    content = forged()
    contents = decode(digest(content), content)
    assert contents.records == [("01" * 16, 0), ("01" * 16, 1)]


def test_equal_records_give_the_bytes_that_earlier_versions_gave():
    arrays = SOUND | {"scalars": np.ones((2, 3))}
    assert digest(shard.packed(arrays)) == "4e47aac4d471605408c8e3745909a649"


@pytest.mark.parametrize("content", FORGED.values(), ids=FORGED)
def test_a_forged_shard_is_refused_within_memory_in_proportion_to_its_bytes(content):
    tracemalloc.start()
    with pytest.raises(ValueError, match="it is not a valid shard: "):
        decode(digest(content), content)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 10 * len(content) + 2**20


def test_a_shard_that_does_not_fit_into_memory_is_not_called_damaged(monkeypatch):
    def full(_):
        raise MemoryError

    content = forged()
    monkeypatch.setattr(shard, "_unpacked", full)
    with pytest.raises(MemoryError):
        decode(digest(content), content)


def test_members_that_share_their_bytes_are_refused(monkeypatch):
    monkeypatch.setitem(SOUND, "curves", np.ones((2, 10**4)))
    content = forged()
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        place = archive.getinfo("curves.npy").header_offset
        other = archive.getinfo("scalars.npy").header_offset
    entry = content.rindex(b"scalars.npy") - 46  # in the table of contents
    assert content[entry + 42 : entry + 46] == other.to_bytes(4, "little")
    shared = content[: entry + 42] + place.to_bytes(4, "little") + content[entry + 46 :]
    with pytest.raises(ValueError, match="it is not a valid shard: "):
        decode(digest(shared), shared)


def test_forged_shards_are_left_out_everywhere(tmp_path, capsys):
    stores = [filled(tmp_path / name, WORK[:1])[0].folder for name in ("ours", "theirs")]
    for content in FORGED.values():
        (stores[0] / f"{digest(content)}.npz").write_bytes(content)
    names = sorted(map(digest, FORGED.values()))
    assert len(names) == len(FORGED)
    reason = "it is not a valid shard: "
    for fault, name in zip(sorted(Verification(stores[0]).faults), names, strict=True):
        assert fault.startswith(f"{name}.npz: damaged ({reason}")
    *left_out, merged = merge_into(*stores)
    for line, name in zip(left_out, names, strict=True):
        assert line.startswith(f"left out    {name}.npz: {reason}")
    assert merged == f"merged      0 of {len(names) + 1} shards, 0 new records"
    assert held(reopened(stores[0])) == set(records(WORK[0]))
    for line, name in zip(capsys.readouterr().err.splitlines(), names, strict=True):
        assert line.startswith(f"warning: {stores[0] / name}.npz is damaged ({reason}")
        assert digest((stores[0] / f"{name}.damaged").read_bytes()) == name


def changed_shard(**fields):
    """Return a change of the entries of shards."""
    return lambda entry: {**entry, **fields} if "shard" in entry else entry


LINES = {
    "vast batches": changed_shard(chunks=[["PART", 0, VAST]], records=4 * VAST),
    "a negative block": changed_shard(chunks=[["PART", -4, 4]]),
    "blocks that are floats": changed_shard(chunks=[["PART", 0, 4.0]]),
    "blocks that are words": changed_shard(chunks=[["PART", 0, "4"]]),
    "batches of two numbers": changed_shard(chunks=[["PART", 0]]),
    "no batches": lambda entry: {k: v for k, v in entry.items() if k != "chunks"},
    "a size in words": changed_shard(bytes="many"),
    "makers of makers": changed_shard(by=[["a"]]),
    "a shard without a name": changed_shard(shard=3),
    "keys in a list": lambda entry: {**entry, "keys": []} if "part" in entry else entry,
    "a maker of numbers": lambda entry: {**entry, "versions": 3} if "maker" in entry else entry,
    "a failure without why": lambda entry: {"failed": "0" * 32} if "maker" in entry else entry,
    "a result without digest": lambda entry: {"result": "a"} if "maker" in entry else entry,
}


@pytest.mark.parametrize("change", LINES.values(), ids=LINES)
def test_an_invalid_line_of_the_journal_is_treated_as_a_spoilt_one(tmp_path, change):
    filled(tmp_path, [BATCH])
    entries = [entry for entry, _ in journal.entries(tmp_path)]
    (part,) = (entry["part"] for entry in entries if "part" in entry)
    text = json.dumps([change(entry) for entry in entries]).replace("PART", part)
    (tmp_path / journal.NAME).write_bytes(journal.encoded(json.loads(text)))
    assert Verification(tmp_path).faults[0].startswith("journal, line ")
    for _ in range(2):
        assert_holds(reopened(tmp_path), BATCH, random_result(BATCH, 0))


@pytest.mark.parametrize("change", [{}, {"keys": ""}], ids=["of tasks", "of none"])
def test_a_line_that_claims_vast_blocks_takes_no_memory_and_hides_no_shard(tmp_path, change):
    filled(tmp_path, [BATCH])
    entries = [entry for entry, _ in journal.entries(tmp_path)]
    part = {"keys": "0" * 32} | change
    part["part"] = digest(part["keys"].encode())
    records = VAST * (len(part["keys"]) // 32)
    vast = {"chunks": [[part["part"], 0, VAST]], "bytes": 10**3 * VAST, "records": records}
    forged = [part, *(entry | vast for entry in entries if "shard" in entry)]
    tracemalloc.start()
    journal.append(tmp_path, forged)
    for _ in range(2):
        assert_holds(reopened(tmp_path), BATCH, random_result(BATCH, 0))
        tmp_path.joinpath(journal.NAME).write_bytes(journal.encoded([*forged, *entries]))
    assert tracemalloc.get_traced_memory()[1] < 2**22
    tracemalloc.stop()


@pytest.mark.parametrize("text", [b"words", b"[" * 10**5, b'["a list"]', b"\xff", b"3"])
def test_a_line_without_an_entry_is_treated_as_a_spoilt_one(tmp_path, text):
    filled(tmp_path, [BATCH])
    with (tmp_path / journal.NAME).open("ab") as file:
        file.write(journal.line(text))
    assert Verification(tmp_path).faults == ["journal, line 4: spoilt"]
    assert_holds(reopened(tmp_path), BATCH, random_result(BATCH, 0))
