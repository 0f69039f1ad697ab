"""Tables as people published them: each loads as its source means it."""
import re
from dataclasses import replace
from math import radians

import numpy as np
import published_a
import published_b
import pytest

import kinlab as kl
from kinlab.arms.link import PARAMETERS
from kinlab.tables.question import Ambiguous
from kinlab.tables.read import read_table
from kinlab.tables.table import Place

TABLES = (*published_a.TABLES, *published_b.TABLES)
KINDS = {"R": "revolute", "P": "prismatic", "F": "fixed"}
EDITOR = kl.DHTableEditor().table
every_table = pytest.mark.parametrize("published", TABLES, ids=lambda table: table.name)
every_open_one = pytest.mark.parametrize("published", [table for table in TABLES if table.asks],
                                         ids=lambda table: table.name)
# What editors, pages and mails make of a text on its way, and what stands around it.
REWRITTEN = {
    "ends of lines of Windows": lambda text: text.replace("\n", "\r\n"),
    "an indent": lambda text: re.sub(r"(?m)^(?=.)", "    ", text),
    "blanks at the ends": lambda text: re.sub(r"(?m)$", "   ", text),
    "no-break spaces": lambda text: text.replace(" ", "\N{NO-BREAK SPACE}"),
    "a hyphen for each minus": lambda text: text.replace("\N{MINUS SIGN}", "-"),
    "the signs of a quotation": lambda text: re.sub(r"(?m)^(?=.)", "> ", text.strip("\n")),
    "the fence of a listing": lambda text: f"```\n{text}\n```\n",
    "words above": lambda text: f"Table 3: parameters of the arm, as in Figure 2\n\n{text}",
    "words below": lambda text: f"{text}\nThe product of all of them is then the tool's pose.\n"}
every_rewriting = pytest.mark.parametrize("rewritten", REWRITTEN.values(), ids=REWRITTEN.keys())
every_pose = pytest.mark.parametrize("published, q, point", [
    pytest.param(table, q, point, id=f"{table.name}, {q}")
    for table in TABLES for q, point in table.poses])


def pasted(published, **choices):
    """The table that a default editor makes of it; its named lengths are those of the arm."""
    lengths = tuple((name, repr(value)) for name, value in published.lengths.items())
    return read_table(published.text, replace(EDITOR, lengths=lengths), **choices).table


def kinds_of(published):
    return [KINDS[letter] for letter in published.kinds or "R" * len(published.rows)]


def expected(published):
    """What each cell says, in radians and the table's unit; those of marked cells aside."""
    turn = radians(1) if published.angles == "deg" else 1
    return {Place(i, column): value * (turn if column in ("theta", "alpha") else 1)
            for i, row in enumerate(published.rows, start=1)
            for column, value in zip(PARAMETERS, row) if (i, column) not in published.marked}


def test_each_table_has_a_source_of_its_own():
    assert len({table.source for table in TABLES}) == len(TABLES) > 100


@every_table
def test_it_has_the_rows_and_joints_of_its_source(published):
    table = pasted(published, **published.choices)
    assert [row.kind for row in table.rows] == kinds_of(published)
    assert tuple(i for i, row in enumerate(table.rows, start=1) if row.flip) == published.flips


@every_table
def test_it_has_the_numbers_of_its_source(published):
    table = pasted(published, **published.choices)
    assert {tuple(place): reason for place, reason in table.errors.items()
            if place not in published.marked} == {}
    assert set(published.marked) == set(table.errors)
    numbers = expected(published)
    assert {place: table.values[place] for place in numbers} == pytest.approx(numbers, abs=1e-12)


@every_table
def test_it_has_the_convention_and_unit_of_its_source(published):
    table = pasted(published, **published.choices)
    assert (table.convention, table.unit) == (published.convention, published.unit)


@every_open_one
def test_what_its_text_leaves_open_is_asked(published):
    with pytest.raises(Ambiguous) as question:
        pasted(published)
    assert published.choices in [choices for _, choices in question.value.options]


@every_pose
def test_it_reaches_what_its_source_says(published, q, point):
    arm = pasted(published, **published.choices).arm
    moving = [kind for kind in kinds_of(published) if kind != "fixed"]
    joints = [radians(value) if kind == "revolute" else value for kind, value in zip(moving, q)]
    np.testing.assert_allclose(kl.forward_kinematics(arm, joints)[:3, 3], point, rtol=0,
                               atol=published.within)


@every_rewriting
@every_table
def test_what_happens_on_its_way_changes_nothing(published, rewritten):
    again = replace(published, text=rewritten(published.text))
    assert pasted(again, **published.choices) == pasted(published, **published.choices)
