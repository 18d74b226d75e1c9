"""The two languages: real (what the paper wrote) and machine (every value typed), and what both are made of.

`statement` holds the parts both share, `real` and `machine` the operations of each, `check` what is
legal, `text` how a routine reads, `evaluate` what a real routine means. The way an author writes an
algorithm is in `blocks`, `update`, `specification` and `trace`; `real` is the door to them.
"""
