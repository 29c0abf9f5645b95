"""The page: formulas written as plain text are set."""

import pytest

from elastomer_friction.workflow.report.page import formula, verdict_class


@pytest.mark.parametrize(
    ("text", "html"),
    [
        ("q_max, F_N, D_c", "q<sub>max</sub>, F<sub>N</sub>, D<sub>c</sub>"),
        ("(v q)^(H−1), x^-0.10", "(v q)<sup>H−1</sup>, x<sup>−0.10</sup>"),
        ("1.7e-06, 1e+07", "1.7·10<sup>−6</sup>, 1·10<sup>7</sup>"),
        ("x < 1 & 2 %", "x\u00a0&lt;\u00a01 &amp; 2\u00a0%"),
        ("paper_step, a-1, -1", "paper_step, a-1, −1"),
    ],
)
def test_formulas(text, html):
    assert formula(text) == html


@pytest.mark.parametrize(
    ("verdict", "colour"),
    [
        ("holds", "holds"),
        ("holds within 5 %", "holds"),
        ("holds within 0.05", "holds"),
        ("holds within a factor 1.3", "holds"),
        ("holds within 20 % (rms), 43 % at worst", "only"),
        ("holds if dx = 5.9 µm", "only"),
        ("holds for 60 % of the points", "only"),
        ("only with one implicit Euler step per dx", "only"),
        ("not found", "not"),
        ("cannot be told: the error is too large", "cannot"),
    ],
)
def test_a_verdict_on_a_condition_is_amber(verdict, colour):
    assert verdict_class(verdict) == colour
