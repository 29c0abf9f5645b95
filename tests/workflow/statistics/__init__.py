"""Tests of workflow/statistics."""
