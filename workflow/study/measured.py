"""Measured studies: no grid of problems; the folder's measure.py says what is measured.

study.toml holds [study] with title and seed, [measure] with the settings that measure.py
declares, and [scales.NAME]. measure.py holds

    SETTINGS   name -> Key: its check, check(key, value), returns the value or raises UserError;
               of this program, docs/reference/measures.md says what it means
    outline(settings) -> (lines that say what would be measured, core-seconds that it takes on the
               typical machine, which workflow/plan/cost/work.py describes)
    measure(settings, seed, advance) -> group -> xarray.Dataset; "" is the root. It calls
               advance(seconds) with what each part that is done takes of these seconds
    table(groups) -> pandas.DataFrame of a finished result, if the study has one
    summary(groups) -> lines to print after a run, if the study has any
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
    """Return the checked study. Raises UserError, one line, for what a user can get wrong."""
    check_keys("", tables, ("study", "measure"))
    head = study_head(name, folder, tables, read_table("study", tables.get("study", {}), HEAD))
    script = load_script(folder / "measure.py")
    for key, stated in script.SETTINGS.items():
        if not isinstance(stated, Key):
            raise UserError(
                f"{folder / 'measure.py'}: SETTINGS[{key!r}] is a check alone; it is now "
                "Key(check), from elastomer_friction.workflow.study"
            )
    settings = read_table("measure", tables["measure"], script.SETTINGS)
    return Measured(**head, settings=settings, script=script)
