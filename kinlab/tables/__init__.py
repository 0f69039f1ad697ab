"""A DH table as typed: its cells, and tables read from and written as text of many kinds."""
