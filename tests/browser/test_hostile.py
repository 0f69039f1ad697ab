"""What a student types or a file holds is shown as it is: nothing of it runs in a browser."""
import contextlib
import json
from math import pi
from pathlib import Path
from xml.etree import ElementTree

import nbformat
import pytest
from editing import shown_in
from hostile import CONTROL, HIT, SEEN, TEXTS, in_one_line
from reading import RESTED, settle

import kinlab as kl
from kinlab.__main__ import main
from kinlab.answers.prediction import Asked, Choice, Mark, Number, Several, Signs
from kinlab.browser import bundle
from kinlab.course import site
from kinlab.exercises import check
from kinlab.tables.as_csv import as_text, as_typed
from kinlab.tables.table import DHTable
from kinlab.views import folding
from kinlab.views.prediction import Prediction

FEW = ("end of all", "attribute")
every_text = pytest.mark.parametrize("evil", [
    pytest.param(text, id=name, marks=[] if name in FEW else pytest.mark.thorough)
    for name, text in TEXTS.items()])
one_text = pytest.mark.parametrize("evil", [
    pytest.param(text, id=name, marks=[] if name == "end of all" else pytest.mark.thorough)
    for name, text in TEXTS.items()])


def arm_of(name):
    """An arm with this for its name, for its unit and for the names of its joints."""
    return kl.Arm([kl.revolute(a=1, alpha=pi / 2, name=name),
                   kl.prismatic(limits=(0, 1), name=name)], name=name, unit=name)


@pytest.fixture
def guarded(lend, watched):
    """A page that may ask nobody for anything; it says what it has asked for, and its dialogs."""
    page = watched(lend(fresh=True))
    page.asked = []
    page.on("dialog", lambda dialog: (page.asked.append(dialog.message), dialog.dismiss()))
    page.on("request", lambda request: page.asked.append(request.url))
    return page


def assert_quiet(page, kinds=()):
    """Nothing has run in the page, and it has no element of a kind that is not among `kinds`."""
    settle(page)
    seen = page.evaluate(SEEN)
    assert seen["hit"] is None and not seen["handlers"] and not seen["links"]
    assert [url for url in page.asked if not url.startswith(("file:", "data:", "blob:"))] == []
    if kinds:
        assert set(seen["kinds"]) <= set(kinds), set(seen["kinds"]) - set(kinds)


# ---- a page of a view ----


VIEWS = {"arm": lambda arm: kl.ArmView(arm, closed_form=True),
         "target": kl.TargetView,
         "stages": lambda arm: kl.link_view(arm, 1),
         "velocity": kl.velocity_view,
         "solve": lambda arm: kl.solve_view(arm, kl.forward_kinematics(arm, [0.1, 0.2])[:3, 3],
                                            methods=("damped", "transpose"))}


def kinds_of(page, view, path, question):
    """The kinds of elements in a view's page."""
    page.goto(view.save_html(path, question).as_uri())
    page.locator(".kl-picture svg").wait_for()
    page.evaluate(RESTED)
    return page.evaluate(SEEN)["kinds"]


@pytest.fixture(scope="module")
def plain():
    """The kinds of elements in the page of each view whose names are words."""
    return {}


@every_text
@pytest.mark.parametrize("kind", [
    kind if kind == "arm" else pytest.param(kind, marks=pytest.mark.thorough) for kind in VIEWS])
def test_a_page_shows_names_as_they_are(guarded, tmp_path, plain, kind, evil):
    make = VIEWS[kind]
    if kind not in plain:
        plain[kind] = kinds_of(guarded, make(arm_of("elbow")), tmp_path / "plain.html", "Why?")
    view = make(arm_of(evil))
    kinds_of(guarded, view, tmp_path / "evil.html", evil)
    assert guarded.title() == in_one_line(view.scene["name"])
    assert guarded.locator("h1").text_content() == view.scene["name"]
    assert guarded.locator(".kl-question").text_content() == evil
    labels = guarded.locator("[aria-label]").evaluate_all("all => all.map(n => n.ariaLabel)")
    assert any(evil in label for label in labels)
    for handle in guarded.get_by_role("slider").all()[:2]:
        handle.press("ArrowRight")
    assert_quiet(guarded, plain[kind])


