"""Faster versions of the model, equal to it in the results. No law is stated here."""
