"""Effects at the interface of a half-space, beside the loss in the rubber: shear of the contact."""
