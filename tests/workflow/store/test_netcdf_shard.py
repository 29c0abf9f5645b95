"""Shards of version 0.3.0 that are not converted, and the reasons."""

import pytest

from elastomer_friction.workflow.store.netcdf_shard import NETCDF_FORMAT, converted
from elastomer_friction.workflow.store.shard import ForeignFile, digest

SHARD = NETCDF_FORMAT.encode()


@pytest.mark.parametrize(
    ("name", "content", "fault", "error", "reason"),
    [
        ("other", SHARD, "", ValueError, "does not match the checksum"),
        (digest(b"foreign"), b"foreign", "", ForeignFile, "not a shard of version"),
        (digest(SHARD), SHARD, "its header is cut", ValueError, "its header is cut"),
    ],
    ids=["damaged", "foreign", "unreadable"],
)
def test_a_file_that_is_no_sound_shard_is_refused(name, content, fault, error, reason):
    with pytest.raises(error, match=reason):
        converted(name, content, fault)
