"""Tests of workflow/simulate."""
