"""A DH table as typed: its cells, and the same table as CSV, text and code."""
