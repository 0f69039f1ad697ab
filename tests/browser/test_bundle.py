"""Modules of JavaScript joined into one text."""
import re

import pytest

from kinlab.browser import bundle

MODULES = {
    "low.js": "// Two numbers.\n\n/**\n * Two numbers.\n */\n"
              "export const low = 1, deep = 2;\n",
    "middle.js": 'import { low } from "./low.js";\n\n/** @type {() => number} */\n'
                 "export function half() {\n  // by two\n"
                '  return /** here */ low / 2; // "</script>"\n}\n',
    "entry.js": 'import {\n  half,\n} from "./middle.js";\nimport { low } from "./low.js";\n\n'
                "export const all = half() + low;\n\nexport default { all };\n",
}


@pytest.fixture
def folder(tmp_path):
    for name, text in MODULES.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    return tmp_path


def test_what_is_needed_comes_first_and_only_the_entry_exports(folder):
    assert bundle.module("entry.js", folder) == (
        "const low=1,deep=2;function half(){return low/2;}\n"
        "export const all=half()+low;export default{all};\n")


def test_a_module_is_ascii_and_means_the_same(folder):
    (folder / "signs.js").write_text("export const signs = /[θ−]/u.test('𝜃') + `é`;\n",
                                     encoding="utf-8")
    assert bundle.module("signs.js", folder) == (
        r"export const signs=/[\u03b8\u2212]/u.test('\ud835\udf03')+`\u00e9`;" + "\n")


def test_a_page_gets_a_script_that_cannot_end_early(folder):
    (folder / "end.js").write_text('const end = "</script>";\n', encoding="utf-8")
    assert bundle.script("end.js", folder) == '(() => {const end="<\\/script>";})();\n'


@pytest.mark.parametrize("text, words", [
    ('import { low } from "./low.js";\nconst other = 3, deep = 4;\n',
     "new.js: defines 'deep', which low.js defines too; joined modules share one scope, so give "
     "one another name"),
    ("function twice() {}\nclass twice {}\n", "new.js: defines 'twice', which new.js defines too"),
    ('import { high } from "./low.js";\n',
     "new.js: imports 'high' from low.js, which exports no such name"),
    ('import { low as one } from "./low.js";\n', "new.js: imports 'low as one' from low.js"),
    ('import * as low from "./low.js";\n', "new.js: cannot follow 'import * as low from"),
    ("const name = `one ${all.map((k) => `k ${k}`)}`;\n",
     "new.js: holds '`one ${all.map((k) => `'"),
    ('import { all } from "./new.js";\n',
     "new.js > new.js: these modules import each other in a circle"),
])
def test_modules_that_cannot_share_a_scope_are_refused(text, words, folder):
    (folder / "new.js").write_text(text, encoding="utf-8")
    with pytest.raises(ValueError) as error:
        bundle.module("new.js", folder)
    assert str(error.value).startswith(words) and "\n" not in str(error.value)


@pytest.mark.parametrize("entry", ["host_jupyter.js", "host_table.js", "mount.js", "host_page.js",
                                   "host_predict.js", "host_course.js"])
def test_the_modules_of_the_package_share_one_scope(entry):
    assert not re.search(r"\bimport\b", bundle.module(entry))


def test_no_text_in_backquotes_runs_over_lines():
    """The spaces before a line are left out, wherever it stands."""
    for path in bundle.HERE.glob("*.js"):
        text = re.sub(r"\$\{[^{}]*\}", "", path.read_text(encoding="utf-8"))
        assert not [words for words in re.findall("`[^`]*`", text) if "\n" in words], path.name
