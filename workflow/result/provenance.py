"""Where a result comes from: program, packages, processor, commit, settings. No dates, no names."""

import subprocess
from collections.abc import Set
from pathlib import Path

from ..simulate import CODE_HASH
from ..study import AnyStudy, Numerics, Study
from ..system import ROOT, Maker, package_versions, this_maker, version_of

REFERENCE = "Li, Dimaki, Popov, Psakhie, Popov (2014), Sci. Rep. 4, 5795, doi:10.1038/srep05795"
LICENCE = (
    "The program is under the MIT licence, which leaves its results to those who compute them."
)


def commit(root: Path = ROOT) -> str:
    """Return the git commit of the program, marked where files differ from it, or "unknown".

    root : the folder of the program. A repository that it merely lies in, as an environment with
    its packages lies in somebody's project, says nothing of it: the program must be its top, and
    known to it.
    """
    try:
        if Path(_git(root, "rev-parse", "--show-toplevel")).resolve() != root.resolve():
            return "unknown"
        _git(root, "ls-files", "--error-unmatch", "workflow/result/provenance.py")
        return _git(root, "describe", "--always", "--dirty", "--abbrev=40")
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def _git(root: Path, *command: str) -> str:
    said = subprocess.check_output(
        ["git", "-C", str(root), *command], stderr=subprocess.DEVNULL, text=True
    )
    return said.strip()


def made_by(makers: Set[Maker]) -> dict[str, str]:
    """Return the attributes that say what computed the records of a result; "mixed" if several."""
    found = {}
    for name in Maker._fields:
        texts = sorted({getattr(maker, name) for maker in makers})
        mixed = f"mixed: {' | '.join(texts)}"
        found[name] = mixed if len(texts) > 1 else "".join(texts) or "unknown"
    return found


def origin(study: AnyStudy) -> dict[str, str | int | float]:
    """Return the global attributes that every result file has, whatever its kind of study.

    As its maker stands this process; a run says instead what computed the stored records.
    """
    program = f"elastomer-friction {version_of('elastomer-friction')}"
    return {
        "Conventions": "CF-1.8",
        "title": study.title,
        "source": program,
        "history": f"{program}: run {study.name}",  # no date: the same study gives the same file
        "license": LICENCE,
        "references": REFERENCE,
        "commit": commit(),
        "code": CODE_HASH,
        "written_with": package_versions(),
        **made_by({this_maker()}),
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
