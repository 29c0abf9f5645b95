"""Lines of a study: random self-affine lines, measured lines, or random lines like them."""

import hashlib
import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ....kernels import (
    IsotropicSpectrum,
    amplitudes,
    equivalent_amplitudes,
    equivalent_of_cut,
    matching_rolloff,
    rms_height,
)
from ....kernels.half_space.surface import isotropic_amplitudes, rms_height_of
from ..effects import FOUNDATION, HALF_SPACE
from .profile import Profile

LINE_KINDS = ("measured", "random-phase", "equivalent", "self-affine")
MAP_KINDS = ("measured", "random-phase")  # available for maps
MIN_TILES, MAX_TILES = 3, 8  # per side of a map
TILE_WAVES = 1.5  # width in mean waves of the heights, at which tiles are nearly independent


class Surface(NamedTuple):
    """Definition of the lines, in SI units."""

    length: float  # m; of a measured line before mirroring
    normalisation: str = "modal"
    snap_spacing: bool = False
    rolloff: float = 0.0  # m, lambda_r, above which the spectrum of random lines is flat; 0: none
    cutoff: float = 0.0  # m, the shortest wavelength; 0: twice the spacing
    profile: Profile | None = None  # measured lines
    lines: str = "measured"  # with a profile: one of LINE_KINDS
    hurst: float = 1.0  # of self-affine lines like the measured ones
    body: str = FOUNDATION  # FOUNDATION or HALF_SPACE
    power: IsotropicSpectrum | None = None  # measured, of random lines or maps
    power_notes: str = ""  # its source, height and slope
    rms_slope: float = 0.0  # of the waves of this spectrum that gives the cut-off; 0: none

    @property
    def copies(self) -> float:
        """Return the ratio of the period of a half-space's map to the measured length; 1 for lines.

        A map mirrored in both directions carries four times the force on twice the length, so that
        F_N/L doubles. For a mirrored line, force and length both double.
        """
        if self.profile is None or self.body == FOUNDATION:
            return 1.0
        return self.profile.length / self.profile.measured_length

    @property
    def pressed_width(self) -> float:
        """Return the width (m) of the strip that carries the force of a nominal pressure.

        A half-space is a square of side L. On a line of elements, each length lambda_r, the longest
        wave of the roughness, represents a square of that side.
        """
        return self.length if self.body == HALF_SPACE else self.rolloff or self.length

    @property
    def pressed_area(self) -> float:
        """Return the ratio (m^2) of normal force to nominal pressure: F_N = sigma_0 lambda_r L."""
        return self.pressed_width * self.length

    @property
    def tiles(self) -> int:
        """Tiles per side whose scatter gives the error of a single map; 0 for lines.

        A tile is TILE_WAVES wide, or MIN_TILES fill the side.
        """
        if self.body == FOUNDATION or (self.profile and self.profile.heights.shape[-2] == 1):
            return 0
        waves = self.length / self.rolloff if self.rolloff else 1.0
        if self.profile is not None:
            power = np.abs(np.fft.fft2(self.profile.heights[0])) ** 2
            power[0, 0] = 0.0
            k = np.fft.fftfreq(len(power), 1.0 / len(power))
            waves = float((power * np.hypot(k[:, None], k)).sum() / power.sum()) / self.copies
        return min(max(round(waves / TILE_WAVES), MIN_TILES), MAX_TILES)

    def modes(self, elements: int) -> tuple[float, int]:
        """Return the wave numbers of roll-off and cut-off, in 2 pi/L; 0 if absent.

        A cut-off at or above the highest resolved wave number counts as absent.
        """
        rolloff, least = self.length / self.rolloff if self.rolloff else 0.0, self.least_wave
        last = int(self.length / least * (1.0 + 1e-9)) if least else elements // 2
        return rolloff, last if last < elements // 2 else 0

    @property
    def least_wave(self) -> float:
        """Return the shortest wave (m) that is given: the cut-off, or the last one of a spectrum.

        Without either, 0: it is twice the spacing.
        """
        return self.cutoff or (2.0 * math.pi / self.power.q[-1] if self.power else 0.0)

    def drawn_amplitudes(self, elements: int) -> np.ndarray:
        """Return the mode amplitudes (m) of random lines or maps of the measured spectrum.

        C_2D is flat above the roll-off, if there is one.
        """
        power, rolloff = self.power, self.rolloff
        assert power is not None
        last = 2.0 * math.pi / self.length * (self.modes(elements)[1] or elements // 2)
        flat = 2.0 * math.pi / rolloff if rolloff else 0.0

        def isotropic(q: np.ndarray) -> np.ndarray:
            return np.where(q <= last * (1.0 + 1e-9), power.at(np.maximum(q, flat)), 0.0)

        drawn = isotropic_amplitudes if self.body == HALF_SPACE else equivalent_amplitudes
        return drawn(isotropic, self.length, elements)

    def drawn_roughness(self, elements: int) -> float:
        """Return the rms height (m) of random lines or maps of the measured spectrum."""
        height = rms_height_of if self.body == HALF_SPACE else rms_height
        return height(self.drawn_amplitudes(elements))

    @property
    def amplitudes(self) -> np.ndarray | None:
        """Mode amplitudes (m) of random lines like measured ones; None for other lines.

        ``random-phase`` lines have the mean power spectrum of the measured lines. ``equivalent``
        lines represent the isotropic surface from which the measured lines were cut.
        ``self-affine`` lines match the measured rms height and slope by a roll-off at long waves.
        """
        profile = self.profile
        if profile is None or self.lines == "measured":
            return None
        if self.lines == "random-phase":
            return profile.amplitudes
        if self.lines == "equivalent":
            return equivalent_of_cut(profile.amplitudes)
        elements = profile.heights.shape[-1]
        slope = profile.slope * profile.spacing / profile.roughness
        return profile.roughness * _self_affine_amplitudes(self.hurst, elements, slope)

    @property
    def spectrum(self) -> np.ndarray | None:
        """Mode amplitudes (m) of measured lines or lines like them; None for other lines."""
        modes = self.amplitudes
        return self.profile.amplitudes if self.profile is not None and modes is None else modes

    @property
    def description(self) -> str:
        """Description of measured lines, or of a measured spectrum, in words; else empty.

        Random lines are Gaussian, so that the skewness of the measured lines is stated.
        """
        if self.profile is None:
            return self.power_notes
        gaussian = ""
        if self.lines != "measured":
            skewness = self.profile.skewness
            gaussian = f"; heights are Gaussian, those measured have a skewness of {skewness:.2g}"
        prefixes = {
            "measured": "",
            "random-phase": "random lines of the power spectrum of ",
            "equivalent": "random lines equivalent to the isotropic surface that was cut, of ",
            "self-affine": f"self-affine lines, H = {self.hurst:g}, of rms height and slope of ",
        }
        return prefixes[self.lines] + self.profile.notes + gaussian

    @property
    def single_error(self) -> str:
        """Source of the standard errors of a single line or map, in words."""
        if not self.tiles:
            return "a single line has no standard error: errors are unknown"
        return (
            "a single map: mu_1, mu_2, jump and contact_fraction have standard errors by a "
            f"jackknife over {self.tiles} x {self.tiles} tiles, unless few contacts carry the "
            "load; other errors are unknown"
        )

    @property
    def identity(self) -> str:
        """Identity of a measured spectrum, lines, or lines like them; empty without a file."""
        if self.power is not None:
            return hashlib.sha256(np.array(self.power).tobytes()).hexdigest()
        if self.profile is None:
            return ""
        exponent = f" H = {self.hurst!r}" if self.lines == "self-affine" else ""
        return f"{self.profile.digest} {self.lines}{exponent}"


@lru_cache
def _self_affine_amplitudes(hurst: float, elements: int, slope: float) -> np.ndarray:
    """Return the mode amplitudes (in h) of self-affine lines of a given rms slope (in h/dx)."""
    return amplitudes(hurst, elements, "modal", matching_rolloff(hurst, elements, slope))
