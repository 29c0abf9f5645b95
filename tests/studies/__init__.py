"""Tests of the studies: that each can be planned, and the physics of figure 7."""
