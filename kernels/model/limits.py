"""Loads and speeds of steady sliding that double precision resolves."""

LOAD_LIMITS = (1e-100, 1e100)  # Fbar; the rounding of d does not depend on it
SPEED_LIMITS = (1e-12, 1e12)  # vbar; below it rounding would show in the jump, which falls with v


def check_range(name: str, value: float, limits: tuple[float, float]) -> None:
    """Raise ValueError with the name and the value if it is NaN or outside the limits."""
    least, most = limits
    if not least <= value <= most:
        raise ValueError(f"{name} = {value:g}: must lie between {least:g} and {most:g}")