@every_text
def test_without_a_script_a_page_shows_names_as_they_are(browser, tmp_path, evil):
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.asked = []
    page.on("request", lambda request: page.asked.append(request.url))
    view = kl.ArmView(arm_of(evil))
    page.goto(view.save_html(tmp_path / "evil.html", evil).as_uri())
    alt = page.locator("img").get_attribute("alt")
    assert alt == f"Picture of the arm. {view!r}" and page.locator("img").count() == 1
    assert page.locator("h1").text_content() == evil
    assert page.locator("script").count() == 2
    assert [url for url in page.asked if not url.startswith(("file:", "data:"))] == []
    context.close()


def test_an_address_is_only_read_for_numbers(guarded, tmp_path):
    address = kl.ArmView(kl.robots.two_link()).save_html(tmp_path / "arm.html").as_uri()
    guarded.goto(f"{address}#q=<img src=x onerror={HIT}>,1")
    guarded.locator(".kl-picture svg").wait_for()
    plain = guarded.evaluate(SEEN)["kinds"]
    for text in [*TEXTS.values(), "%", "%E0%A4%A", "1e999,NaN", "0x10,1", ",", "1," * 9999]:
        for start in ("", "q=", "kl:joint=", "kl:"):
            guarded.evaluate("text => { location.hash = text; }", start + text)
            settle(guarded)
    assert_quiet(guarded, plain)
    assert guarded.get_by_role("slider").first.evaluate("node => Number.isFinite(+node.value)")


def test_a_term_with_a_hostile_address_lights_nothing(guarded, tmp_path):
    view = kl.ArmView(kl.robots.two_link()).html()
    terms = [*TEXTS.values(), "%", "joint=%E0%A4%A", "joint=1e9", "joint=__proto__", "frame=']"]
    (tmp_path / "terms.html").write_text(
        f"<!doctype html>{view}<p id=terms></p><script>{bundle.script('host_page.js')}</script>",
        encoding="utf-8")
    guarded.goto((tmp_path / "terms.html").as_uri())
    guarded.locator(".kl-picture svg").wait_for()
    guarded.evaluate("""all => terms.append(...all.map(text => {
        const term = document.createElement('a');
        term.setAttribute('href', '#kl:' + text);
        term.textContent = 'term';
        return term;
    }))""", terms)
    for term in guarded.locator("#terms a").all():
        term.focus()
        term.dispatch_event("pointerover")
        term.dispatch_event("click")
    assert_quiet(guarded)


# ---- predictions ----


def asked(text):
    """A question of each kind, with this in all that a lesson may write into it."""
    words = {"ask": text, "why": text}
    options = {text: text, f"{text}!": text}
    return [Choice(**words, options=options, right=text),
            Several(**words, options=options, right=[text]),
            Number(**words, right=1, tolerance=0.1, unit=text, slips=[(2, text)]),
            Signs(**words, rows=(text,), columns=(text, f"{text}!"), right=("+-",),
                  among={"+": text, "-": text})]


ANSWERS = {"choice": lambda text: f"{text}!", "several": lambda text: [f"{text}!"],
           "number": lambda text: 2, "signs": lambda text: ["--"]}


def prediction_page(text, folder, name="trial.hostile"):
    return Prediction(name, Asked(None, asked(text))).save_html(folder / "predict.html").as_uri()


def remember(page, record, name="trial.hostile"):
    """Let the browser's store hold this, as text, when a page is opened."""
    store = "name == null ? record : JSON.stringify({ [name]: JSON.parse(record) })"
    page.add_init_script(  # before the page's own: a store that was just written may come later
        f"(([name, record]) => localStorage.setItem('kinlab predictions', {store}))"
        f"({json.dumps([name, record])})")


@every_text
def test_questions_and_what_is_said_to_answers_are_words(guarded, tmp_path, evil):
    address = prediction_page(evil, tmp_path)
    guarded.goto(address)
    plain = None
    for text in ("one", evil):
        prediction_page(text, tmp_path)
        record = [{"case": k, "answer": ANSWERS[one.kind](text)}
                  for k, one in enumerate(asked(text))]
        for k in range(len(record)):
            remember(guarded, json.dumps(record[:k + 1]))
            guarded.reload()
            node = guarded.locator(".kl-predict")
            node.locator(".kl-told p").first.wait_for()
            assert node.locator(".kl-ask").first.text_content() == text
            if k:
                node.locator(".kl-past summary").click()
            if k == len(record) - 1 and plain is None:
                plain = guarded.evaluate(SEEN)["kinds"]
    assert_quiet(guarded)
    assert set(guarded.evaluate(SEEN)["kinds"]) <= set(plain)


