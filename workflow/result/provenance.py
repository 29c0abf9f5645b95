"""Provenance of a result: program, packages, processor, commit and settings.

It contains no dates and no names of people, so that the same study gives the same file.
"""

import subprocess
from collections.abc import Set
from pathlib import Path

from ..simulate import CODE_HASH
from ..study import AnyStudy, Numerics, Study
from ..system import PROGRAM_ROOT, Maker, package_versions, this_maker, version_of

PAPER_REFERENCE = (
    "Li, Dimaki, Popov, Psakhie, Popov (2014), Sci. Rep. 4, 5795, doi:10.1038/srep05795"
)
LICENCE = (
    "The program is under the MIT licence, which leaves its results to those who compute them."
)


def commit(root: Path = PROGRAM_ROOT) -> str:
    """Return the git commit of the program, marked if files differ from it, or "unknown".

    root : folder of the program. It must be the top of a repository that tracks the program; a
    repository around the environment of the program does not count.
    """
    try:
        if Path(_git(root, "rev-parse", "--show-toplevel")).resolve() != root.resolve():
            return "unknown"
        _git(root, "ls-files", "--error-unmatch", "workflow/result/provenance.py")
        return _git(root, "describe", "--always", "--dirty", "--abbrev=40")
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def _git(root: Path, *command: str) -> str:
    output = subprocess.check_output(
        ["git", "-C", str(root), *command], stderr=subprocess.DEVNULL, text=True
    )
    return output.strip()


def maker_attributes(makers: Set[Maker]) -> dict[str, str]:
    """Return the versions and processor that computed records; "mixed: ..." if several."""
    attributes = {}
    for name in Maker._fields:
        texts = sorted({getattr(maker, name) for maker in makers})
        mixed = f"mixed: {' | '.join(texts)}"
        attributes[name] = mixed if len(texts) > 1 else "".join(texts) or "unknown"
    return attributes


def origin(study: AnyStudy) -> dict[str, str | int | float]:
    """Return the global attributes of every result file, for all kinds of study.

    The maker is this process; a run replaces it by those of the stored records.
    """
    program = f"elastomer-friction {version_of('elastomer-friction')}"
    return {
        "Conventions": "CF-1.8",
        "title": study.title,
        "source": program,
        "history": f"{program}: run {study.name}",  # no date: the same study gives the same file
        "license": LICENCE,
        "references": PAPER_REFERENCE,
        "commit": commit(),
        "code": CODE_HASH,
        "written_with": package_versions(),
        **maker_attributes({this_maker()}),
        "study": study.text,
        "seed": study.seed,
    }


def provenance(study: Study, numerics: Numerics) -> dict[str, str | int | float]:
    """Return the global attributes of the result file of a grid study."""
    attributes = origin(study) | {
        "realizations_per_block": study.realizations_per_block,
        "quantities": " ".join(study.scene.quantities),
        "indentation_rate": str(study.scene.indentation_rate).lower(),
        "scheme": numerics.scheme,
        "steps_per_spacing": str(numerics.steps_per_spacing or "auto"),
        "horizon": numerics.horizon,
    }
    if numerics.accuracy:
        attributes |= {"accuracy": numerics.accuracy, "max_realizations": numerics.max_realizations}
    return attributes
