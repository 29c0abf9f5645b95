"""Measured maps as a half-space uses them: periodic and square, x along the rows."""

import hashlib

import numpy as np

from ....kernels.half_space.surface import map_amplitudes, rms_slope_of
from ...ground import UserError
from .as_read import KEY, LEAST_SAMPLES, Asked
from .files import read_lines
from .positions import UNEVEN
from .profile import (
    DETRENDS,
    FLAT,
    PERIODICS,
    Profile,
    check_finite,
    check_slope,
    given_heights,
    make_periodic,
    quietly,
)


class MapProfile(Profile):
    """Maps in place of lines: heights of shape (maps, n, n), or (maps, 1, n) of line contacts."""

    @property
    def amplitudes(self) -> np.ndarray:
        """Return the rms amplitudes |h_q| of the modes over all maps (m), as of a ring."""
        return np.sqrt(np.mean([map_amplitudes(own) ** 2 for own in self.heights], axis=0))

    @property
    def roughness(self) -> float:
        """Return the rms height over all maps, each about its own mean (m)."""
        return float(np.sqrt(np.mean(np.var(self.heights, axis=(1, 2)))))

    @property
    def slope(self) -> float:
        """Return the rms of the full gradient over all maps."""
        return float(np.divide(rms_slope_of(self.amplitudes, self.heights.shape[-1]), self.spacing))


@quietly
def read_map(asked: Asked, detrend: str, periodic: str) -> MapProfile:
    """Return the prepared map of a file, the largest square in its middle. Raises UserError.

    Its rows must be as far apart as the samples of a row, and are where the file does not say.
    """
    what = f"{KEY} = {asked.name!r}"
    if asked.gaps == "drop":
        raise UserError('surface.gaps = "drop": leaves rows out of a map; use "fill"')
    lines = read_lines(asked)
    rows, samples = lines.heights.shape
    if rows < LEAST_SAMPLES:
        raise UserError(
            f"{what}: {rows} rows of {samples} samples are no map, which a half-space needs; use "
            'scene.body = "foundation", or scene.run with a line contact'
        )
    if lines.apart is not None and abs(lines.apart / lines.step - 1.0) > UNEVEN:
        raise UserError(
            f"{what}: its rows are {lines.apart:.4g} m apart and samples {lines.step:.4g} m: a "
            "half-space needs a map of square cells"
        )
    side = min(rows, samples)
    top, left = (rows - side) // 2, (samples - side) // 2
    square = lines.heights[top : top + side, left : left + side]
    levelled = _levelled(square, detrend)
    _check_not_flat(what, levelled, square)
    copies = PERIODICS[periodic]
    whole = make_periodic(make_periodic(levelled, periodic).T, periodic).T
    assumed = " (assumed)" if lines.apart is None else ""
    cut = "" if rows == samples else f"; the middle {side} x {side} of {rows} x {samples}"
    notes = (
        f"{lines.notes}; a map, rows as far apart as samples{assumed}{cut}; {detrend} "
        f"removed, {periodic}"
    )
    found = map_profile(whole[None], copies * lines.step * side, copies, notes)
    check_slope(what, "check surface.units", found)
    said = f"; h = {found.roughness:.4g} m, rms slope {found.slope:.4g}"
    return found._replace(notes=found.notes + said)


def _check_not_flat(what: str, heights: np.ndarray, raw: np.ndarray) -> None:
    """Raise UserError for a map that is flat as a whole; single rows of it may be."""
    if heights.std() <= FLAT * np.abs(raw).max():
        raise UserError(f"{what}: is flat: needs heights that differ by more than a trend")


def _levelled(heights: np.ndarray, detrend: str) -> np.ndarray:
    """Return a map less the polynomial in x and y that is fitted to it: mean, plane, parabola."""
    degree = DETRENDS[detrend]
    if degree is None:
        return heights
    t = np.linspace(-1.0, 1.0, len(heights))
    terms = [
        (t[:, None] ** i * t[None, :] ** j).ravel()
        for i in range(degree + 1)
        for j in range(degree + 1 - i)
    ]
    basis = np.stack(terms, axis=1)
    fitted = np.linalg.lstsq(basis, heights.ravel(), rcond=None)[0]
    return heights - (basis @ fitted).reshape(heights.shape)


@quietly
def given_map(heights: object, length: float) -> MapProfile:
    """Return the map of heights given in m, shape (n, n), or (n,) of a line contact; one period.

    length : of the side (m), n steps; one element per sample. Raises UserError that names the
    argument, ``profile``.
    """
    own = given_heights(heights)
    if own.ndim != 2 or own.shape[0] not in (1, own.shape[1]) or own.shape[1] < LEAST_SAMPLES:
        raise UserError(
            f"profile: has the shape {own.shape}: a half-space takes a square map (n, n), "
            f"the last axis along x, or a line contact (n,), of {LEAST_SAMPLES} samples or more"
        )
    check_finite(heights, own, "row")
    _check_not_flat("profile", own, own)
    what = "line contact" if own.shape[0] == 1 else "map"
    notes = f"given from Python: a {what} of {own.shape}, one period as it is"
    profile = map_profile(own[None], length, 1, notes)
    check_slope("profile", "give heights and length both in m", profile)
    return profile


def map_profile(heights: np.ndarray, length: float, copies: int, notes: str) -> MapProfile:
    """Return maps as they are: of shape (maps, n, n), of a period of ``copies`` measured sides."""
    own = np.array(heights, dtype=float, order="C")
    own.setflags(write=False)
    digest = hashlib.sha256(f"map {own.shape}".encode() + own.tobytes()).hexdigest()
    return MapProfile(own, length, length / copies, notes, digest)
