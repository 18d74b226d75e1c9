"""The papers' figures as data: curves measured anew, with the papers' claims marked on them."""
