"""Time that patterns and readers take on rows and lines made to let them backtrack."""

import ast
import contextlib
import importlib
import inspect
import pkgutil
import re
import signal
import time

import pytest

import elastomer_friction.workflow as program
from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study import ColumnSpec
from elastomer_friction.workflow.text_tables import TextTable
from elastomer_friction.workflow.text_tables.headers import LINE_SEPARATORS

# Rows and lines are made of one of these, repeated.
UNITS = (
    *' \ta1-/_.#"%=:[](<\u00b2',
    "a ",
    "1 ",
    "1,",
    "1.",
    "54321 ",
    "0.5;",
    "1e5 ",
    "NaN ",
    "- ",
    " / ",
    '"a" ',
    "x: 1; ",
    "x=1,",
    "[m] ",
    "(a",
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
)
CHARACTERS = 1000
# Its search in "aaa..." takes the square of the length in steps.
QUADRATIC = re.compile("(a)*!")
MAX_RATIO = 12.0  # of the CPU time of a pattern to that of QUADRATIC; cubic ones take 16 and more
TRIES = 3
TABLE_SECONDS = 60.0  # CPU time after which a table counts as one that does not end


def patterns():
    """Return every pattern of the program: of its modules' names, and in its calls of re."""
    found = set()
    for info in pkgutil.walk_packages(program.__path__, program.__name__ + "."):
        if info.name.endswith("__main__"):
            continue
        module = importlib.import_module(info.name)
        pending = list(vars(module).values())
        for value in pending:
            if isinstance(value, ColumnSpec):
                found.add(value.names)
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
    return sorted(found.union(LINE_SEPARATORS))


@contextlib.contextmanager
def cpu_limit(limit):
    """Raise TimeoutError after ``limit`` CPU seconds; a search of re can be interrupted."""

    def stop(*_):
        raise TimeoutError(f"took more than {limit} CPU s")

    usual = signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, limit)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
        signal.signal(signal.SIGVTALRM, usual)


def seconds(pattern, text, limit=TABLE_SECONDS):
    """Return the CPU time of a match and a search, which end after ``limit`` CPU seconds."""
    begin = time.process_time()
    with contextlib.suppress(TimeoutError), cpu_limit(limit):
        pattern.fullmatch(text)
        pattern.search(text)
    return time.process_time() - begin


@pytest.fixture(scope="module")
def longest():
    """Return the CPU time that a quadratic pattern does not reach."""
    text = "a" * CHARACTERS
    return MAX_RATIO * max(seconds(QUADRATIC, text) for _ in range(TRIES))


def test_the_patterns_are_found():
    assert len(patterns()) > 80
    assert any("VISCOELASTIC" in pattern for pattern in patterns())


@pytest.mark.parametrize("pattern", patterns())
def test_the_time_of_a_pattern_grows_as_the_square_of_the_length_at_most(pattern, longest):
    compiled = re.compile(pattern, re.IGNORECASE)
    for unit in UNITS:
        for end in ("", "!"):
            text = (unit * CHARACTERS)[:CHARACTERS] + end
            # Other work on the machine may disturb a try.
            tries = (seconds(compiled, text, 2.0 * longest) for _ in range(TRIES))
            assert any(time < longest for time in tries), f"{unit!r} {end!r}"


def test_a_cubic_pattern_takes_longer(longest):
    assert seconds(re.compile(r"\w*\w+:"), "a" * CHARACTERS, 2.0 * longest) > longest


@pytest.mark.parametrize("unit", UNITS)
def test_a_table_around_a_line_made_of_one_unit_ends(unit):
    rows = "\n".join(f"{n} {n * n % 7}.5 {n % 3}" for n in range(30))
    long, many = (unit * 9000)[:9000], "\n".join(f"{unit * 5}{n}z" for n in range(500))
    for line in (f"# {long}!", long, f"a{long}z", f"5 {long} 3", many):
        for text in (f"{line}\n{rows}", f"{rows}\n{line}\n{rows}", line):
            with contextlib.suppress(UserError), cpu_limit(TABLE_SECONDS):
                TextTable("key", "f.txt", text)
