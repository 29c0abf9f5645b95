"""Effects on a half-space beside the loss in the rubber: shear of the contact, a finite depth."""
