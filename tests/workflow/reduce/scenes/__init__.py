"""Tests of workflow/reduce/scenes."""
