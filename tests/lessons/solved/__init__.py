"""Answers to every lesson's exercises, a module each: RIGHT, WRONG and STUBS.

ALSO, where a lesson has it, holds right answers that look different, with words of the praise.
"""
from importlib import import_module

from kinlab import lessons

LESSONS = {name: import_module(f"solved.{name}") for name in lessons.names()
           if lessons.judges(name)}
RIGHT = {name: answer for lesson in LESSONS.values() for name, answer in lesson.RIGHT.items()}
ALSO = [case for lesson in LESSONS.values() for case in getattr(lesson, "ALSO", [])]
WRONG = [case for lesson in LESSONS.values() for case in lesson.WRONG]
STUBS = [case for lesson in LESSONS.values() for case in lesson.STUBS]
JUDGES = [name for lesson in LESSONS for name in lessons.judges(lesson)]
