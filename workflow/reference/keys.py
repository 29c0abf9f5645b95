"""Reference page of all keys of study.toml."""

from ..study import ALL_TABLES, QUANTITIES, Key, default_of, values_of

INTRODUCTIONS = {
    "study": "The title of the study and the number of lines that it averages over.",
    "material": "The elastomer: a spring G, a dashpot of viscosity Gτ, and any number of Maxwell "
    "branches in parallel.",
    "material.wlf": "The constants in the inline table `wlf` of `[material]`.",
    "material.arrhenius": "The constants in the inline table `arrhenius` of `[material]`.",
    "surface": "The rigid line: random and self-affine, measured, or of a measured spectrum.",
    "surface.spectrum": "The keys of the inline table `spectrum` of `[surface]`.",
    "grid": "The values of the axes. The first six axes are dimensions of every result.",
    "scene": "The computed quantities, the motion of the line and its load.",
    "scene.programme": "A segment may also follow a file, as "
    '`[[scene.programme]]` with `file = "NAME"`.',
    "scene.drive": "The spring and damper between the drive and the line, for segments `pull`.",
    "scene.heat": "The heat of friction, as `[scene.heat]`; a half-space only, of a material with "
    "a shift.",
    "scene.shear": "The shear stress of the real contact, as `[scene.shear]`; a half-space only.",
    "numerics": "The discretisation and the requested accuracy.",
    "cluster": "The workers that compute the study. Results do not depend on this table.",
}
SEGMENT_INTRODUCTION = "The keys of a segment `[[scene.programme]]` with `{0} = {{…}}`."


def keys_page() -> str:
    """Return the entries of all keys as Markdown."""
    lines: list[str] = []
    for table, keys in ALL_TABLES.items():
        name = table.rpartition(".")[2]
        introduction = INTRODUCTIONS.get(table) or SEGMENT_INTRODUCTION.format(name)
        lines += [f"## The table [{table}]\n", f"{introduction}\n"]
        lines += [_entry(f"{table}.{name}", key) for name, key in keys.items()]
        if table == "scene":
            lines += _quantities()
    return "\n".join(lines)


def _entry(heading: str, key: Key) -> str:
    values, default = values_of(key), default_of(key)
    unit = f", in {key.unit.replace(', ', ' and ')}" if key.unit else ""
    usual = f" {_capital(default)}." if default.startswith("required") else f" Default: {default}."
    usual = "" if default == "none" else usual
    text = f"{key.means} {key.doubled}".rstrip()
    return f"### {heading}\n\n*{_capital(values)}{unit}.{usual}*\n\n{text}\n"


def _capital(text: str) -> str:
    return text[0].upper() + text[1:]


def _quantities() -> list[str]:
    """Return the table of quantities."""
    rows = [
        f"| `{name}` | {quantity.effect} | "
        + (" or ".join(f"`{other}`" for other in quantity.needs) or "nothing")
        + " |"
        for name, quantity in QUANTITIES.items()
    ]
    head = ["#### Quantities\n", "| name | what is computed | needs |", "|---|---|---|"]
    return [*head, *rows, ""]
