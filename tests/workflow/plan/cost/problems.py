"""Problems that laws of cost must hold for, drawn at random."""

from hypothesis import strategies as st

from elastomer_friction.workflow.simulate.tasks import Problem

# H, N, Fbar, vbar, r = v2/v1
PROBLEMS = st.builds(
    lambda *numbers: Problem(*numbers),
    st.floats(0.0, 1.0),
    st.integers(100, 100_000),
    st.floats(1e-4, 100.0),
    st.floats(1e-3, 1e4),
    st.floats(0.1, 10.0),
)
