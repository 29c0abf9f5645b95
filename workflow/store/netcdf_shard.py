"""Conversion of netCDF shards, written by version 0.3.0, to .npz shards."""

import re

from .shard import ForeignFile, digest, packed, text_array

NETCDF_FORMAT = "elastomer-friction shard 3"
NETCDF_SUFFIX = ".nc"
NETCDF_NAMES = {"batches": "chunk", "keys": "key", "scalars": "scalars", "curves": "curves"}


def converted(name: str, content: bytes, fault: str) -> bytes:
    """Convert the bytes of a netCDF shard; return the bytes of an .npz shard of the same records.

    fault : reason why the file cannot be read, from ``unreadable``, or "". Raises ForeignFile for a
    file of another program or version, and ValueError for a damaged file.
    """
    if digest(content) != name:
        raise ValueError("its content does not match the checksum in its name")
    if not re.search(NETCDF_FORMAT.encode() + rb"(?![0-9])", content):
        raise ForeignFile("is not a shard of version 0.3.0")
    if fault:
        raise ValueError(fault)
    import netCDF4  # slow to import, and rarely needed

    try:
        with netCDF4.Dataset("shard.nc", memory=content) as data:
            data.set_auto_maskandscale(False)
            variables = {name: data[old] for name, old in NETCDF_NAMES.items()}
            claimed = sum(v.size * v.dtype.itemsize for v in variables.values())
            if claimed > len(content):
                raise ValueError(f"its arrays claim {claimed} bytes, and it has {len(content)}")
            arrays = {name: variable[:] for name, variable in variables.items()}
            return packed({"makers": text_array(data.makers), **arrays})
    except (AttributeError, LookupError, OSError, RuntimeError, TypeError, ValueError) as error:
        raise ValueError(f"it is not a valid shard: {error}") from error
