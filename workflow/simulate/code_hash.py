"""The hash of the code that stored numbers depend on: part of the key of every record.

By construction it covers whatever ``block_means`` can reach: the kernels and this room import
nothing else of ours that a number depends on (a test walks their imports). Comments, docstrings
and layout do not enter it, so that mending a sentence leaves every stored record valid. Versions
of packages and the processor do not enter it either: they are noted with each run.
"""

import ast
import contextlib
import hashlib
import os
import string
from pathlib import Path

from ... import kernels
from ...kernels.compile import cache

DIGITS = 16
FOLDERS = (Path(kernels.__file__).parent, Path(__file__).parent)


def code_hash(folders: tuple[Path, ...] = FOLDERS) -> str:
    """Return a short hash (hexadecimal) over what the Python files below some folders do."""
    digest = hashlib.sha256()
    for folder in folders:
        for source in sorted(folder.rglob("*.py")):
            digest.update(str(source.relative_to(folder.parent)).encode())
            tree = ast.parse(source.read_text(encoding="utf-8"))
            digest.update(repr(_meaning(tree)).encode())
    return digest.hexdigest()[:DIGITS]


def cached_code_hash(folders: tuple[Path, ...] = FOLDERS) -> str:
    """Return ``code_hash``, kept beside the machine code until a byte of any file changes.

    To parse the files takes as long as to load all kernels.
    """
    digest = hashlib.sha256()
    for folder in folders:
        for source in sorted(folder.rglob("*.py")):
            digest.update(str(source.relative_to(folder.parent)).encode() + source.read_bytes())
    file = Path(cache.CACHE_FOLDER, f"code-{digest.hexdigest()[:32]}")
    with contextlib.suppress(OSError, UnicodeDecodeError):
        found = file.read_text(encoding="ascii")
        if len(found) == DIGITS and set(found) <= set(string.hexdigits):
            return found
    found = code_hash(folders)
    aside = file.with_suffix(f".{os.getpid()}")
    with contextlib.suppress(OSError):
        aside.write_text(found, encoding="ascii")
        aside.replace(file)
    return found


def _meaning(node: object) -> object:
    """Return a syntax tree as nested tuples, without docstrings, places and empty fields.

    Unlike ``ast.dump`` it is the same in every version of Python.
    """
    if isinstance(node, list):
        return [_meaning(item) for item in node]
    if not isinstance(node, ast.AST):
        return repr(node)
    fields = dict(ast.iter_fields(node))
    documented = ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef
    if isinstance(node, documented) and ast.get_docstring(node, clean=False) is not None:
        fields["body"] = fields["body"][1:]
    held = {name: value for name, value in fields.items() if value is not None and value != []}
    return type(node).__name__, [(name, _meaning(value)) for name, value in held.items()]


CODE_HASH = cached_code_hash()
