"""Passes: one idea a file, routine to routine or routine to facts.

*Exact* passes cannot change a bit of what the machine computes: fold, share, sweep, signs. The default
pipeline holds no other kind. A cheaper algebra is another written form of the algorithm, never a pass.
"""
