"""The index: names in the order of the alphabet, links to headings that are there."""

import re

from elastomer_friction.workflow.reference.keys import keys_page
from elastomer_friction.workflow.reference.pages import anchor, index_page
from elastomer_friction.workflow.reference.results import results_page

ROWS = re.findall(r"^\| \[`(\w+)`\]\((\w+\.md)#([\w-]+)\)", index_page(), re.MULTILINE)


def test_names_are_in_order():
    names = [name for name, _, _ in ROWS]
    assert len(names) > 100
    assert names == sorted(names)


def test_every_link_leads_to_a_heading():
    pages = {"keys.md": keys_page(), "results.md": results_page()}
    known = {
        (name, anchor(heading))
        for name, page in pages.items()
        for heading in re.findall(r"^#+ (.*)$", page, re.MULTILINE)
    }
    assert {(page, place) for _, page, place in ROWS} <= known
