"""A student writes his methods in the browser: each mistake becomes a sentence, and the page lives on."""

import csv
import os
import pathlib
import re

import pytest

from demo_page import LINES, START_MS, DemoPage

ROOT = pathlib.Path(__file__).resolve().parents[2]
HAND_INS = ROOT / "tests" / "data" / "hand_ins"
STARTERS = ROOT / "workshop" / "starters"
FILES = {0: "my_vec2", 1: "my_vec2", 2: "my_vec2", 3: "my_vec2", 4: "my_vec2", 9: "my_vec2", 5: "my_line", 6: "my_line",
         7: "my_line", 8: "my_impact", 11: "my_impact", 10: "my_bounce", 13: "my_aim", 14: "my_aim", 15: "my_aim"}
# These are about whole files, which nobody writes here. The last one is refused for a method of another exercise: here
# each text is judged by itself.
NO_METHODS = {"form_binary", "form_empty", "form_class_name_vec2", "right_bom_and_crlf", "open_starter",
              "hostile_base_path", "hostile_base_joined", "copied_key_renamed"}
SIGNS = {"right": "✓", "open": "…", "waiting": "↑", "refused": "?"}
FIELD = (500, 400)
CHANGED = "Changed since it was checked"
UNTYPED = "func dot(other):\n"
DOT = "func dot(other: MyVec2) -> float:\n"
FRAMES = """new Promise(done => {
    let count = 0;
    const next = () => ++count === 3 ? done(count) : requestAnimationFrame(next);
    requestAnimationFrame(next);
})"""


class CodePage(DemoPage):
    """The page with one exercise open."""

    def open_exercise(self, number):
        self.start("workshop")
        self.read("Exercise 1: ")
        self.choose(number)

    def choose(self, number):
        while (shown := self.shown()) != number:
            self.click(1247, 73)
            self.page.wait_for_function(f"!/^Exercise: (✓ )?Exercise {shown}:/.test({LINES})")

    def shown(self):
        return int(re.match(r"Exercise: (?:✓ )?Exercise (\d+):", self.text())[1])

    def verdict(self):
        """What it says, without the list of exercises above it and what stands below."""
        return self.text().split("\n", 1)[1].split("\nMyVec2 has")[0]

    def select_all(self):
        self.click(*FIELD)
        self.page.wait_for_timeout(300)
        self.page.keyboard.press("Control+a")
        self.page.wait_for_timeout(300)

    def type(self, text):
        """By real keys; the field indents and closes brackets itself."""
        self.select_all()
        self.page.keyboard.type(text)
        self.read(CHANGED)
        self.check()

    def paste(self, text):
        self.page.evaluate("text => navigator.clipboard.writeText(text)", text)
        self.select_all()
        self.page.keyboard.press("Control+v")
        self.read(CHANGED)
        self.check()

    def check(self):
        """Returns once the page has judged the text as it is now, and has said so."""
        self.page.wait_for_timeout(500)
        while True:
            self.page.evaluate("lab.isJudging = 'wanted'")
            self.page.keyboard.press("Control+Enter")
            self.page.wait_for_function("lab.isJudging === false", timeout=START_MS)
            self.page.wait_for_timeout(700)
            # A slow machine may still take in what was typed.
            if CHANGED not in self.text():
                return

    def lives(self):
        return self.page.evaluate(FRAMES) == 3


@pytest.fixture
def context(browser):
    context = browser.new_context(
        viewport={"width": 1280, "height": 720}, reduced_motion="reduce", permissions=["clipboard-read", "clipboard-write"]
    )
    yield context
    context.close()


@pytest.fixture
def code(context, site):
    page = CodePage(context.new_page(), site)
    page.open_exercise(3)
    yield page
    page.close()


def test_a_right_answer_is_typed(code):
    code.type(DOT + "return x * other.x + y * other.y")
    code.read("✓ Exercise 3")
    code.read("dot is right")


@pytest.mark.parametrize(
    ("body", "sentence"),
    [
        ("return x * other.x - y * other.y", "The two products are subtracted: add them"),
        ("return x * other.x + y * othr.y", "line 2\nothr is not there: do you mean other"),
        ("while true:\nx += 1.0", "line 2\ndot does not come to an end for"),
        ("for i in 1000000000: x += 1.0", "line 2\ndot does not come to an end for"),
        ("return dot(other)", "dot calls itself without end"),
        ("return 7 / int(0 * x)", "line 2\nA whole number is divided by 0"),
        ("while true:\nprint(x)", "line 2\ndot does not come to an end for"),
        ("return x * other.x +", "line 2\nGodot says: Expected expression"),
        ("return OS.kill(1)", "line 2\nOS is the engine's"),
    ],
)
def test_a_mistake_that_is_typed_becomes_a_sentence_and_the_page_lives(code, body, sentence):
    code.type(UNTYPED + body)
    code.read(sentence)
    assert code.lives()
    # What was stopped has broken nothing.
    code.type(DOT + "return x * other.x + y * other.y")
    code.read("dot is right")


