"""Tests of workflow/reduce/statistics."""
