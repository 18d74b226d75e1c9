"""Number formats: how an exact constant becomes a number of a machine, and how C writes it."""
