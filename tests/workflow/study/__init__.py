"""Tests of workflow/study."""
