"""What the lines of a study are: random self-affine, measured, or random like measured ones."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ....kernels import amplitudes, equivalent_of_cut, matching_rolloff
from ..effects import FOUNDATION, HALF_SPACE
from .profile import Profile

LINES = ("measured", "random-phase", "equivalent", "self-affine")
OF_MAPS = ("measured", "random-phase")  # those of them that maps can be


class Surface(NamedTuple):
    """What the lines are, in SI units."""

    length: float  # m; of a measured line, before it was mirrored
    normalisation: str = "modal"
    snap_spacing: bool = False
    rolloff: float = 0.0  # m, the wavelength above which the spectrum is flat; 0: none
    cutoff: float = 0.0  # m, the shortest wavelength; 0: twice the spacing
    profile: Profile | None = None  # what was measured
    lines: str = "measured"  # with a profile: its lines, or random ones like them (LINES)
    hurst: float = 1.0  # of lines that are self-affine like the measured ones
    body: str = FOUNDATION  # what is behind it

    @property
    def copies(self) -> float:
        """Return how much longer than the measured one the period of a half-space's map is.

        Mirrored both ways it carries four times the force on twice the length, so that F_N/L
        doubles. On a line both double.
        """
        if self.profile is None or self.body == FOUNDATION:
            return 1.0
        return self.profile.length / self.profile.measured_length

    @property
    def pressed_area(self) -> float:
        """Return the area (m^2) that a nominal pressure acts on to make up the normal force.

        A half-space is a square of side L. Of a line of elements each length lambda_r, the longest
        wave of its roughness, stands for a square of that side, so that F_N = sigma_0 lambda_r L.
        """
        longest = self.length if self.body == HALF_SPACE else self.rolloff or self.length
        return longest * self.length

    def modes(self, elements: int) -> tuple[float, int]:
        """Return the wave numbers of roll-off and cut-off, in 2 pi/L; 0 where there is none.

        A cut-off at what the elements resolve is none.
        """
        rolloff = self.length / self.rolloff if self.rolloff else 0.0
        last = int(self.length / self.cutoff * (1.0 + 1e-9)) if self.cutoff else elements // 2
        return rolloff, last if last < elements // 2 else 0

    @property
    def amplitudes(self) -> np.ndarray | None:
        """The mode amplitudes (m) of random lines like measured ones; None: lines are others.

        ``random-phase`` lines have the mean power spectrum of the measured ones, ``equivalent``
        ones that of the line which stands for the isotropic surface they were cut from, and
        ``self-affine`` ones their rms height and slope, by a long-wave roll-off.
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
        return profile.roughness * _like(self.hurst, elements, slope)

    @property
    def spectrum(self) -> np.ndarray | None:
        """The mode amplitudes (m) of the lines, measured or like measured ones; None: others."""
        modes = self.amplitudes
        return self.profile.amplitudes if self.profile is not None and modes is None else modes

    @property
    def description(self) -> str:
        """What the lines are, in words; empty without a file."""
        if self.profile is None:
            return ""
        like = {
            "measured": "",
            "random-phase": "random lines of the power spectrum of ",
            "equivalent": "random lines equivalent to the isotropic surface that was cut, of ",
            "self-affine": f"self-affine lines, H = {self.hurst:g}, of rms height and slope of ",
        }
        return like[self.lines] + self.profile.notes

    @property
    def identity(self) -> str:
        """What measured lines, and those made like them, are known by; empty without a file."""
        if self.profile is None:
            return ""
        own = f" H = {self.hurst!r}" if self.lines == "self-affine" else ""
        return f"{self.profile.digest} {self.lines}{own}"


@lru_cache
def _like(hurst: float, elements: int, slope: float) -> np.ndarray:
    """Return the amplitudes (h) of self-affine lines of a slope (h/dx): found by halving."""
    return amplitudes(hurst, elements, "modal", matching_rolloff(hurst, elements, slope))
