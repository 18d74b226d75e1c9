"""The papers' claims, each measured anew: exact derivations, counts, and runs of the generated C."""
