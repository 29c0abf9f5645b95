"""Sentences on the elastic body of a result, and on the error of the model."""

import numpy as np
import xarray as xr


def body_in_words(data: xr.Dataset) -> str:
    """Return a sentence on the body of a result and the reason for it; "" if it is not stated."""
    facts = [data.attrs[name] for name in ("body", "body_reason") if name in data.attrs]
    return f"Body: {', '.join(facts)}." if facts else ""


def model_in_words(data: xr.Dataset) -> str:
    """Return a sentence on the error of the model, or its reason to be unknown; "" without both."""
    source = data.attrs.get("model_ratio_source", "")
    ratio = data.model_ratio.values if "model_ratio" in data else np.empty(0)
    known = np.isfinite(ratio)
    if not known.any():
        return f"Error of the model: {source}" if source else ""
    ends = dict.fromkeys(f"{value:.2g}" for value in (ratio[known].min(), ratio[known].max()))
    with np.errstate(all="ignore"):
        errors = data.model_ratio_error.values[known] / ratio[known]
    error = f"± {np.median(errors):.0%}" if np.isfinite(errors).all() else "error unknown"
    some = "" if known.all() else f" at {known.sum()} points"
    notes = ", ".join(filter(None, [error, source]))
    return f"mu_1 of the foundation is {' to '.join(ends)} of that of a half-space{some} ({notes})"
