"""Heat of friction on a half-space: its constants, and the temperature of the rubber's surface."""
