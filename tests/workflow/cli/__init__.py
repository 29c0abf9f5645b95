"""Tests of workflow/cli."""
