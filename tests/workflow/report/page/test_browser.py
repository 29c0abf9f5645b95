"""The report in a real browser, as wide as a laptop and as a phone.

Nothing exceeds the width, and a pointer on a point shows its hover text.
"""

from tests.support.browser import in_a_browser, told_by

SCREENS = {1280: 15, 390: 16}  # width -> the smallest font that can be read there
MEASURE = """
<script>
window.onload = () => {
  document.body.dataset.found = [...document.querySelectorAll("iframe")].map((frame) => {
    const inside = frame.contentDocument, images = [...inside.images];
    const small = [...inside.querySelectorAll("p, li, td")]
      .map((node) => parseFloat(getComputedStyle(node).fontSize));
    return [inside.documentElement.scrollWidth, images.length,
      images.filter((image) => image.naturalWidth > 0).length, Math.min(...small)].join(" ");
  }).join(";");
  document.body.dataset.told = [...document.querySelectorAll("iframe")].map((frame) => {
    const inside = frame.contentDocument, point = inside.querySelector(".plate circle");
    const place = point.getBoundingClientRect(), tip = inside.querySelector(".tip");
    const x = place.left + place.width / 2, y = place.top + place.height / 2;
    const told = [0, 5, 300].map((aside) => {
      const at = {clientX: x + aside, clientY: y - aside, bubbles: true};
      point.dispatchEvent(new frame.contentWindow.PointerEvent("pointermove", at));
      const box = tip.getBoundingClientRect(), width = inside.documentElement.clientWidth;
      if (tip.hidden) return "nothing";
      return `${tip.textContent}, ${box.left >= 0 && box.right <= width ? "in view" : "cut off"}`;
    });
    const plate = inside.querySelector(".plate[tabindex]");
    plate.focus();
    const key = {key: "ArrowRight", bubbles: true};
    plate.dispatchEvent(new frame.contentWindow.KeyboardEvent("keydown", key));
    told.push(tip.hidden ? "nothing" : tip.textContent);
    return told.join("|");
  }).join(";");
};
</script></body></html>"""


@in_a_browser
def test_page_in_a_browser(folder, tmp_path):
    style = "height:2000px;border:0;width:"
    frames = [f'<iframe style="{style}{width}px" src="report.html"></iframe>' for width in SCREENS]
    outer = folder / "measure.html"
    outer.write_text("<!DOCTYPE html><html><body>" + "".join(frames) + MEASURE, encoding="utf-8")
    measured, told = told_by(outer, tmp_path, "found", "told")
    for (width, least_font), actual in zip(SCREENS.items(), measured.split(";"), strict=True):
        scroll_width, images, shown, font = (float(value) for value in actual.split())
        assert scroll_width <= width
        assert images == shown == 2
        assert font >= least_font
    for each in told.split(";"):
        on, near, far, by_key = each.split("|")
        assert on.startswith("rms_slope = 0.02 ± 0.0002\nv₁ = 100 µm/s, H = ")
        assert on.endswith(", in view")
        assert near == on
        assert far == "nothing"
        assert on == f"{by_key}, in view"
