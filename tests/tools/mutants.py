"""Mutants of a module: copies of its code with one small change each, like a typing error.

Comparisons, arithmetic and logic are swapped, conditions negated, numbers raised by one, keyword
arguments dropped, statements left out. Strings, annotations and imports are not changed.
"""

import ast
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

SWAPS: dict[type, type] = {
    ast.Lt: ast.LtE,
    ast.LtE: ast.Lt,
    ast.Gt: ast.GtE,
    ast.GtE: ast.Gt,
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot,
    ast.IsNot: ast.Is,
    ast.In: ast.NotIn,
    ast.NotIn: ast.In,
    ast.And: ast.Or,
    ast.Or: ast.And,
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
    ast.FloorDiv: ast.Mult,
    ast.Mod: ast.Mult,
    ast.Pow: ast.Mult,
    ast.BitAnd: ast.BitOr,
    ast.BitOr: ast.BitAnd,
}
NAMES = {"min": "max", "max": "min", "any": "all", "all": "any"}
NAMES |= {"minimum": "maximum", "maximum": "minimum", "argmin": "argmax", "argmax": "argmin"}
LEFT_ALONE = (ast.JoinedStr, ast.Import, ast.ImportFrom)  # not changed
NO_CODE = ("annotation", "returns", "decorator_list")

Change = Callable[[], object]
Site = tuple[ast.stmt, str, Change]  # statement, description of the change, function that makes it


class Mutant(NamedTuple):
    """One change of one file."""

    path: Path
    number: int  # number of the change in the file
    line: int  # first line of the changed statement
    last: int  # last line of it
    what: str  # description of the change

    def source(self) -> str:
        """Return the changed source."""
        tree = ast.parse(self.path.read_text(encoding="utf-8"))
        for number, (_, _, change) in enumerate(_sites(tree)):
            if number == self.number:
                change()
                break
        return ast.unparse(ast.fix_missing_locations(tree))

    def __str__(self) -> str:
        """Return where it is and what it changes."""
        return f"{self.path}:{self.line}: {self.what}"


