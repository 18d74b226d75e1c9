"""Where emitted C runs: compilers, shared objects, sanitizers, and the probe for fused arithmetic.

Sees source text and arrays only, never a routine of the IR.
"""
