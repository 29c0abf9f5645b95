"""Sentences on the elastic body of a result, its real contact, and the error of the model."""

import numpy as np
import xarray as xr

from ..study import Surface

MAX_RESOLVED_AREA = 0.3  # of the real contact over the nominal one, without a cut-off


def contact_warning(surface: Surface, area: float) -> str:
    """Return a warning if waves shorter than the samples may matter, or "".

    area : largest real contact area over the nominal one. The real contact of a random surface
    falls as 1/(rms slope), which grows with every shorter wave until the cut-off of the surface.
    """
    if surface.profile is not None or surface.cutoff or not area > MAX_RESOLVED_AREA:
        return ""
    return (
        f"the real contact is {area:.2g} of the nominal area and depends on grid.spacing, as no "
        "surface.cutoff is given: the shear is that of an unresolved surface"
    )


def slope_warning(slope: float) -> str:
    """Return a warning if the largest rms slope exceeds one, or "": small slopes are assumed."""
    if not slope > 1.0:
        return ""
    return f"the rms slope is {slope:.3g}, but slopes are assumed to be small"


def body_in_words(data: xr.Dataset) -> str:
    """Return sentences on the body of a result, its effects and its slope; "" if unknown."""
    facts = [data.attrs[name] for name in ("body", "body_reason") if name in data.attrs]
    body = f"Body: {', '.join(facts)}." if facts else ""
    heat = f"Heating: {data.attrs['heat']}." if "heat" in data.attrs else ""
    warning = slope_warning(float(data.rms_slope.max())) if "rms_slope" in data else ""
    steep = f"Warning: {warning}." if warning else ""
    return " ".join(filter(None, (body, _shear_in_words(data), heat, steep)))


def _shear_in_words(data: xr.Dataset) -> str:
    """Return a sentence on the shear of a result, with the slope and the shortest wave, or ""."""
    if "shear" not in data.attrs:
        return ""
    slopes, waves = data.rms_slope.values, 2.0 * np.pi / data.q_max.values
    slope, wave = (
        " to ".join(dict.fromkeys(f"{end:.3g}" for end in (np.nanmin(values), np.nanmax(values))))
        for values in (slopes, waves)
    )
    warning = data.attrs.get("contact_warning", "")
    text = f"Shear of the real contact: {data.attrs['shear']}; rms slope {slope}, with waves down "
    return f"{text}to {wave} m{f'; {warning}' if warning else ''}."


def model_in_words(data: xr.Dataset) -> str:
    """Return a sentence on the error of the model, or why it is unknown; "" without either."""
    source = data.attrs.get("model_ratio_source", "")
    ratio = data.model_ratio.values if "model_ratio" in data else np.empty(0)
    finite = np.isfinite(ratio)
    if not finite.any():
        return f"Error of the model: {source}" if source else ""
    ends = dict.fromkeys(f"{value:.2g}" for value in (ratio[finite].min(), ratio[finite].max()))
    with np.errstate(all="ignore"):
        errors = data.model_ratio_error.values[finite] / ratio[finite]
    error = f"± {np.median(errors):.0%}" if np.isfinite(errors).all() else "error unknown"
    where = "" if finite.all() else f" at {finite.sum()} points"
    notes = ", ".join(filter(None, [error, source]))
    return f"mu_1 of the foundation is {' to '.join(ends)} of that of a half-space{where} ({notes})"
