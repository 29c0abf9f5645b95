"""Effects on a half-space besides the loss in the rubber: shear of the contact, a finite depth."""
