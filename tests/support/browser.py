"""Pages in a real browser: what a script in a page leaves there."""

import re
import shutil
import subprocess

import pytest

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("chrome")
QUIET = (
    *("--headless", "--no-sandbox", "--no-first-run", "--disable-gpu", "--disable-quic"),
    *("--disable-background-networking", "--disable-component-update", "--disable-sync"),
    "--allow-file-access-from-files",  # the page that measures reads the frames it holds
    "--virtual-time-budget=5000",
)

in_a_browser = pytest.mark.skipif(BROWSER is None, reason="no chromium on the path")


def told_by(page, profile, *names, width=1280):
    """Return the data-NAMEs that the scripts of a page, a file, leave on its body."""
    how = f"--window-size={width},900", f"--user-data-dir={profile}"
    command = [BROWSER, *QUIET, *how, "--dump-dom", page.as_uri()]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, check=True)
    actual = [re.search(f'data-{name}="([^"]*)"', done.stdout) for name in names]
    assert all(actual), done.stderr
    return [each[1] for each in actual]
