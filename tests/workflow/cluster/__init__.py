"""Tests of workflow/cluster."""
