"""DH tables as kinlab code: written to be run, read through a whitelist, never run here."""
from __future__ import annotations

import ast
import re
import warnings
from collections.abc import Iterator
from dataclasses import dataclass, field, replace

from ..arms import inputs
from ..arms.link import FIXED, KINDS, PARAMETERS
from .cells import angle_text, is_plain, line, number_text
from .ends import ENDS, End
from .numbers import names_in, parse_number
from .table import LIMITS, MOST_LENGTHS, MOST_ROWS, RATES, DHTable, Place, Row

LONGEST_FILE = 100_000
_MATH = ("cos", "pi", "radians", "sin", "sqrt")
_LIBRARIES = ("math", "np", "numpy")
_SHAPE = "code such as kl.Arm([kl.revolute(d=215, alpha=radians(-90))], unit='mm')"
_ASCII_SUM = re.compile(r"[-+*/(). 0-9A-Za-z_^]*")


# ---- writing -------------------------------------------------------------------------------------


def to_code(table: DHTable) -> str:
    """Python code that builds the table's arm; named lengths stay names.

    Raises
    ------
    ValueError
        If a cell of the table is wrong.

    Examples
    --------
    >>> print(to_code(DHTable((Row(a="l1", alpha="-90"),), lengths=(("l1", "0.5"),))))
    from math import radians
    <BLANKLINE>
    import kinlab as kl
    <BLANKLINE>
    l1 = 0.5
    arm = kl.Arm([
        kl.revolute(a=l1, alpha=radians(-90)),
    ], convention="standard", unit="m")
    <BLANKLINE>
    """
    if table.arm is None:
        place, reason = next(iter(table.errors.items()))
        raise ValueError(f"table: expected cells that can be read; row {place.row}, "
                         f"{place.column}: {reason}")
    lengths = [f"{name} = {_length(text, table, Place(k, 'length'))}"
               for k, (name, text) in enumerate(table.lengths, start=1)]
    rows = [f"    kl.{row.kind}({', '.join(_arguments(table, i, row))}),"
            for i, row in enumerate(table.rows, start=1)]
    body = "\n".join([*lengths, "arm = kl.Arm([", *rows, f"], {', '.join(_ends(table))})", ""])
    used = [name for name in _MATH if re.search(rf"\b{name}\b", body)]
    start = f"from math import {', '.join(used)}\n\n" if used else ""
    return f"{start}import kinlab as kl\n\n{body}"


def _arguments(table: DHTable, i: int, row: Row) -> Iterator[str]:
    """The arguments of one row; those that are zero are left out."""
    for column in PARAMETERS:
        if table.values[Place(i, column)]:
            yield f"{column}={_cell(table, i, row, column)}"
    if row.low:
        yield f"limits=({_cell(table, i, row, 'low')}, {_cell(table, i, row, 'high')})"
    for column in RATES:
        if getattr(row, column):
            yield f"{column}={_cell(table, i, row, column)}"
    if row.name:
        yield f"name={_quoted(row.name)}"
    if row.flip:
        yield "flip=True"


def _ends(table: DHTable) -> Iterator[str]:
    yield f'convention="{table.convention}"'
    if table.name:
        yield f"name={_quoted(table.name)}"
    yield f"unit={_quoted(table.unit)}"
    for end in ENDS:
        if getattr(table, end) and (T := table.end(end)) is not None:
            rows = (", ".join(map(number_text, row)) for row in T.tolist())
            yield f"{end}=[[{'], ['.join(rows)}]]"
    joints = [(i, row) for i, row in enumerate(table.rows, start=1) if row.variable]
    if any(row.home for _, row in joints):
        homes = (_cell(table, i, row, "home" if row.home else _resting(row)) for i, row in joints)
        yield f"home=[{', '.join(homes)}]"


def _resting(row: Row) -> str:
    """The column that says where a joint without a home rests: a locked one at its limits."""
    return "low" if row.low == row.high else ""


def _cell(table: DHTable, i: int, row: Row, column: str) -> str:
    """The number of a cell; 0 where there is none."""
    text, place = getattr(row, column, ""), Place(i, column)
    if not text:
        return "0"
    return (_angle if row.is_angle(column) else _length)(text, table, place)


def _angle(text: str, table: DHTable, place: Place) -> str:
    value = table.values[place]
    if is_plain(text) and table.angles == "deg":
        return f"radians({number_text(float(text))})" if value else "0"
    if text.isascii() and "pi" in text and _same(text, value):
        return text
    part = angle_text(value, "rad")
    return part if "pi" in part else number_text(value)


def _length(text: str, table: DHTable, place: Place) -> str:
    value = table.values[place]
    named = enumerate(table.lengths if place.column != "length" else (), start=1)
    names = {name: table.values[Place(k, "length")] for k, (name, _) in named}
    if is_plain(text) or not _same(text, value, names):
        return number_text(value)
    return text.replace("^", "**")


