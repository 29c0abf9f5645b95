"""Tests of workflow/report."""
