"""From a study to a result: see docs/architecture.md."""
