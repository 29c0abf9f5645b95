"""Hash of the code that stored numbers depend on: part of the key of every record.

It covers all code that ``block_means`` can reach: the kernels and this room import nothing else of
this program that a number depends on (a test follows their imports). Comments, docstrings and
layout do not affect it, so that every stored record stays valid when a sentence is edited. Nor do
versions of packages and the processor, which each run records.
"""

import ast
import contextlib
import hashlib
import os
import string
from pathlib import Path

from ... import kernels
from ...kernels.compile import cache

HASH_DIGITS = 16
FOLDERS = (Path(kernels.__file__).parent, Path(__file__).parent)


def code_hash(folders: tuple[Path, ...] = FOLDERS) -> str:
    """Return a short hexadecimal hash of the syntax of all Python files in some folders."""
    digest = hashlib.sha256()
    for folder in folders:
        for source in sorted(folder.rglob("*.py")):
            digest.update(str(source.relative_to(folder.parent)).encode())
            tree = ast.parse(source.read_text(encoding="utf-8"))
            digest.update(repr(_without_layout(tree)).encode())
    return digest.hexdigest()[:HASH_DIGITS]


def cached_code_hash(folders: tuple[Path, ...] = FOLDERS) -> str:
    """Return ``code_hash``, cached beside the machine code until a byte of any file changes.

    Parsing the files takes as long as loading all kernels.
    """
    digest = hashlib.sha256()
    for folder in folders:
        for source in sorted(folder.rglob("*.py")):
            digest.update(str(source.relative_to(folder.parent)).encode() + source.read_bytes())
    file = Path(cache.CACHE_FOLDER, f"code-{digest.hexdigest()[:32]}")
    with contextlib.suppress(OSError, UnicodeDecodeError):
        cached = file.read_text(encoding="ascii")
        if len(cached) == HASH_DIGITS and set(cached) <= set(string.hexdigits):
            return cached
    computed = code_hash(folders)
    aside = file.with_suffix(f".{os.getpid()}")
    with contextlib.suppress(OSError):
        aside.write_text(computed, encoding="ascii")
        aside.replace(file)
    return computed


def _without_layout(node: object) -> object:
    """Return a syntax tree as nested tuples, without docstrings, positions and empty fields.

    Unlike ``ast.dump`` it is equal in all versions of Python.
    """
    if isinstance(node, list):
        return [_without_layout(item) for item in node]
    if not isinstance(node, ast.AST):
        return repr(node)
    fields = dict(ast.iter_fields(node))
    documented = ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef
    if isinstance(node, documented) and ast.get_docstring(node, clean=False) is not None:
        fields["body"] = fields["body"][1:]
    filled = {name: value for name, value in fields.items() if value is not None and value != []}
    return type(node).__name__, [(name, _without_layout(value)) for name, value in filled.items()]


CODE_HASH = cached_code_hash()
