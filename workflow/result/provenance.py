"""Where a result comes from: program, packages, processor, commit, settings. No dates, no names."""

import subprocess

from workflow.simulate import CODE
from workflow.study import AnyStudy, Numerics, Study
from workflow.system import ROOT, package_versions, processor, version_of

REFERENCE = "Li, Dimaki, Popov, Psakhie, Popov (2014), Sci. Rep. 4, 5795, doi:10.1038/srep05795"


def commit() -> str:
    """Return the git commit of the program, marked where files differ from it, or "unknown"."""
    command = ["git", "-C", str(ROOT), "describe", "--always", "--dirty", "--abbrev=40"]
    try:
        return subprocess.check_output(command, stderr=subprocess.DEVNULL, text=True).strip()
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def origin(study: AnyStudy) -> dict[str, str | int | float]:
    """Return the global attributes that every result file has, whatever its kind of study."""
    return {
        "Conventions": "CF-1.8",
        "title": study.title,
        "source": f"elastomer-friction {version_of('elastomer-friction')}",
        "references": REFERENCE,
        "commit": commit(),
        "code": CODE,
        "versions": package_versions(),
        "processor": processor(),
        "study": study.text,
        "seed": study.seed,
    }


def provenance(study: Study, numerics: Numerics) -> dict[str, str | int | float]:
    """Return the global attributes of the result file of a grid study."""
    found = origin(study) | {
        "realizations_per_block": study.realizations_per_block,
        "quantities": " ".join(study.scene.quantities),
        "indentation_rate": str(study.scene.indentation_rate).lower(),
        "scheme": numerics.scheme,
        "steps_per_spacing": str(numerics.steps_per_spacing or "auto"),
        "horizon": numerics.horizon,
    }
    if numerics.accuracy:
        found |= {"accuracy": numerics.accuracy, "max_realizations": numerics.max_realizations}
    return found
