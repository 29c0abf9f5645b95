"""Tests of workflow/plan."""
