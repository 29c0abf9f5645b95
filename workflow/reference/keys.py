"""The page of every key of study.toml."""

from ..study import (
    COMPARE,
    EVERY_TABLE,
    QUANTITIES,
    Key,
    default_of,
    described_measures,
    values_of,
)

HEAD = """# Every key of study.toml

A study is described by one TOML file. This page lists every table of it and every key, with the
values that a key takes, its unit, and its default. Each entry ends with what changes when the
value is doubled, or, where a key is no number, when it is another one.
[A tutorial](../tutorial.md) builds a study step by step.

All quantities are in SI units, and a number without a unit is dimensionless. Unknown keys, keys of
the wrong type and values out of range, at any scale, end a command with one line for each and exit
status 2, before anything is computed; the line says where in the file the key stands.
`elastomer-friction schema` prints a JSON schema of the file, with which editors check and complete
it. In what follows, L is `surface.length`, G is `material.shear_modulus`, F̄ = F_N/(4GLh) is the
dimensionless normal force, and x = v₁ τ q_max is the dimensionless velocity, in which τ is the
relaxation time of the elastomer and q_max the largest wave number of the line.

**Lists and ranges.** Where an entry says "a list or range", the key takes a number, a list
`[0.3, 0.5]`, `{linspace = [first, last, count]}` or `{geomspace = [first, last, count]}`. The grid
is the product of all lists, and each list is a dimension of the result. A grid may have 300 000
points and an axis 10 000 values.

**Scales.** Tables `[scales.NAME.TABLE]` hold values that replace those of `[TABLE]` when a command
is given `--scale NAME`. The studies of this program have `smoke` (seconds) and `paper` (the full
grid of the paper). The result of a scale is the file `NAME-SCALE.nc`, beside `NAME.nc`. After that,
`--set table.key=value` on the command line replaces single values.

**Comparisons.** Each table `[compare.NAME]` repeats the whole study, on the same random lines, with
other values of these keys: {compare}. Its results are the group NAME of the result file.

**Measured studies.** A folder with `measure.py` measures the program itself. It has a table
`[measure]` in place of a grid, whose keys are its own. Those of the studies of this program are at
the end of this page.
"""
INTRODUCTIONS = {
    "study": "What the study is called and how many lines it averages over.",
    "material": "The elastomer: a spring G, a dashpot of viscosity Gτ, and any number of Maxwell "
    "branches in parallel.",
    "material.wlf": "The constants in the inline table `wlf` of `[material]`.",
    "surface": "The rigid line: random and self-affine, or measured.",
    "grid": "The values of every axis. Each of the first six is a dimension of every result.",
    "scene": "What is computed, and how the line is driven and pressed on.",
    "scene.programme": "A segment may also follow a file, as "
    '`[[scene.programme]]` with `file = "NAME"`.',
    "numerics": "How the problem is discretised, and how accurate it is to be.",
    "cluster": "Where the study is computed. No number of a result depends on this table.",
}
MEASURES = "How much the study `{0}` measures, and of what."
SEGMENT = "The keys of a segment `{0}`, as `[[scene.programme]]` with `{0} = {{…}}`."


def keys_page() -> str:
    """Return the page of keys as Markdown."""
    lines = [HEAD.replace("{compare}", ", ".join(f"`{key}`" for key in COMPARE))]
    for table, keys in EVERY_TABLE.items():
        name = table.rpartition(".")[2]
        introduction = INTRODUCTIONS.get(table) or SEGMENT.format(name)
        lines += [f"## The table [{table}]\n", f"{introduction}\n"]
        lines += [_entry(f"{table}.{name}", key) for name, key in keys.items()]
        if table == "scene":
            lines += _quantities()
    for study, keys in described_measures().items():
        lines += [f"## The table [measure] of {study}\n", f"{MEASURES.format(study)}\n"]
        lines += [_entry(f"{study}: measure.{name}", key) for name, key in keys.items()]
    return "\n".join(lines)


def _entry(heading: str, key: Key) -> str:
    default = default_of(key)
    said = [
        f"Value: {values_of(key)}",
        default if default.startswith("required") else f"default: {default}",
    ]
    if key.unit:
        said.insert(1, f"unit: {key.unit}")
    return f"### {heading}\n\n*{'; '.join(said)}.*\n\n{key.means} {key.doubled}\n"


def _quantities() -> list[str]:
    """Return the table of what a scene can be asked for."""
    rows = [
        f"| `{name}` | {quantity.effect} | "
        + (" or ".join(f"`{other}`" for other in quantity.needs) or "nothing else")
        + " |"
        for name, quantity in QUANTITIES.items()
    ]
    head = ["#### Quantities\n", "| name | what is simulated | needs |", "|---|---|---|"]
    return [*head, *rows, ""]