def test_a_typed_answer_is_only_read_as_a_number(guarded, tmp_path):
    number = Number(ask="How long?", why="So.", right=1, tolerance=0.1, unit="m")
    guarded.goto(Prediction("trial.typed", Asked(None, [number])).save_html(
        tmp_path / "typed.html").as_uri())
    plain = guarded.evaluate(SEEN)["kinds"]
    field = guarded.locator(".kl-predict input")
    for text in [*TEXTS.values(), "9" * 500]:
        field.fill(text)
        guarded.get_by_role("button", name="Commit").click()
        assert guarded.locator(".kl-told").text_content()
    assert guarded.evaluate("localStorage.length") == 0   # none was an answer
    assert_quiet(guarded, plain)


# What somebody may have put into a notebook's metadata or into the browser's store.
TAMPERED = ["null", "0", '"x"', "[]", "{}", "[null]", "[[]]", '[{"case": "length", "answer": 1}]',
            '[{"case": "__proto__"}]', '[{"case": "constructor"}]', '[{"case": -1}]',
            '[{"case": 0.5}]', '[{"case": 99, "answer": 1}]', '{"length": 3}', '[{"answer": 1}]',
            "{", "", "[" * 500]
VALUES = ["null", "true", "0", "1e999", "{}", "[]", '"__proto__"', '{"length": 1}', "[{}]",
          json.dumps("<b>" * 100_000), json.dumps([0] * 100_000), json.dumps([1e300] * 3),
          json.dumps(TEXTS["tag"]), json.dumps([TEXTS["tag"]]), json.dumps([TEXTS["tag"]] * 3)]


@pytest.mark.parametrize("kind", [
    "record", *(pytest.param(k, marks=pytest.mark.thorough) for k in range(4)), 4])
def test_a_record_that_was_tampered_with_is_read_as_far_as_it_can_be(guarded, tmp_path, kind):
    mark = Mark(ask="Where?", why="So.", tolerance=0.1, start={"theta_1": 0}, shows={"theta_1": 90})
    made = Prediction("trial.hostile", Asked(lambda: kl.ArmView(kl.robots.two_link()),
                                             [*asked("one"), mark]))
    address = made.save_html(tmp_path / "predict.html").as_uri()
    guarded.goto(address)
    if kind == "record":
        records = [(None, text) for text in TAMPERED]
        records += [("trial.hostile", text) for text in TAMPERED[:-3]]
    else:
        records = [("trial.hostile", f'[{{"case": {kind}, "answer": {value}}}]')
                   for value in VALUES]
    for name, record in records:
        remember(guarded, record, name)
        guarded.reload()
        guarded.locator(".kl-predict-buttons button").first.wait_for(timeout=10_000)
        assert guarded.locator(".kl-ask").first.text_content()
        assert "NaN" not in guarded.locator(".kl-view").inner_html()
    assert_quiet(guarded)
    remember(guarded, '[{"case": 0, "answer": "one"}, {"case": 1, "answer": 7}]')
    guarded.reload()                                # what can be read stays
    assert "Right." in guarded.locator(".kl-told").text_content()


@pytest.mark.parametrize("record", TAMPERED[:-3])
def test_python_reads_of_a_tampered_record_what_it_can(record):
    made = Prediction("trial.hostile", Asked(None, asked("one")))
    with contextlib.suppress(kl.views.live.traitlets.TraitError):
        made.set_state({"record": json.loads(record)})
    assert (made.answers, made.committed, made.told) == ([], False, None)
    made.commit("one")
    assert made.told.ok


# ---- the table's editor, with Python behind it and no Jupyter ----


@pytest.fixture
def edited(guarded):
    """A function that shows an editor, whose messages Python hears."""
    return shown_in(guarded)


