"""Tests of workflow/report/page."""
