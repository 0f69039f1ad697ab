"""Random edits of a DH table, sensible and not, as an editor in a notebook receives them."""
from hypothesis import strategies as st

from kinlab.tables.table import COLUMNS, PARAMETERS, DHTable, Row

GOOD = ["0", "-90", "90", "pi/2", "-pi", "45 deg", "0.5 rad", "177.8", "-d2", "d2 + 100", "2*l1",
        "sqrt(2)/2", "(30+15)", "1e-3", ".5", "−45", "60°", "", " 12 ", "0.1*2^3"]
BAD = ["abc", "1,5", "1/0", "9**9**9", "((", "90 grad", "1e300", "nan", "-", "pi pi", "x" * 200,
       "=1+1", "1\n2", "\x00", "\ud800", "'", '"', "<b>", "__import__('os')", "d2 deg"]
ODD = [None, 3, 1.5, [], {}, "x" * 201, True, ["0"]]
UNITS = ["mm", "cm", "m", "in"]

texts = st.one_of(st.sampled_from(GOOD), st.sampled_from(BAD), st.text(max_size=8))
names = st.sampled_from(["d2", "l1", "a2", "pi", "deg", "", "2x", "if", "l 1", "ä"])
rows = st.integers(1, 4)


def _edit(name, *arguments):
    return st.tuples(st.just(name), st.tuples(*arguments).map(list))


typed = st.one_of(
    _edit("with_cell", rows, st.sampled_from(PARAMETERS), texts),
    _edit("with_cell", rows, st.sampled_from(PARAMETERS), st.sampled_from(GOOD)),
    _edit("with_cell", rows, st.sampled_from(COLUMNS), texts))
built = st.one_of(
    _edit("with_kind", rows, st.sampled_from(["revolute", "prismatic"])),
    _edit("with_row"), _edit("with_row", rows), _edit("without_row", rows),
    _edit("with_row_moved", rows, rows), _edit("with_length", st.integers(1, 3), names, texts),
    _edit("without_length", st.integers(1, 3)),
    _edit("without_end", st.sampled_from(["base", "tool"])),
    _edit("with_end", st.sampled_from(["base", "tool"]), st.sampled_from(["pose", "row"])),
    _edit("with_cell", st.sampled_from(["base", "tool"]),
          st.sampled_from(["x", "z", "yaw", "roll", *PARAMETERS]), texts | st.sampled_from(GOOD)))
turned = st.one_of(
    _edit("read_as", st.sampled_from(["standard", "modified"])),
    _edit("converted_to", st.sampled_from(["standard", "modified"])),
    _edit("in_angles", st.sampled_from(["deg", "rad"])),
    _edit("in_unit", st.sampled_from(UNITS)))
junk = st.one_of(
    _edit("with_cell", st.sampled_from(ODD), st.sampled_from(ODD), st.sampled_from(ODD)),
    _edit("with_kind", st.sampled_from(ODD), st.sampled_from(ODD)),
    _edit("with_row", st.sampled_from(ODD)), _edit("without_row", st.sampled_from(ODD)),
    _edit("with_row_moved", rows, st.sampled_from(ODD)),
    _edit("with_length", st.sampled_from(ODD), names, st.sampled_from(ODD)),
    _edit("without_end", st.sampled_from(ODD)), _edit("with_end", st.sampled_from(ODD)),
    _edit("read_as", st.sampled_from(ODD)),
    _edit("converted_to", st.sampled_from(ODD)), _edit("in_unit", st.sampled_from(ODD)),
    _edit("in_angles", st.sampled_from(ODD)))
edits = typed | built | turned | junk

START = DHTable((Row(a="l1"), Row(d="d2", alpha="-90"), Row("prismatic", low="0", high="1")),
                lengths=(("d2", "0.5"), ("l1", "1")))


@st.composite
def tables(draw, steps=edits):
    """Tables that a student may reach from a small one."""
    table = START
    for name, arguments in draw(st.lists(steps, max_size=12)):
        table = after(table, name, arguments)
    return table


def after(table, name, arguments):
    """The table after an edit, or unchanged where the edit is refused in one line."""
    try:
        return getattr(table, name)(*arguments)
    except ValueError as error:
        assert len(str(error).splitlines()) == 1 and str(error), error
        return table
