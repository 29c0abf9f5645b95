"""The commands ``verify`` and ``merge``: stores of finished work, checked and joined."""

import argparse
from pathlib import Path

from ..errors import UserError
from ..result import result_file
from ..store import Verified, holds_a_store, merge_into, store_folder
from ..study import read_study
from .run import DONE, FAILED


def add_verify_options(command: argparse.ArgumentParser) -> None:
    """Add what ``verify`` is told."""
    text = "a folder of results, or a study whose results are in --out"
    command.add_argument("what", metavar="FOLDER|STUDY", help=text, nargs="?", default="results")
    command.add_argument("--out", default="results", help="folder of results of the study")


def add_merge_options(command: argparse.ArgumentParser) -> None:
    """Add what ``merge`` is told."""
    command.add_argument("source", help="folder of results whose finished work is taken over")
    command.add_argument("target", nargs="?", default="results", help="folder that takes it over")
    text = "go on where the file system of the target has no locks: no run may use it"
    command.add_argument("--no-lock", action="store_true", help=text)


def run_verify(options: argparse.Namespace) -> int:
    """Check a store; return the exit status: 3 where a fault is found."""
    found = Verified(_store_of(options))
    print("\n".join(found.lines()))
    return FAILED if found.faults else DONE


def run_merge(options: argparse.Namespace) -> int:
    """Join two stores; return the exit status."""
    target = Path(options.target)
    into = target if holds_a_store(target) else target / "store"
    print("\n".join(merge_into(_in_folder(options.source), into, no_lock=options.no_lock)))
    return DONE


def _store_of(options: argparse.Namespace) -> Path:
    if Path(options.what).is_dir():
        return _in_folder(options.what)
    study = read_study(options.what)
    return _in_folder(str(store_folder(result_file(Path(options.out), study))))


def _in_folder(name: str) -> Path:
    """Return the store that a folder of results has, or that it is. Raises UserError."""
    for folder in (Path(name) / "store", Path(name)):
        if holds_a_store(folder):
            return folder
    raise UserError(f"{name}: holds no store of finished work")