@every_text
def test_an_editor_shows_all_that_is_typed_or_loaded_as_it_is(edited, evil):
    page = edited(kl.DHTableEditor(kl.robots.exam_2018()))
    panels = ("The arm matrix in closed form", "Only the signs of the table's numbers",
              "The same numbers in the other convention, side by side")

    def walk(editor, text):
        """Type the text everywhere, open all panels, and save in every format."""
        page = edited(editor)
        page.evaluate("window.hit = undefined")
        for title in panels:
            page.locator(f'[data-at="{title}"]').click()
            page.wait_for_function("title => document.querySelector(`[data-at=\"${title}\"]`)"
                                   ".getAttribute('aria-pressed') === 'true'", arg=title)
        before = page.evaluate(SEEN)["kinds"]
        field = page.locator(".kl-cell").nth(1)
        field.fill(text)
        field.press("Enter")
        page.wait_for_function("model.state.cells.wrong === 1")
        assert field.input_value() == editor.table.rows[0].d
        return before + page.evaluate(SEEN)["kinds"]

    plain = walk(kl.DHTableEditor(kl.robots.exam_2018()), "x y")
    table = DHTable.of(arm_of(evil))
    first = kl.DHTableEditor(arm_of(evil))
    for kind in ("csv", "markdown", "latex", "code"):   # what is written is read as it was
        again = kl.DHTableEditor()
        again.load(getattr(first, f"to_{kind}")())
        assert again.table == first.table, kind
    seen = walk(first, evil)
    assert page.locator("select[aria-label=Lengths] option").first.text_content() == table.unit
    page.evaluate("""text => {
        const data = new DataTransfer();
        data.setData('text/plain', text);
        document.querySelector('.kl-table').dispatchEvent(
            new ClipboardEvent('paste', {clipboardData: data, bubbles: true, cancelable: true}));
    }""", f"name,{evil}\ntheta,d,a,alpha\n{evil},0,{evil},90\n")
    settle(page)
    assert_quiet(page)
    assert set(seen) <= set(plain)


@pytest.mark.parametrize("evil", TEXTS.values(), ids=TEXTS)
def test_a_spreadsheet_finds_no_formula_in_a_table(evil):
    editor = kl.DHTableEditor(arm_of(evil))
    editor.set(1, "a", evil)
    editor.set(1, "d", "-pi/2")
    cells = [cell for line in kl.tables.own._csv_lines(editor.to_csv()) for cell in line]
    assert "-pi/2" in cells
    assert not [cell for cell in cells if cell[:1] in "=+@" and cell]
    assert not [cell for cell in cells if cell.startswith("-") and ("(" in cell or "|" in cell)]
    again = kl.DHTableEditor()
    again.load(editor.to_csv())
    assert again.table == editor.table


@pytest.mark.parametrize("cell", ["=1", "'=1", "''=1", "'", "'a", "@x", "-1", "-d2", "-sqrt(2)*L1",
                                  "-cmd|x", "-(A1)", "--", "-1 " * 60 + "!", "＝1", ""])
def test_what_is_written_for_a_spreadsheet_is_read_as_it_was(cell):
    assert as_typed(as_text(cell)) == cell


# ---- verdicts, shown results, folded answers ----


def named(name):
    """An object whose class, words and errors are all this."""
    def refuse(*_):
        raise type(name, (Exception,), {})(name)
    made = type(name, (), {"__repr__": lambda _: name, "__str__": lambda _: name,
                           "__len__": refuse, "__iter__": refuse, "__float__": refuse})
    made.__module__ = name
    return made()


def answers_of(text):
    def raises(*_):
        raise type(text, (ValueError,), {})(text)
    return [text, [text] * 3, {text: text}, named(text), raises, lambda *_: text,
            lambda *_: named(text), {text}, (text, named(text))]


def judged(text):
    names = ("alpha_ii.1", "alpha_ii.2", "alpha_ii.3", "translation.1", "dh_recipe.1", "inverse.1")
    return [check(name, answer) for name in names for answer in answers_of(text)]


def folded(data, monkeypatch):
    monkeypatch.setattr(folding, "is_folded", lambda: True)
    return folding.folded({"content": {"data": dict(data)}})["content"]["data"]["text/html"]


@every_text
def test_verdicts_tables_and_folded_answers_are_words(guarded, evil, monkeypatch):
    sp = pytest.importorskip("sympy")
    formula = sp.Symbol(evil)._repr_latex_()
    shown = kl.show(**{evil: evil})
    parts = [arm_of(evil)._repr_html_(), *(verdict._repr_html_() for verdict in judged(evil)),
             folded({"text/plain": repr(shown)}, monkeypatch),
             folded({"text/latex": formula, "text/plain": evil}, monkeypatch)]
    guarded.set_content("<!doctype html>" + "".join(parts))
    assert_quiet(guarded)
    allowed = {"html", "head", "body", "div", "strong", "table", "caption", "thead", "tbody", "tr",
               "th", "td", "details", "summary", "pre"}
    assert set(guarded.evaluate(SEEN)["kinds"]) <= allowed
    assert guarded.locator("caption").text_content().startswith(f"{evil}: standard DH")
    assert in_one_line(formula) in in_one_line(guarded.locator("details").last.text_content())