def _same(text: str, value: float, names: dict | None = None) -> bool:
    """Whether the text means the same in Python as in a cell."""
    if not _ASCII_SUM.fullmatch(text) or re.search(r"\b(deg|rad)\b|[0-9]_|\b0[0-9]", text):
        return False
    try:
        ast.parse(text.replace("^", "**"), mode="eval")
        return parse_number(text, names) == value
    except (ValueError, SyntaxError):
        return False


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


# ---- reading -------------------------------------------------------------------------------------


def from_code(text: str, angles: str = "deg") -> DHTable:
    """The table, its angles in degrees or radians, of an arm written as code, which is never run.

    ``kl.Arm``, ``kl.revolute``, ``kl.prismatic`` and ``kl.fixed`` with numbers, pi, radians, named
    lengths, and assignments of such to names are understood; the last arm in the text counts.

    Raises
    ------
    ValueError
        If something else stands there; the line is named.

    Examples
    --------
    >>> table = from_code("l1 = 0.5\\nkl.Arm([kl.revolute(a=l1, alpha=radians(-90))], unit='m')")
    >>> table.rows[0].a, table.rows[0].alpha, table.lengths
    ('l1', '-90', (('l1', '0.5'),))
    """
    if not isinstance(text, str) or len(text) > LONGEST_FILE:
        raise ValueError(f"text: expected {_SHAPE}, at most {LONGEST_FILE} characters, "
                         f"got {inputs.brief(text)}")
    try:
        with warnings.catch_warnings(action="ignore"):  # Python's own remarks on odd escapes
            return _Reader(angles).read(ast.parse(text.replace("\0", " ")))
    except (SyntaxError, UnicodeError, MemoryError, RecursionError) as error:
        number = getattr(error, "lineno", None)
        where = f"line {number} is" if number else "this is"
        raise ValueError(f"text: expected {_SHAPE}; {where} not Python") from None


