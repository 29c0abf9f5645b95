"""Count wording that a reader has to decode; `make check` fails above the limits.

Run from the root of the repository; `-v` lists the places. The rules are a net, not a style guide:
a few innocent matches remain, which is why the limits are not zero.
"""

import ast
import io
import re
import sys
import tokenize
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
ROOMS = ("kernels", "workflow", "studies", "src", "tests")
DEFINITIONS = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)

# A docstring opens with a verb or a noun, never with a clause that lacks its main verb.
CLAUSE_OPENING = re.compile(
    r"(What|Who|Whom|Whose|Where|Which|That|Those|Whether|When|How|As|Of|If)\b"
)
AWKWARD_PHRASE = re.compile(
    r"\b(as of|of which|of whom|so many|so much|beside (?:it|them|this|that)|none is|there is none"
    r"|are none|(?:is|are) told|goes? on|[Ff]ore(?:see|tell|told)\w*|is asked|at the least"
    r"|is no (?!longer|more)\w+|what it has not|for want of|not to be \w+ed|is as good as"
    r"|what is (?:only|left|there|asked|told|known)|who (?:finds|has|gives|takes|calls)|thereby"
    r"|whereby|hardly ever|ever again)\b"
)
EMPTY_NAME = re.compile(
    r"_*(found|asked|own|told|said|meant|taken|gone|much|way|kept|noted|seen|sure|what|each|thing"
    r"|res|tmp|obj)_*"
)
CONTRACT_NAMES = {"told"}  # a method of exported laws


class Rule(NamedTuple):
    """A kind of wording and the largest numbers of accepted matches."""

    name: str
    limit: int  # in the program
    limit_of_tests: int


OPENING = Rule("docstrings that open with a clause", 20, 60)
PHRASE = Rule("awkward phrases", 60, 130)
EMPTY = Rule("names without content", 150, 420)
AMBIGUOUS = Rule("constants with several meanings", 40, 0)
RULES = (OPENING, PHRASE, EMPTY, AMBIGUOUS)

Match = tuple[Rule, int, str]  # rule, line, text


def matches_of_tree(tree: ast.AST) -> Iterator[Match]:
    """Yield the matches in the docstrings, strings and names of a syntax tree."""
    for node in ast.walk(tree):
        if isinstance(node, DEFINITIONS) and (doc := ast.get_docstring(node)):
            first = doc.splitlines()[0]
            if CLAUSE_OPENING.match(first):
                yield OPENING, getattr(node, "lineno", 1), first
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            for match in AWKWARD_PHRASE.finditer(node.value):
                yield PHRASE, node.lineno, match[0]
        name = defined_name(node)
        if name and EMPTY_NAME.fullmatch(name.lower()):
            yield EMPTY, getattr(node, "lineno", 1), name


def defined_name(node: ast.AST) -> str | None:
    """Return the name that a node assigns, takes as an argument or defines as a function."""
    if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
        return node.id
    if isinstance(node, ast.arg):
        return node.arg
    if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
        return None if node.name in CONTRACT_NAMES else node.name
    return None


def matches_of_comments(text: str) -> Iterator[Match]:
    """Yield the awkward phrases in the comments of a source text."""
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            for match in AWKWARD_PHRASE.finditer(token.string):
                yield PHRASE, token.start[0], match[0]


def constants_of(tree: ast.Module) -> Iterator[tuple[str, str]]:
    """Yield (name, source of the value) of the constants that a module assigns."""
    for node in tree.body:
        if isinstance(node, ast.Assign):
            target, value = node.targets[0], node.value
        elif isinstance(node, ast.AnnAssign) and node.value:
            target, value = node.target, node.value
        else:
            continue
        several = isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple)
        pairs = zip(target.elts, value.elts, strict=True) if several else ((target, value),)
        for name, expression in pairs:
            if isinstance(name, ast.Name) and name.id.lstrip("_").isupper():
                yield name.id.lstrip("_"), ast.unparse(expression)


def language_matches() -> dict[Rule, list[str]]:
    """Return the places of all matches in the program and its tests, by rule."""
    places: dict[Rule, list[str]] = {rule: [] for rule in RULES}
    values: dict[str, dict[str, str]] = defaultdict(dict)
    paths = {path.resolve() for room in ROOMS for path in (ROOT / room).rglob("*.py")}
    for path in sorted(paths):
        name, text = path.relative_to(ROOT).as_posix(), path.read_text(encoding="utf-8")
        tree = ast.parse(text)
        for rule, line, actual in (*matches_of_tree(tree), *matches_of_comments(text)):
            places[rule].append(f"{name}:{line}: {actual}")
        if name.startswith(("kernels", "workflow")):
            for constant, value in constants_of(tree):
                values[constant][name] = value
    for constant, by_module in values.items():
        if len(set(by_module.values())) > 1:
            places[AMBIGUOUS].append(f"{constant}: {', '.join(by_module)}")
    return places


def main() -> None:
    """Print the number of matches of each rule; exit with status 1 above a limit."""
    exceeded = False
    for rule, rows in language_matches().items():
        in_tests = sum(row.startswith("tests/") for row in rows)
        in_program = len(rows) - in_tests
        if "-v" in sys.argv:
            print(*rows, sep="\n")
        print(f"{rule.name}: {in_program} of {rule.limit}", end=", ")
        print(f"in tests {in_tests} of {rule.limit_of_tests}")
        exceeded |= in_program > rule.limit or in_tests > rule.limit_of_tests
    sys.exit(exceeded)


if __name__ == "__main__":
    main()
