"""Every key of a study.toml checked, wherever it stands: all that is wrong is said at once."""

from collections.abc import Mapping
from typing import Any

from ...errors import Complaints
from ..cluster import CLUSTER
from ..settings import Key, as_table, check_keys
from ..study import BY_NAME, TABLES
from ..variants import COMPARE

KEYS: Mapping[str, Mapping[str, Key]] = {**TABLES, "cluster": CLUSTER}


def check_every_key(tables: Mapping[str, Any], scales: Mapping[str, Any]) -> None:
    """Raise UserError for the keys, types and ranges of a study of a grid, all of them at once.

    tables : those in force. scales : those that are not asked for; what their values come to
    together, as the number of points, is left to the day when they are.
    """
    complaints = Complaints()
    _check_tables("", tables, complaints)
    for name, scale in scales.items():
        with complaints:
            _check_tables(f"scales.{name}.", as_table(f"scales.{name}", scale), complaints)
    complaints.end()


def _check_tables(where: str, tables: Mapping[str, Any], complaints: Complaints) -> None:
    for name, table in tables.items():
        with complaints:
            check_keys(where, [name], (*TABLES, *BY_NAME, "cluster"))
            if name == "compare":
                for label, own in as_table(f"{where}{name}", table).items():
                    _check_table(f"{where}{name}.{label}", own, COMPARE, complaints)
            elif name in KEYS:
                _check_table(f"{where}{name}", table, KEYS[name], complaints)


def _check_table(
    where: str, table: object, keys: Mapping[str, Key], complaints: Complaints
) -> None:
    with complaints:
        for name, value in as_table(where, table).items():
            with complaints:
                check_keys(f"{where}.", [name], keys)
                keys[name].check(f"{where}.{name}", value)
