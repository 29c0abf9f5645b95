"""Measured studies: no grid of problems; the folder's measure.py says what is measured.

study.toml holds [study] with title and seed, [measure] with the settings that measure.py
declares, and [scales.NAME]. measure.py holds

    SETTINGS   name -> check(key, value), which returns the value or raises UserError
    outline(settings) -> (lines that say what would be measured, predicted core-seconds)
    measure(settings, seed, advance) -> group -> xarray.Dataset; "" is the root. It calls
               advance(seconds) with the predicted seconds of each part that is done
    table(result) -> pandas.DataFrame of a finished result, if the study has one
    summary(datasets) -> lines to print after a run, if the study has any
"""

import json
import sys
import time
from pathlib import Path

from workflow.axes import integer
from workflow.durable import write_durably
from workflow.errors import UserError
from workflow.progress import Reporter, duration
from workflow.provenance import origin
from workflow.scripts import load_script
from workflow.settings import as_table, as_text, check_keys
from workflow.study import Measured

TABLES = ("study", "measure")


def read_measured(name: str, folder: Path, tables: dict) -> Measured:
    """Return the checked study. Raises UserError, one line, for what a user can get wrong."""
    check_keys("", tables, TABLES)
    head = as_table("study", tables.get("study", {}))
    check_keys("study.", head, ("title", "seed"))
    script = load_script(folder / "measure.py")
    given = as_table("measure", tables["measure"])
    check_keys("measure.", given, tuple(script.SETTINGS))
    settings = {}
    for key, check in script.SETTINGS.items():
        if key not in given:
            raise UserError(f"measure.{key}: missing")
        settings[key] = check(f"measure.{key}", given[key])
    return Measured(
        name=name,
        folder=folder,
        text=json.dumps(tables, indent=1, sort_keys=True, default=str),
        title=as_text("study.title", head.get("title", name)),
        seed=integer("study.seed", head.get("seed", 0), 0),
        settings=settings,
        script=script,
    )


def plan_measured(study: Measured, result: Path) -> str:
    """Return what a run would measure and how long it would take; measures nothing."""
    lines, seconds = study.script.outline(study.settings)
    head = [f"study       {study.name}: {study.title}", f"result      {result}"]
    return "\n".join([*head, *lines, f"predicted   {duration(seconds)} of one core"])


def run_measured(study: Measured, result: Path) -> str:
    """Measure, write the result file durably; return what to print: a summary and the time.

    An interrupted measurement writes nothing: an earlier result stays as it was.
    """
    from workflow.dataset import write_datasets  # slow to import: a plan does without

    lines, seconds = study.script.outline(study.settings)
    print("\n".join(lines), file=sys.stderr)
    began = time.process_time()
    with Reporter("measuring", seconds) as reporter:
        datasets = study.script.measure(study.settings, study.seed, reporter.advance)
    used = time.process_time() - began
    origins = origin(study)
    _make_folder(result.parent)
    write_datasets(
        result, {name: data.assign_attrs(origins | data.attrs) for name, data in datasets.items()}
    )
    summary = study.script.summary(datasets) if hasattr(study.script, "summary") else []
    return "\n".join(
        [*summary, f"{duration(used)} of core time used, {duration(seconds)} predicted"]
    )


def write_measured_table(study: Measured, result: Path) -> Path:
    """Write NAME.csv beside a result file and return it."""
    if not hasattr(study.script, "table"):
        raise UserError(f"study {study.name!r}: has no table")
    from workflow.results import BROKEN, broken

    path = result.with_suffix(".csv")
    try:
        frame = study.script.table(result)
    except BROKEN as error:
        raise broken(study, result, error) from error
    write_durably(path, frame.to_csv(index=False, float_format="%.4g").encode())
    return path


def _make_folder(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise UserError(f"{folder}: cannot be made: {error}") from error