def test_what_is_said_to_a_hostile_answer_is_of_a_bearable_length():
    for text in ("<b>" * 100_000, "a" * 1_000_000):
        assert all(len(verdict.message) < 1300 and not verdict.ok for verdict in judged(text))


@pytest.mark.parametrize("text", CONTROL.values(), ids=CONTROL)
@pytest.mark.parametrize("door", [
    lambda text: kl.Arm([kl.revolute(a=1)], name=text),
    lambda text: kl.Arm([kl.revolute(a=1)], unit=text),
    lambda text: kl.revolute(a=1, name=text),
    lambda text: kl.ArmView(kl.robots.two_link()).save_html("x.html", text),
], ids=["name", "unit", "joint", "question"])
def test_a_name_has_no_control_characters(door, text):
    with pytest.raises(ValueError, match=r"expected one line of text, got .*; take out"):
        door(text)


def test_an_argument_that_cannot_be_printed_is_refused_in_a_sentence():
    class Mute:
        def __repr__(self):
            raise RuntimeError("repr")

    for value in (Mute(), [Mute()], {"a": Mute()}):
        with pytest.raises(ValueError, match="that cannot be shown"):
            kl.Arm([kl.revolute(a=1)], name=value)


# ---- the site ----


def lesson_of(text):
    """A notebook with this wherever a file may have it; what its code shows is only text."""
    quoted = repr(text)
    cells = [nbformat.v4.new_markdown_cell(f"# Why {text}\n\nTime: 5 minutes in 1 part.\n\n{text}"),
             nbformat.v4.new_code_cell(f"import kinlab as kl, sympy\nprint({quoted})"),
             nbformat.v4.new_code_cell(
                 f"arm = kl.Arm([kl.revolute(a=1, name={quoted})], name={quoted}, unit={quoted})\n"
                 "kl.ArmView(arm)"),
             nbformat.v4.new_code_cell("arm"), nbformat.v4.new_code_cell(quoted),
             nbformat.v4.new_code_cell(f"kl.exercises.check('alpha_ii.2', {quoted})"),
             nbformat.v4.new_markdown_cell(
                 f"## {text}\n\n- {text}\n\n| a | b |\n|--|--|\n| {text} | x |\n\n"
                 f"<details onclick={HIT}><summary>{text}</summary>\n\n{text}\n\n</details>\n\n"
                 f"```{text}\n{text}\n```\n\n    {text}\n\n"
                 f"[term](#kl:{text}) [link](javascript:{HIT}) ![p](javascript:{HIT})")]
    for cell in cells:
        cell.metadata["magics_language"] = text
        cell.metadata["tags"] = [text]
    return nbformat.v4.new_notebook(cells=cells, metadata={
        "language_info": {"name": text, "pygments_lexer": text}, "kinlab": text, "title": text})


@one_text
def test_a_site_shows_what_a_notebook_says_as_it_is(guarded, tmp_path, evil):
    if evil in (TEXTS["half a formula"], TEXTS["LaTeX"]):
        pytest.skip("a formula in Markdown, which is typeset")
    name = evil.replace("/", "∕")[:60]              # as a file's name may be
    path = tmp_path / f"{name}.ipynb"
    nbformat.write(lesson_of(evil), path)
    site.build(tmp_path / "site", [path])
    guarded.goto((tmp_path / "site" / "index.html").as_uri())
    assert_quiet(guarded)
    guarded.locator("main a[href$='.html']").first.press("Enter")   # a name may be unseen
    guarded.locator(".kl-picture svg").wait_for()
    settle(guarded)
    seen = guarded.evaluate(SEEN)
    assert seen["hit"] is None and not seen["handlers"]
    assert not [link for link in seen["links"] if "javascript" in link]
    assert guarded.locator("main script, main style, main b, main svg a").count() == 0
    for k, words in ((0, evil), (3, repr(evil))):
        assert guarded.locator(".kl-output").nth(k).text_content().strip() == words.strip()
    title = guarded.locator(".kl-output > table caption").text_content()
    assert title.startswith(f"{evil}: standard")
    assert [url for url in guarded.asked if not url.startswith(("file:", "data:", "blob:"))] == []


