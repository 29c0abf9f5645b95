"""Measured studies: their script measure.py runs a measurement in place of a grid of problems.

study.toml holds [study] with title and seed, [measure] with the settings that measure.py
declares, and [scales.NAME]. measure.py holds

    SETTINGS   name -> Key, whose check(key, value) returns the value or raises UserError;
               docs/reference/measures.md describes the settings of the studies of this program
    outline(settings) -> (lines that describe the measurement, its core-seconds on the typical
               machine of workflow/plan/cost.py)
    measure(settings, seed, advance) -> group -> xarray.Dataset; "" is the root. It calls
               advance(seconds) after each part, with the predicted core-seconds of that part
    table(groups) -> pandas.DataFrame of a finished result (optional)
    summary(groups) -> lines to print after a run (optional)
"""

from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any, ClassVar

from ..ground import UserError
from .scripts import load_script
from .settings import Key, check_keys, read_table
from .study import AnyStudy, study_head
from .tables import HEAD


@dataclass(frozen=True, kw_only=True)
class Measured(AnyStudy):
    """A checked measured study."""

    kind: ClassVar[str] = "measured"
    settings: dict[str, object]  # of the table [measure]
    script: ModuleType  # measure.py


def read_measured(name: str, folder: Path, tables: dict[str, Any]) -> Measured:
    """Return the checked study. Raises UserError, one line, for invalid input."""
    check_keys("", tables, ("study", "measure"))
    head = study_head(name, folder, tables, read_table("study", tables.get("study", {}), HEAD))
    script = load_script(folder / "measure.py")
    for key, stated in script.SETTINGS.items():
        if not isinstance(stated, Key):
            raise UserError(
                f"{folder / 'measure.py'}: SETTINGS[{key!r}] is a bare check; write Key(check) "
                "with Key from elastomer_friction.workflow.study"
            )
    settings = read_table("measure", tables["measure"], script.SETTINGS)
    return Measured(**head, settings=settings, script=script)
