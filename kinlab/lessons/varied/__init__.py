"""Exercises of the lessons with other numbers, a module for each lesson that has some.

A module has a dictionary VARIED, from names such as "translation.1" to `Varied`.
"""
