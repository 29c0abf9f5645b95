"""Tests of the pipeline, one module per module of `workflow`."""
