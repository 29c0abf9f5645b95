"""Tests of workflow/system."""
