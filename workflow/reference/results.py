"""The page of every variable of a result."""

from ..result import AXIS_ATTRIBUTES, DescribedVariable, described_variables
from ..study import AXES, EVERY_AXIS

HEAD = """# Every variable of a result

A run writes one netCDF file, `results/NAME.nc`. The study itself is at the root of the file, and
each table `[compare.NAME]` is a group of that name with the same variables. This page lists every
variable: its dimensions, its unit, its formula with the number of the equation in
[the paper](https://doi.org/10.1038/srep05795), what its sign says, and the meaning of each flag.
How to open a file is shown in [Python](../python.md), and the symbols are explained in the
[glossary](../glossary.md).

**Dimensions.** Every variable that is called "grid" below has the six dimensions {axes}, each of
length 1 at least, and beyond them those of {others} that
the study has.

**Errors.** Every estimate `NAME` has its standard error `NAME_error`, a jackknife over blocks of
lines. It is the error of chance alone: which lines were drawn. The bound of the discretisation
error, relative to the estimate, is `NAME_bias` for `mu_1`, `jump` and `relaxation_rate`.

**Missing numbers.** A number that cannot be known is NaN, and a flag beside it says why. A flag of
−1 means that the computation of this point failed.

**What was not asked for is absent.** `scene.quantities` names what a study computes.

**Provenance.** The global attributes hold the settings of the study (`study`, as JSON), the seed,
the versions of program and packages, the commit, the processor and the scheme.
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
    for title, variables in described_variables().items():
        lines += [f"## {title}\n", *map(_entry, variables)]
    return "\n".join(lines)


def _entry(variable: DescribedVariable) -> str:
    beyond = [dim for dim in variable.dims if dim not in AXES]
    dims = " × ".join(["grid", *(f"`{dim}`" for dim in beyond)])
    if not set(AXES) <= set(variable.dims):
        dims = " × ".join(f"`{dim}`" for dim in variable.dims)
    lines = [
        f"### {variable.name}\n",
        f"*{_plain(_capital(variable.long_name))}. Dimensions: {dims}; unit: {variable.units}.*\n",
        _plain(variable.text + (f" Sign: {_small(variable.sign)}" if variable.sign else "")) + "\n",
    ]
    if variable.flags:
        lines += ["| flag | meaning |", "|---|---|"]
        said = dict(_meanings(variable.comment))
        for value, name in enumerate(variable.flags, -1):
            more = f": {said[name]}" if name in said else ""
            lines.append(f"| {value} | `{name}`{more} |".replace("| -1", "| −1"))
        lines.append("")
    elif variable.comment:
        lines.append(f"The file remarks: {_plain(variable.comment)}.\n")
    return "\n".join(lines)


def _meanings(comment: str) -> list[tuple[str, str]]:
    """Return (flag, meaning) for each of a comment "flag: meaning; flag: meaning"."""
    parts = [part.partition(": ") for part in comment.split("; ")]
    return [(name, meaning) for name, colon, meaning in parts if colon]


def _capital(text: str) -> str:
    return text if text[1:2] in " =*" else text[0].upper() + text[1:]


def _plain(text: str) -> str:
    """Return a text whose asterisks, as in mu*, are not read as marks of Markdown."""
    return text.replace("*", r"\*")


def _small(text: str) -> str:
    return text[0].lower() + text[1:]
