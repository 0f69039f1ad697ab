"""XML of strangers: nothing in it is fetched, expanded or run; what is wrong is one sentence."""
import re
import sys

import pytest

import kinlab as kl
from kinlab.urdf.document import LARGEST, root_of

ROBOT = """<robot name="R"><link name="a"/><link name="b"/><joint name="j" type="continuous">
    <parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint></robot>"""


def refused(source):
    with pytest.raises(ValueError) as caught:
        kl.from_urdf(source)
    assert len(str(caught.value).splitlines()) == 1
    return str(caught.value)


LAUGHS = ('<!DOCTYPE robot [<!ENTITY a "ha">' + "".join(
    f'<!ENTITY {b} "{10 * f"&{a};"}">' for a, b in zip("abcdefghi", "bcdefghij")) + "]>")
DECLARED = {
    "ten to the ninth laughs": f'{LAUGHS}<robot name="&j;"/>',
    "a file": '<!DOCTYPE robot [<!ENTITY f SYSTEM "file:///etc/passwd">]><robot name="&f;"/>',
    "the network": '<!DOCTYPE robot SYSTEM "http://kinlab.invalid/robot.dtd"><robot/>',
    "a parameter": '<!DOCTYPE r [<!ENTITY % p SYSTEM "http://kinlab.invalid/p">%p;]><robot/>',
    "a public type": '<!DOCTYPE robot PUBLIC "-//R//EN" "http://kinlab.invalid/r.dtd"><robot/>',
    "an attribute by default": '<!DOCTYPE robot [<!ATTLIST robot name CDATA "x">]><robot/>',
    "nothing": "<!DOCTYPE robot><robot/>",
}


@pytest.mark.parametrize("text", DECLARED.values(), ids=DECLARED)
def test_a_document_type_is_refused_and_nothing_is_opened(text, touched):
    assert refused(text).startswith("path_or_text: expected a file without a document type")
    assert not touched


def test_what_is_opened_would_be_seen(touched, tmp_path):
    refused(tmp_path / "nowhere.urdf")
    assert {event for event, _ in touched} == {"open"}


@pytest.fixture
def touched():
    """Files that are opened and addresses that are asked for, while a test runs."""
    kl.from_urdf(ROBOT)  # whatever is imported late is there now
    seen, watching = [], True

    def watch(event, args):
        if watching and event.split(".")[0] in ("open", "socket", "urllib", "subprocess"):
            seen.append((event, args))

    sys.addaudithook(watch)
    yield seen
    watching = False  # no hook can be taken away again


def test_an_entity_that_nobody_declared_is_no_xml():
    assert "undefined entity" in refused('<robot name="&who;"/>')


def test_signs_that_every_xml_has_are_read():
    assert root_of('<robot name="&lt;a&gt; &amp; &#955;"/>').get("name") == "<a> & λ"


def test_what_would_include_another_file_stays_an_element():
    text = ROBOT.replace("<link", '<xi:include xmlns:xi="http://www.w3.org/2001/XInclude" '
                         'href="/etc/passwd" parse="text"/><link', 1)
    assert kl.from_urdf(text).n == 1


def test_no_element_is_too_deep_for_python():
    deep = "<robot>" + "<a>" * 200_000
    assert "expected elements in up to 100 others" in refused(deep)


def test_a_file_that_is_too_large_is_not_read_on(tmp_path):
    file = tmp_path / "large.urdf"
    with file.open("wb") as out:
        out.truncate(LARGEST + 1000)
    assert "expected a file of up to 20 MB" in refused(file)
    assert "expected a file of up to 20 MB" in refused("<" + " " * LARGEST)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "latin-1"])
def test_encodings_are_those_that_the_file_names(encoding, tmp_path):
    named = "" if encoding.startswith("utf-8") else f'<?xml version="1.0" encoding="{encoding}"?>'
    file = tmp_path / "ümlaut.urdf"
    file.write_bytes((named + ROBOT.replace('"R"', '"Größe"')).encode(encoding))
    assert kl.from_urdf(file).name == kl.from_urdf(str(file)).name == "Größe"
    assert kl.from_urdf(file.read_bytes()).name == "Größe"


@pytest.mark.parametrize("before", ["", "\ufeff", "\n  ", "\ufeff\r\n", '<?xml version="1.0"?>\n',
                                    '\n\n<?xml version="1.0" encoding="utf-16"?>'])
def test_text_may_begin_with_a_mark_or_empty_lines(before):
    assert kl.from_urdf(before + ROBOT).name == "R"


def test_empty_lines_before_a_declaration_are_forgiven_in_a_file_too(tmp_path):
    (tmp_path / "r.urdf").write_text('\n<?xml version="1.0"?>' + ROBOT)
    assert kl.from_urdf(tmp_path / "r.urdf").n == 1


WRONG = {
    "no file": ("nowhere.urdf", "got 'nowhere.urdf', which is not there"),
    "a name with a zero": ("a\0b", "which is not there"),
    "somebody's home": ("~nobody-of-this-name/r.urdf", "which is not there"),
    "an empty name": ("", "got '', which is empty; write kl.from_urdf("),
    "spaces": (" \n", "which is empty"),
    "a folder": (".", "which is a folder; name a file in it"),
    "a file in a file": (f"{__file__}/x", "which is not there"),
    "a long name": ("a" * 5000, "which cannot be read"),
    "words": ("robot: a", "which is not there"),
    "Python": (b"import os", "expected XML, got b'import os', which cannot be read (syntax error"),
    "half of it": (ROBOT[:99], "expected XML, got"),
    "two roots": ("<robot/><robot/>", "junk after document element"),
    "another encoding": (b'<?xml version="1.0" encoding="klingon"?><robot/>', "unknown encoding"),
    "not UTF-8": (b'<robot name="\xff"/>', "not well-formed"),
    "nothing": (b"", "no element found"),
    "SDF": ('<sdf version="1.6"/>', "got <sdf>, which is SDF, of Gazebo"),
    "MJCF": ("<mujoco/>", "got <mujoco>, which is MJCF, of MuJoCo"),
    "a page": ("<html/>", "got <html>, which is another kind of XML"),
    "a number": (3, "expected a file's name or the text of a URDF, got 3"),
}


@pytest.mark.parametrize(("source", "said"), WRONG.values(), ids=WRONG)
def test_what_is_no_urdf_is_refused_in_a_sentence(source, said):
    message = refused(source)
    assert re.match(r"path_or_text: expected .*, got .*[;,] ", message) and said in message