def mutants_of(path: Path) -> list[Mutant]:
    """Return all mutants of a file of Python code."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    actual = []
    for number, (statement, what, _) in enumerate(_sites(tree)):
        body = getattr(statement, "body", None)  # a compound statement counts by its head only
        last = body[0].lineno - 1 if body else statement.end_lineno
        actual.append(Mutant(path, number, statement.lineno, max(last, statement.lineno), what))
    return actual


def _sites(tree: ast.Module) -> Iterator[Site]:
    for statement in tree.body:
        yield from _in_statement(statement, tree.body)


def _in_statement(node: ast.stmt, block: list[ast.stmt]) -> Iterator[Site]:
    if isinstance(node, LEFT_ALONE) or (isinstance(node, ast.If) and _is_typing(node.test)):
        return
    if _can_be_left_out(node):
        at = block.index(node)
        change = partial(block.__setitem__, at, ast.Pass())
        yield node, f"left out: {ast.unparse(node).splitlines()[0]}", change
    if isinstance(node, ast.If | ast.While) and not isinstance(node.test, ast.UnaryOp):
        yield node, f"{ast.unparse(node.test)}: turned", partial(_turn, node)
    for child, among in _children(node):
        if isinstance(child, ast.stmt):
            yield from _in_statement(child, among)
        else:
            for what, change in _in_expression(child):
                yield node, what, change


def _in_expression(node: ast.AST) -> Iterator[tuple[str, Change]]:
    if isinstance(node, LEFT_ALONE):
        return
    for kind, changes in CHANGES.items():
        if isinstance(node, kind):
            yield from changes(node)
    for child, _ in _children(node):
        yield from _in_expression(child)


def _children(node: ast.AST) -> Iterator[tuple[ast.AST, list]]:
    """Yield the child nodes of a node, each with the list that contains it."""
    for name, field in ast.iter_fields(node):
        among = field if isinstance(field, list) else [field]
        for child in among if name not in NO_CODE else ():
            if isinstance(child, ast.ExceptHandler):
                yield from ((inner, child.body) for inner in child.body)
            elif isinstance(child, ast.AST):
                yield child, among


def _of_compare(node: ast.Compare) -> Iterator[tuple[str, Change]]:
    for at, operator in enumerate(node.ops):
        other = SWAPS[type(operator)]()
        yield _swap_text(node, operator), partial(node.ops.__setitem__, at, other)


def _of_operation(node: ast.BoolOp | ast.BinOp | ast.AugAssign) -> Iterator[tuple[str, Change]]:
    if type(node.op) in SWAPS:
        yield _swap_text(node, node.op), partial(setattr, node, "op", SWAPS[type(node.op)]())


def _of_sign(node: ast.UnaryOp) -> Iterator[tuple[str, Change]]:
    if isinstance(node.op, ast.Not | ast.USub):
        negated = ast.UnaryOp(node.op, node.operand)
        yield f"{ast.unparse(node)}: turned", partial(setattr, node, "operand", negated)


def _of_constant(node: ast.Constant) -> Iterator[tuple[str, Change]]:
    if isinstance(node.value, bool):
        yield f"{node.value} turned", partial(setattr, node, "value", not node.value)
    elif isinstance(node.value, int | float):
        yield f"{node.value} raised by one", partial(setattr, node, "value", node.value + 1)


def _of_call(node: ast.Call) -> Iterator[tuple[str, Change]]:
    for keyword in node.keywords:
        if keyword.arg != "strict":  # of zip: lengths never differ
            without = partial(node.keywords.remove, keyword)
            yield f"{ast.unparse(node)}: without {keyword.arg}", without


def _of_name(node: ast.Name | ast.Attribute) -> Iterator[tuple[str, Change]]:
    field = "id" if isinstance(node, ast.Name) else "attr"
    name = getattr(node, field)
    if name in NAMES:
        yield f"{ast.unparse(node)} swapped", partial(setattr, node, field, NAMES[name])


def _of_choice(node: ast.IfExp) -> Iterator[tuple[str, Change]]:
    yield f"{ast.unparse(node)}: turned", partial(_turn, node)


def _of_loop(node: ast.comprehension) -> Iterator[tuple[str, Change]]:
    for at, condition in enumerate(node.ifs):
        turned = ast.UnaryOp(ast.Not(), condition)
        message = f"if {ast.unparse(condition)}: turned"
        yield message, partial(node.ifs.__setitem__, at, turned)


CHANGES: dict[Any, Callable[[Any], Iterator[tuple[str, Change]]]] = {
    ast.Compare: _of_compare,
    ast.BoolOp | ast.BinOp | ast.AugAssign: _of_operation,
    ast.UnaryOp: _of_sign,
    ast.Constant: _of_constant,
    ast.Call: _of_call,
    ast.Name | ast.Attribute: _of_name,
    ast.IfExp: _of_choice,
    ast.comprehension: _of_loop,
}


def _turn(node: ast.If | ast.While | ast.IfExp) -> None:
    node.test = ast.UnaryOp(ast.Not(), node.test)


def _swap_text(node: ast.AST, operator: ast.AST) -> str:
    return f"{ast.unparse(node)}: {type(operator).__name__} swapped"


def _is_typing(test: ast.expr) -> bool:
    return isinstance(test, ast.Name) and test.id == "TYPE_CHECKING"


def _can_be_left_out(node: ast.stmt) -> bool:
    """Return whether the rest of the code has all of its names without this statement."""
    if isinstance(node, ast.Assign):
        return all(isinstance(target, ast.Attribute | ast.Subscript) for target in node.targets)
    called = isinstance(node, ast.Expr) and isinstance(node.value, ast.Call)
    return called or isinstance(node, ast.AugAssign | ast.Raise | ast.Continue | ast.Break)
