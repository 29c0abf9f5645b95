"""What the model says, computed quicker. Nothing here states a law."""
