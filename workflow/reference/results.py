"""The page of every variable of a result."""

from ..result import AXIS_ATTRIBUTES, FLAGS, SECTIONS, VARIABLES
from ..study import AXES, EVERY_AXIS

HEAD = """# Every variable of a result

A run writes one netCDF file, `results/NAME.nc`, with the study at its root and each table
`[compare.NAME]` as a group of the same variables; [Python](../python.md) shows how to open it. An
entry gives the dimensions and the unit where they are not the grid and 1, then the formula, with
the number of the equation in [the paper](https://doi.org/10.1038/srep05795), and what a sign or a
flag says. Symbols are in the [glossary](../glossary.md).

**Dimensions.** "Grid" stands for the six dimensions {axes}, each of length 1 at least, and for
those of {others} that the study has.

**Errors.** Every estimate `NAME` has its standard error `NAME_error`, by a jackknife over blocks of
lines: the error of chance alone, by which lines were drawn. `NAME_bias` is the bound of the
relative discretisation error of `mu_1`, `jump` and `relaxation_rate` ([errors](../errors.md)).

**Missing numbers.** A number that cannot be known is NaN, and a flag beside it says why; −1 means
that the computation of this point failed. What `scene.quantities` does not name is absent.

**Provenance.** The global attributes hold the settings (`study`, as JSON), the seed, the versions
of program and packages, the commit, the processor and the scheme.
"""


def results_page() -> str:
    """Return the page of variables as Markdown."""
    names = [f"`{axis}`" for axis in EVERY_AXIS]
    *others, last = names[len(AXES) :]
    head = HEAD.replace("{axes}", ", ".join(names[: len(AXES)]))
    head = head.replace("{others}", f"{', '.join(others)} and {last}")
    lines = [head, "## Coordinates\n"]
    lines += ["| name | meaning | unit |", "|---|---|---|"]
    lines += [f"| `{n}` | {said} | {unit} |" for n, (unit, said) in AXIS_ATTRIBUTES.items()]
    lines.append("")
    explained: dict[str, str] = {}  # flags -> the first variable that has them
    for title, meanings in SECTIONS.items():
        lines.append(f"## {title}\n")
        for name, text in meanings.items():
            lines += [*_entry(name, text), *_flags(name, explained)]
    return "\n".join(lines)


def _entry(name: str, text: str) -> list[str]:
    variable = VARIABLES[name]
    beyond = [f"`{dim}`" for dim in variable.dims if dim not in AXES]
    dims = " × ".join(["Grid", *beyond])
    if not set(AXES) <= set(variable.dims):
        dims = " × ".join(f"`{dim}`" for dim in variable.dims) or "A single number"
    unit = "" if variable.units == "1" else f", in {variable.units}"
    place = [f"*{dims}{unit}.*\n"] if f"{dims}{unit}" != "Grid" else []
    return [f"### {name}\n", *place, f"{_plain(text)}\n"]


def _flags(name: str, explained: dict[str, str]) -> list[str]:
    """Return the table of flags, or a link to the variable that has the same."""
    if name not in FLAGS:
        return []
    first = explained.setdefault(FLAGS[name], name)
    if first != name:
        return [f"Its flags are those of [`{first}`](#{first}).\n"]
    said = dict(_meanings(VARIABLES[name].comment))
    rows = []
    for value, flag in enumerate(("failed", *FLAGS[name].split()), -1):
        more = f": {said[flag]}" if flag in said else ""
        rows.append(f"| {value} | `{flag}`{more} |".replace("| -1", "| −1"))
    return ["| flag | meaning |", "|---|---|", *rows, ""]


def _meanings(comment: str) -> list[tuple[str, str]]:
    """Return (flag, meaning) for each of a comment "flag: meaning; flag: meaning"."""
    parts = [part.partition(": ") for part in comment.split("; ")]
    return [(name, meaning) for name, colon, meaning in parts if colon]


def _plain(text: str) -> str:
    """Return a text whose asterisks, as in mu*, are not read as marks of Markdown."""
    return text.replace("*", r"\*")
