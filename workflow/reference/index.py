"""The index: every key, variable and quantity in the order of the alphabet."""

import re

from ..result import described_variables
from ..study import EVERY_TABLE, QUANTITIES, described_measures

HEAD = """# Index

Every key of `study.toml`, every variable of a result and every quantity, in the order of the
alphabet. Symbols and terms are in the [glossary](../glossary.md), commands on
[their page](commands.md).

| name | what it is |
|---|---|"""


def index_page() -> str:
    """Return the page of the index as Markdown."""
    rows = {}
    places = {table: (f"key of `[{table}]`", keys) for table, keys in EVERY_TABLE.items()}
    for study, keys in described_measures().items():
        places[f"{study}: measure"] = (f"key of `[measure]` of the study `{study}`", keys)
    for table, (where, keys) in places.items():
        for key in keys:
            heading = f"{table}.{key}"
            rows[key, where] = f"[`{key}`](keys.md#{anchor(heading)}) | {where}"
    for section in described_variables().values():
        for variable in section:
            said = f"variable: {variable.long_name}"
            link = f"results.md#{anchor(variable.name)}"
            rows[variable.name, said] = f"[`{variable.name}`]({link}) | {said}"
    for name, quantity in QUANTITIES.items():
        said = f"quantity: {quantity.effect}"
        rows[name, said] = f"[`{name}`](keys.md#quantities) | {said}"
    return "\n".join([HEAD, *(f"| {rows[name]} |" for name in sorted(rows))])


def anchor(heading: str) -> str:
    """Return the name by which pages link to a heading."""
    return re.sub(r"[^\w\- ]", "", heading).strip().lower().replace(" ", "-")
