"""Files of instruments, which SurfaceTopography reads in a separate process with limits."""

import io
import os
from pathlib import Path
from typing import Any

import numpy as np

from ...system import limit_cpu_time, limit_memory, read_apart, requested_paths
from .positions import rounding
from .raw_lines import LineFile, RawLines, plain, row_spacing

MIN_READ_SECONDS, READ_BYTES_PER_SECOND = 5.0, 2e6  # CPU time
MIN_MEMORY_BYTES, MEMORY_PER_BYTE = 2.0**29, 16.0  # beyond that of the imported packages
HDF5_SIGNATURE = b"\x89HDF\r\n\x1a\n"


def read_instrument_file(file: LineFile) -> RawLines:
    """Return the lines of a file that SurfaceTopography reads, in its units.

    Raises UserError if SurfaceTopography is missing, and ValueError if it does not recognise the
    file or exceeds the limits of memory and CPU time.
    """
    output, fault = read_apart(__name__, [file.path])
    if fault:
        raise ValueError(fault)
    arrays = np.load(io.BytesIO(output), allow_pickle=False)
    if "missing" in arrays:
        raise file.refused(
            f"files {file.path.suffix or 'without suffix'} that are not text are read by "
            "SurfaceTopography, which is not installed: pip install SurfaceTopography"
        )
    if "fault" in arrays:
        raise ValueError(str(arrays["fault"]))
    unit, rows, kind = str(arrays["unit"]), None, "line"
    if "row_pixel" in arrays:
        rows, kind = row_spacing(np.array([0.0, arrays["row_pixel"]]), unit), "map"
    return RawLines(
        arrays["heights"],
        (unit, unit),
        f"read by SurfaceTopography as a {kind}",
        arrays["x"],
        rounding(arrays["x"]),
        row_spacing=rows,
    )


def _arrays(path: Path) -> dict[str, Any]:
    """Return the arrays of a file, or why there are none."""
    try:
        import SurfaceTopography
    except ImportError:
        return {"missing": True}
    size = path.stat().st_size
    limit_memory(MIN_MEMORY_BYTES + MEMORY_PER_BYTE * size)
    limit_cpu_time(MIN_READ_SECONDS + size / READ_BYTES_PER_SECOND)
    try:
        _check_single(path)
        topography: Any = SurfaceTopography.read_topography(str(path))
        arrays = {"unit": str(topography.unit or "")}
        if topography.dim == 2:  # a map: every row along x is a line
            x = np.arange(topography.nb_grid_pts[0]) * topography.pixel_size[0]
            heights, row_pixel = plain(topography.heights()).T, topography.pixel_size[1]
            return arrays | {"x": x, "heights": heights, "row_pixel": row_pixel}
        x, z = topography.positions_and_heights()
        return arrays | {"x": plain(x), "heights": plain(z)[None, :]}
    except MemoryError:
        return {"fault": "it claims more data than its size allows"}
    except Exception as error:  # the readers of forty formats raise any exception
        reason = str(error).partition("\n")[0].rstrip(": ")
        detail = "" if reason.startswith("tried") else f" ({reason:.200})"
        return {"fault": f"no reader of SurfaceTopography recognises it{detail}"}


def _check_single(path: Path) -> None:
    """Raise ValueError for an HDF5 file that stores its content in other files."""
    with path.open("rb") as file:
        if file.read(len(HDF5_SIGNATURE)) != HDF5_SIGNATURE:
            return
    import h5py

    def check(name: str, item: Any) -> None:
        if isinstance(item, h5py.ExternalLink) or (
            isinstance(item, h5py.Dataset) and (item.external or item.is_virtual)
        ):
            raise ValueError(f"{name}: its content is in another file")

    with h5py.File(path) as data:
        data.visititems_links(check)
        data.visititems(check)


def _main() -> None:
    """Send the arrays of the file that standard input names."""
    (path,) = requested_paths()
    with os.fdopen(os.dup(1), "wb") as output:
        os.dup2(2, 1)  # readers may print
        np.savez(output, **_arrays(path))


if __name__ == "__main__":
    _main()
