"""Friction of steady sliding and of jumps, from the samples in contact or from between them."""
