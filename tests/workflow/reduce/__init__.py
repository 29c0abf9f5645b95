"""Tests of workflow/reduce."""
