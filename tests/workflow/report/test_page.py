"""The page: formulas written as plain text are set."""

import pytest

from workflow.report.page import formula


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
