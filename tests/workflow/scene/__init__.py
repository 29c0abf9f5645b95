"""Tests of workflow/scene."""
