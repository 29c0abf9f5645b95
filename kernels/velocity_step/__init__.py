"""Velocity steps: steady friction before and after a step, its jump and its relaxation."""
