"""The table [surface]: random self-affine lines, or lines that were measured."""

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from kernels.surfaces.self_affine import NORMALISATIONS
from workflow.errors import UserError
from workflow.study.effects.profile import Profile
from workflow.study.settings import Key, choice, flag, positive, read_table

SURFACE = {
    "length": Key(positive),
    "normalisation": Key(partial(choice, known=NORMALISATIONS), "modal"),
    "snap_spacing": Key(flag, False),
    "rolloff": Key(positive, 0.0),
    "cutoff": Key(positive, 0.0),
}


class Surface(NamedTuple):
    """What the lines are, in SI units."""

    length: float  # m; of a measured line, before it was mirrored
    normalisation: str = "modal"
    snap_spacing: bool = False
    rolloff: float = 0.0  # m, the wavelength above which the spectrum is flat; 0: none
    cutoff: float = 0.0  # m, the shortest wavelength; 0: twice the spacing
    profile: Profile | None = None  # the measured lines
    phases: str = "measured"  # or "random": random lines of the spectrum of the measured ones

    def modes(self, elements: int) -> tuple[float, int]:
        """Return the wave numbers of roll-off and cut-off, in 2 pi/L; 0 where there is none.

        A cut-off at what the elements resolve is none.
        """
        rolloff = self.length / self.rolloff if self.rolloff else 0.0
        last = int(self.length / self.cutoff * (1.0 + 1e-9)) if self.cutoff else elements // 2
        return rolloff, last if last < elements // 2 else 0


def read_surface(table: Any, folder: Path) -> Surface:
    """Return the surface of a study; files are found from its ``folder``. Raises UserError."""
    surface = Surface(**read_table("surface", table, SURFACE))
    if surface.rolloff and not surface.cutoff < surface.rolloff < surface.length:
        raise UserError(
            f"surface.rolloff = {surface.rolloff!r}: must lie between surface.cutoff = "
            f"{surface.cutoff!r} and surface.length = {surface.length!r}, all of them in m"
        )
    return surface


def check_cutoff(surface: Surface, grid: Mapping[str, tuple[float, ...]]) -> None:
    """Raise UserError where elements do not resolve the shortest wavelength of their lines."""
    for spacing in grid["spacing"]:
        if surface.cutoff and surface.cutoff < 2.0 * spacing * (1.0 - 1e-9):
            raise UserError(
                f"surface.cutoff = {surface.cutoff!r}: must be two spacings or more, which "
                f"grid.spacing = {spacing!r} makes {2.0 * spacing:g}"
            )
        if surface.rolloff and surface.rolloff <= 2.0 * spacing:
            raise UserError(
                f"surface.rolloff = {surface.rolloff!r}: must be longer than two spacings, which "
                f"grid.spacing = {spacing!r} makes {2.0 * spacing:g}"
            )
