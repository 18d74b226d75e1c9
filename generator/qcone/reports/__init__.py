"""Reports: rows laid out for people and for programs. No arithmetic."""
