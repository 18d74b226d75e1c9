"""Readings of a machine routine: C source, bit-true NumPy model, operation counts, the text parsed back.

Each reads the routine and none reads another: that they agree is what `verify` shows.
"""