def test_a_flood_of_prints_is_cut_short(code):
    code.paste(DOT + "\tfor i in 50000:\n\t\tprint('number ', i)\n\treturn x * other.x + y * other.y\n")
    code.read("dot is right")
    code.read("number 5\n… and \\d+ lines more")
    assert code.lives()


def test_memory_is_not_filled(code):
    code.paste(DOT + "\tvar text := 'a'\n\twhile true:\n\t\ttext += text\n\treturn 0.0\n")
    code.read("dot takes too much memory for")
    assert code.lives()


def test_loading_again_keeps_each_text_by_itself(code):
    code.type(DOT + "return x * other.x - y * other.y")
    code.page.reload()
    code.page.wait_for_function("document.documentElement.dataset.firstFrame", timeout=START_MS)
    code.read("The two products are subtracted")
    code.choose(4)
    code.read("Write scalar_projection")


def test_back_to_the_stub_can_be_undone(code):
    code.type(DOT + "return x * other.x - y * other.y")
    code.read("The two products are subtracted")
    # The button, and the one that undoes.
    code.click(276, 667)
    code.read("Write dot")
    code.click(112, 667)
    code.click(46, 667)
    code.read("The two products are subtracted")


def blocks_of(text):
    """The parts of a file that stand at its edge: each function, class or variable with the comment above it."""
    blocks, block = [], []
    for line in text.splitlines():
        goes_on = not line.strip() or line[0] in "\t )" or (block and block[-1].startswith(("#", "@")))
        if not goes_on and any(not each.startswith(("#", "@")) for each in block):
            blocks.append("\n".join(block).strip("\n"))
            block = []
        block.append(line)
    return blocks + ["\n".join(block).strip("\n")]


def written_in(hand_in, file, about):
    """What the student has written in a file, by the exercises: all that is not as in the starter."""
    given = (STARTERS / f"{file}.gd").read_text()
    known = set(blocks_of(given))
    path = HAND_INS / hand_in / f"{file}.gd"
    if not path.exists():
        return {}
    text = path.read_bytes().decode("utf-8-sig").replace("\r\n", "\n")
    own = [block for block in blocks_of(text) if block not in known and not block.startswith(("class_name", "extends", "var x", "var y"))]
    texts = {}
    # What belongs to no exercise, such as a method that helps, stands with the one that the hand-in is about.
    first = about if FILES[about] == file else min(number for number in FILES if FILES[number] == file)
    for block in own:
        exercise = re.search(r"^## Exercise (\d+):", block, re.MULTILINE)
        number = int(exercise[1]) if exercise else first
        texts[number] = texts.get(number, "") + block + "\n\n\n"
    return texts


def table():
    rows = {}
    with open(HAND_INS / "expected.csv", newline="") as file:
        for row in csv.DictReader(file):
            if row["hand-in"] not in NO_METHODS:
                rows.setdefault(row["hand-in"], []).append(row)
    return rows


# All of them take a quarter of an hour: HAND_INS has the names of others than one of a dozen, or is "all".
TABLE = table()
WANTED = os.environ.get("HAND_INS", "").split()
CHOSEN = list(TABLE) if WANTED == ["all"] else WANTED or list(TABLE)[::12]


def test_the_verdicts_on_hand_ins_are_those_of_the_command(context, site):
    code = CodePage(context.new_page(), site)
    code.open_exercise(0)
    different = []
    for hand_in in CHOSEN:
        texts = {}
        for file in dict.fromkeys(FILES.values()):
            texts |= written_in(hand_in, file, int(TABLE[hand_in][0]["exercise"]))
        code.page.evaluate(
            """texts => { for (let n = 0; n < 16; n++) localStorage.removeItem(`vec2_lab_code_${n}`);
            for (const n in texts) if (texts[n]) localStorage[`vec2_lab_code_${n}`] = texts[n]; }""",
            {str(number): text for number, text in texts.items()},
        )
        code.click(*FIELD)
        code.check()
        for row in TABLE[hand_in]:
            code.choose(int(row["exercise"]))
            told = code.verdict()
            mistake = int(row["mistake"])
            is_same = row["words"] in told and (f"mistake {mistake}\n" in told if mistake > 0 else "mistake" not in told)
            if not is_same or told[0] != SIGNS.get(row["verdict"], "✗"):
                different.append(f"{hand_in}, exercise {row['exercise']}: {told!r}, not {list(row.values())[2:]}")
    code.close()
    assert not different, "\n".join(different)
