"""Experiments over designs: recordings in, attitudes and comparisons out."""
