"""Time that patterns and readers take on rows and lines made to let them backtrack."""

import ast
import contextlib
import importlib
import inspect
import math
import pkgutil
import re
import signal
import time

import pytest

import elastomer_friction.workflow as program
from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study import ColumnSpec
from elastomer_friction.workflow.text_tables import table_of_text
from elastomer_friction.workflow.text_tables.headers import HeaderPattern

UNITS = (
    *(
        " ",
        "\t",
        "a",
        "a ",
        "1",
        "1 ",
        "1,",
        "1.",
        "54321 ",
        "0.5;",
        "1e5 ",
        "NaN ",
        "-",
        "- ",
        "/",
    ),
    *(" / ", "_", ".", "#", '"', '"a" ', "%", "=", ":", "x: 1; ", "x=1,", "[", "(", "]", "[m] "),
    *(
        "(a",
        "<",
        "<a>",
        "m*",
        "m ",
        "mm/",
        "10^",
        "e1",
        " per ",
        "in ",
        "G' ",
        "log ",
        "20 \u00b0C ",
        "\u00b2",
    ),
)
CHARACTERS = 250
SHORT_SECONDS = 2e-4  # up to which a pattern is linear
MAX_POWER = 2.75  # of the growth of the time with the length
LONGEST = 60.0  # CPU s of a test, after which a pattern counts as one that does not end


def patterns():
    """Return every pattern of the program: of its modules' names, and in its calls of re."""
    found = set()
    for info in pkgutil.walk_packages(program.__path__, program.__name__ + "."):
        if info.name.endswith("__main__"):
            continue
        module = importlib.import_module(info.name)
        pending = list(vars(module).values())
        for value in pending:
            if isinstance(value, ColumnSpec | HeaderPattern):
                found.add(value.names if isinstance(value, ColumnSpec) else value.separator)
            elif isinstance(value, tuple | list | dict):
                pending.extend(value.values() if isinstance(value, dict) else value)
            elif isinstance(value, re.Pattern) and isinstance(value.pattern, str):
                found.add(value.pattern)
        for node in ast.walk(ast.parse(inspect.getsource(module))):
            if isinstance(node, ast.Call) and ast.unparse(node.func).startswith("re."):
                try:
                    value = eval(ast.unparse(node.args[0]), vars(module))
                except (AttributeError, NameError):  # a local name, of what stands in a module
                    continue
                found.add(value if isinstance(value, str) else "")
    return sorted(found)


def seconds(pattern, text):
    """Return the least time of five tries of a match and a search.

    CPU time has coarse ticks on some machines; the least wall time is of an undisturbed try.
    """
    times = []
    for _ in range(5):
        begin = time.perf_counter()
        pattern.fullmatch(text)
        pattern.search(text)
        times.append(time.perf_counter() - begin)
    return min(times)


@pytest.fixture
def ended():
    """Fail if the test takes more than LONGEST CPU seconds: a search can be interrupted."""

    def stop(*_):
        raise AssertionError(f"took more than {LONGEST} CPU s")

    usual = signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, LONGEST)
    yield
    signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
    signal.signal(signal.SIGVTALRM, usual)


def test_the_patterns_are_found():
    assert len(patterns()) > 80
    assert any("VISCOELASTIC" in pattern for pattern in patterns())


@pytest.mark.parametrize("pattern", patterns())
def test_the_time_of_a_pattern_grows_as_the_square_of_the_length_at_most(pattern, ended):
    compiled = re.compile(pattern, re.IGNORECASE)
    for unit in UNITS:
        for end in ("", "!"):
            text = (unit * CHARACTERS)[:CHARACTERS] + end
            if seconds(compiled, text) > SHORT_SECONDS:  # more than linear
                long = (unit * CHARACTERS * 4)[: 4 * CHARACTERS] + end
                # Both are measured again in each try, as other work disturbs them.
                growths = (
                    seconds(compiled, long) / max(seconds(compiled, text), SHORT_SECONDS)
                    for _ in range(5)
                )
                powers = (math.log(max(growth, 1.0), 4.0) for growth in growths)
                assert any(power < MAX_POWER for power in powers), f"{unit!r} {end!r}"


@pytest.mark.parametrize("unit", UNITS)
def test_a_table_around_a_line_made_of_one_unit_ends(unit, ended):
    rows = "\n".join(f"{n} {n * n % 7}.5 {n % 3}" for n in range(30))
    long, many = (unit * 9000)[:9000], "\n".join(f"{unit * 5}{n}z" for n in range(500))
    for line in (f"# {long}!", long, f"a{long}z", f"5 {long} 3", many):
        for text in (f"{line}\n{rows}", f"{rows}\n{line}\n{rows}", line):
            with contextlib.suppress(UserError):
                table_of_text("key", "f.txt", text)
