"""Patches of contact: how many samples they are wide, and what to do where that is too few."""
