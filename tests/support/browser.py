"""Pages in a real browser, and the data attributes that their scripts set."""

import re
import shutil
import subprocess

import pytest

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("chrome")
QUIET = (
    *("--headless", "--no-sandbox", "--no-first-run", "--disable-gpu", "--disable-quic"),
    *("--disable-background-networking", "--disable-component-update", "--disable-sync"),
    "--allow-file-access-from-files",  # so that a page can read its frames
    "--virtual-time-budget=5000",
)

in_a_browser = pytest.mark.skipif(BROWSER is None, reason="no chromium on the path")


def told_by(page, profile, *names, width=1280):
    """Return the attributes data-NAME that the scripts of a page set on its body. page : Path."""
    options = f"--window-size={width},900", f"--user-data-dir={profile}"
    command = [BROWSER, *QUIET, *options, "--dump-dom", page.as_uri()]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, check=True)
    matches = [re.search(f'data-{name}="([^"]*)"', done.stdout) for name in names]
    assert all(matches), done.stderr
    return [match[1] for match in matches]
