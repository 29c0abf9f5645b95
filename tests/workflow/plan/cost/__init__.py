"""Tests of workflow/plan/cost."""