@dataclass
class _Reader:
    """What the names of the text stand for, as far as it is read."""

    angles: str
    lists: dict[str, ast.expr] = field(default_factory=dict)
    numbers: dict[str, float] = field(default_factory=dict)
    texts: dict[str, str] = field(default_factory=dict)
    table: DHTable | None = None

    def read(self, module: ast.Module) -> DHTable:
        for statement in module.body:
            match statement:
                case ast.Import() | ast.ImportFrom() | ast.Expr(value=ast.Name() | ast.Constant()):
                    pass
                case ast.Assign(targets=[ast.Name(id=name)], value=value):
                    self.assign(name, value)
                case ast.Expr(value=ast.Call() as call):
                    self.table = self.arm(call)
                case _:
                    raise _refused(statement)
        if self.table is None:
            raise ValueError(f"text: expected {_SHAPE}, got no arm")
        return self.table

    def assign(self, name: str, value: ast.expr) -> None:
        if isinstance(value, ast.List | ast.Tuple):
            self.lists[name] = value
        elif isinstance(value, ast.Call) and _called(value) == "Arm":
            self.table = self.arm(value)
        else:
            text, number = self.text(value), self.number(value)
            self.texts[name] = text if is_plain(text) else number_text(number)
            self.numbers[name] = number

    def arm(self, call: ast.Call) -> DHTable:
        given = {keyword.arg: keyword.value for keyword in call.keywords}
        links = [*call.args, *([given.pop("links")] if "links" in given else [])]
        if _called(call) != "Arm" or len(links) != 1:
            raise _refused(call)
        rows = self.items(links[0])
        if not 1 <= len(rows) <= MOST_ROWS:
            raise ValueError(f"text: expected 1 to {MOST_ROWS} joints, got {len(rows)}")
        table = DHTable(tuple(map(self.row, rows)), angles=self.angles)
        for word, value in given.items():
            table = self.told(table, word, value)
        used = {name for row in table.rows for column in ("d", "a", *LIMITS, *RATES)
                for name in names_in(getattr(row, column))}
        named = [pair for pair in self.texts.items() if pair[0] in used]
        if len(named) > MOST_LENGTHS:
            raise ValueError(f"text: expected at most {MOST_LENGTHS} named lengths")
        return replace(table, lengths=tuple(named))

    def told(self, table: DHTable, word: str | None, value: ast.expr) -> DHTable:
        """The table with what another argument of Arm says of it."""
        match word, value:
            case "convention", ast.Constant(value=convention):
                return table.read_as(str(convention))
            case "name", ast.Constant(value=str(name)):
                return replace(table, name=line(name))
            case "unit", ast.Constant(value=str(unit)):
                return replace(table, unit=line(unit))
            case "base" | "tool", _:
                numbers = [self.number(entry) for row in self.items(value)
                           for entry in self.items(row)]
                return table.with_frame(word, End.read(word, numbers))
            case "home", _:
                return replace(table, rows=self.at_home(table.rows, value))
        raise _refused(value)

    def at_home(self, rows: tuple[Row, ...], value: ast.expr) -> tuple[Row, ...]:
        """The rows with their joints' values at home; nothing where a joint rests there anyway."""
        homes = self.items(value)
        if len(homes) != sum(row.variable is not None for row in rows):
            raise _refused(value)
        left = iter(homes)
        texts = (self.cell(row, "home", next(left)) if row.variable else "" for row in rows)
        return tuple(replace(row, home="" if text == (getattr(row, _resting(row), "") or "0")
                             else text) for row, text in zip(rows, texts))

    def row(self, node: ast.expr) -> Row:
        if not isinstance(node, ast.Call) or _called(node) not in KINDS:
            raise _refused(node)
        row = Row(_called(node))
        for value in node.args:
            raise _refused(value)
        for keyword in node.keywords:
            row = self.argument(row, keyword.arg, keyword.value)
        return row

    def argument(self, row: Row, word: str | None, value: ast.expr) -> Row:
        match word, value:
            case ("theta" | "d" | "a" | "alpha") as column, _:
                return row.with_cells({column: self.cell(row, column, value)})
            case "name", ast.Constant(value=str(name)):
                return replace(row, name=line(name))
            case "name" | "limits" | "speed" | "acceleration", ast.Constant(value=None):
                return row
            case ("speed" | "acceleration") as rate, _ if row.kind != FIXED:
                return row.with_cells({rate: self.cell(row, rate, value)})
            case "flip", ast.Constant(value=bool(flip)) if row.kind != FIXED:
                return replace(row, flip=flip)
            case "limits", _ if len(ends := self.items(value)) == 2:
                return replace(row, low=self.cell(row, "low", ends[0]),
                               high=self.cell(row, "high", ends[1]))
        raise _refused(value)

    def cell(self, row: Row, column: str, node: ast.expr) -> str:
        """The text of a cell; worked out where a cell cannot say it."""
        text, number = self.text(node), self.number(node)
        if not row.is_angle(column):
            return number_text(number) if re.search(r"\b(deg|rad)\b", text) else text
        if is_plain(bare := text.removesuffix(" deg")) and bare != text and self.angles == "deg":
            return bare
        keep = "pi" in text and not names_in(text) & self.numbers.keys()
        return text if keep else angle_text(number, self.angles)

    def number(self, node: ast.expr) -> float:
        try:
            return parse_number(self.text(node), self.numbers)
        except ValueError as error:
            raise ValueError(f"text: {_line(node)}{error}") from None

    def items(self, node: ast.expr) -> list[ast.expr]:
        """The entries of a list, of a name that stands for one, or of radians([...])."""
        match node:
            case ast.List(elts=entries) | ast.Tuple(elts=entries):
                return entries
            case ast.Name(id=name) if name in self.lists:
                return self.items(self.lists.pop(name))
            case ast.Call(args=[argument], keywords=[]) if _called(node) in ("radians", "deg2rad"):
                return [ast.copy_location(ast.Call(node.func, [entry], []), entry)
                        for entry in self.items(argument)]
        raise _refused(node)

    def text(self, node: ast.expr) -> str:
        """A number's expression as the text of a cell."""
        text = ast.unparse(_Plain().visit(node)).replace(" * deg", " deg")
        return text.replace(" * ", "*").replace(" / ", "/")


class _Plain(ast.NodeTransformer):
    """math.pi and np.pi as pi, np.sqrt(2) as sqrt(2), radians(90) as 90 deg."""

    def visit_Attribute(self, node: ast.Attribute) -> ast.AST:
        library = node.value.id if isinstance(node.value, ast.Name) else ""
        return ast.Name(node.attr) if library in _LIBRARIES else node

    def visit_Call(self, node: ast.Call) -> ast.AST:
        self.generic_visit(node)
        if _called(node) in ("radians", "deg2rad") and len(node.args) == 1 and not node.keywords:
            return ast.copy_location(ast.BinOp(node.args[0], ast.Mult(), ast.Name("deg")), node)
        return node


def _called(call: ast.Call) -> str:
    """The bare name of what is called."""
    match call.func:
        case ast.Name(id=name) | ast.Attribute(value=ast.Name(), attr=name):
            return name
    return ""


def _line(node: ast.AST) -> str:
    return f"line {node.lineno}: " if hasattr(node, "lineno") else ""


def _refused(node: ast.AST) -> ValueError:
    return ValueError(f"text: {_line(node)}expected {_SHAPE}, "
                      f"got {inputs.brief(ast.unparse(node))}")