@pytest.mark.parametrize("evil", TEXTS.values(), ids=TEXTS)
def test_the_map_of_a_site_shows_names_and_questions_as_they_are(evil):
    asks = lesson_of(evil)
    one = site.Lesson(Path(f"{evil.replace('/', '∕')}.ipynb"), asks, evil)
    table = ElementTree.fromstring(site._markdown(site.course_map([one]).cells[1].source))
    row = table.findall(".//td")
    assert ["".join(cell.itertext()) for cell in row] == [evil, f"Why {evil}", "5 minutes"]
    assert [part.tag for cell in row for part in cell.iter()] == ["td", "a", "td", "td"]
    assert row[0].find("a").get("href") == f"./{one.page}"


@pytest.mark.parametrize("evil", TEXTS.values(), ids=TEXTS)
def test_formulas_of_a_site_and_markdown_that_is_saved_are_words(evil):
    """Without a browser: no tag comes of a text, and no attribute that does something."""
    formula = site._output(nbformat.v4.new_output("display_data", {"text/latex": evil})) \
        if "$" not in evil else ""
    written = site._markdown(kl.DHTableEditor(arm_of(evil)).to_markdown())
    drawn = site.mathml.mathematics(rf"\text{{{evil}}}") if "$" not in evil and "{" not in evil \
        else ""
    for made in (formula, written, drawn):
        for part in ("<img", "<script", "<svg", "<b>", '"javascript', "<annotation", "<style"):
            assert part not in made, (part, made)


@pytest.mark.parametrize("latex", [
    rf"\text{{<img src=x onerror={HIT}>}}", rf"\href{{javascript:{HIT}}}{{x}}",
    rf'\color{{"><img src=x onerror={HIT}>}}x', r"\style{background:url(//x)}{x}",
    r"\class{kl-view}{x}", rf"\textbf{{</math><img src=x onerror={HIT}>}}"])
def test_a_formula_is_only_a_formula(guarded, latex):
    guarded.set_content(f"<!doctype html>{site.mathml.mathematics(latex)}")
    guarded.locator("math").click()
    assert_quiet(guarded)
    seen = guarded.evaluate(SEEN)
    assert {*seen["kinds"]} <= {"html", "head", "body", "math", "mrow", "mtext", "mi", "mstyle"}
    assert {*seen["names"]} <= {"xmlns", "display", "mathcolor", "mathvariant"}


# ---- JupyterLab ----


@pytest.mark.thorough
def test_in_jupyterlab_names_are_words(notebook):
    names = ("tag", "end of all", "attribute", "template", "MathML")
    some = [TEXTS[name] for name in names]
    typeset = TEXTS["LaTeX"]                        # JupyterLab typesets what is between two $
    page = notebook(
        "import kinlab as kl\nfrom IPython.display import Markdown, display\n"
        f"texts = {[*some, typeset]!r}",
        "for text in texts:\n"
        "    arm = kl.Arm([kl.revolute(a=1, name=text)], name=text, unit=text)\n"
        "    editor = kl.DHTableEditor(arm)\n"
        "    editor.set(1, 'd', text)\n"
        "    display(kl.ArmView(arm), arm, kl.exercises.check('alpha_ii.2', text),\n"
        "            kl.show(**{text: text}), editor, Markdown(editor.to_markdown()))")
    captions = page.locator(".jp-Notebook:visible .jp-RenderedHTML caption")
    page.wait_for_function("n => document.querySelectorAll('.kl-view .kl-picture svg').length >= n",
                           arg=2 * len(some) + 2)
    settle(page)
    assert page.evaluate("window.hit") is None
    shown = [text.partition(": standard DH")[0] for text in captions.all_text_contents()]
    assert shown[:-1] == some and shown[-1].startswith(typeset.partition("$")[0])
    assert page.locator(".kl-view img, .kl-editor img, .kl-view b, .kl-editor svg a").count() == 0


# ---- the command ----


@pytest.mark.parametrize("evil", TEXTS.values(), ids=TEXTS)
def test_lessons_go_into_a_folder_of_any_name(evil, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("kinlab.course.handout.all_notebooks", lambda: [
        kl.course.handout.FOLDER / kl.course.handout.FIRST])
    folder = evil.replace("/", "∕")
    assert main(["lessons", "--copy-only", "--", f"{folder}"]) == 0
    assert (tmp_path / folder / kl.course.handout.FIRST).is_file()
    assert [path.name for path in tmp_path.iterdir()] == [folder]
    assert folder in capsys.readouterr().out
