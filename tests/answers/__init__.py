"""Answers to every lesson's exercises, a module each: RIGHT, WRONG and STUBS."""
from importlib import import_module

from kinlab import lessons

LESSONS = {name: import_module(f"answers.{name}") for name in lessons.names()
           if lessons.judges(name)}
RIGHT = {name: answer for lesson in LESSONS.values() for name, answer in lesson.RIGHT.items()}
WRONG = [case for lesson in LESSONS.values() for case in lesson.WRONG]
STUBS = [case for lesson in LESSONS.values() for case in lesson.STUBS]
JUDGES = [name for lesson in LESSONS for name in lessons.judges(lesson)]
