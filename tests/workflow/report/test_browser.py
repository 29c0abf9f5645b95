"""The report in a real browser: nothing sticks out sideways, on a laptop and on a phone."""

import re
import shutil
import subprocess

import pytest

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("chrome")
QUIET = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--allow-file-access-from-files",  # the page that measures reads the frame it holds
    "--virtual-time-budget=5000",
)
MEASURE = """<!DOCTYPE html><html><body>
<iframe id="frame" style="width:{width}px;height:2000px;border:0" src="report.html"></iframe>
<script>
document.getElementById("frame").onload = (event) => {{
  const inside = event.target.contentDocument;
  const images = [...inside.images];
  const small = [...inside.querySelectorAll("p, li, td")]
    .map((node) => parseFloat(getComputedStyle(node).fontSize));
  document.body.dataset.found = [inside.documentElement.scrollWidth, images.length,
    images.filter((image) => image.naturalWidth > 0).length, Math.min(...small)].join(" ");
}};
</script></body></html>"""


@pytest.mark.skipif(BROWSER is None, reason="no chromium on the path")
@pytest.mark.parametrize(("width", "least_font"), [(1280, 15), (390, 16)])
def test_page_in_a_browser(folder, tmp_path, width, least_font):
    outer = folder / f"measure{width}.html"
    outer.write_text(MEASURE.format(width=width), encoding="utf-8")
    command = [BROWSER, *QUIET, f"--user-data-dir={tmp_path}", "--dump-dom", outer.as_uri()]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=True)
    found = re.search(r'data-found="(\d+) (\d+) (\d+) ([\d.]+)"', done.stdout)
    assert found, done.stderr
    scroll_width, images, shown, font = (float(value) for value in found.groups())
    assert scroll_width <= width
    assert images == shown == 2
    assert font >= least_font
