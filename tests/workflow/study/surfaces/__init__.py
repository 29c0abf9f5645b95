"""Tests of workflow/study/surfaces, one module per module."""
