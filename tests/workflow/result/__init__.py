"""Tests of workflow/result."""
