"""A link opens the board that it describes; a wrong link gets a message, and the board opens at its start."""

LINK = "#dot_product?a=3,1&b=8,-6"


def test_a_link_opens_a_board(demo):
    demo.start("dot_product", LINK)
    demo.read(r"a = \(3, 1\)")


def test_a_link_opens_a_board_of_the_whole_lab(demo):
    demo.start("lab", LINK)
    demo.read(r"a = \(3, 1\)")


def test_a_link_asks_for_a_language_that_the_demo_speaks(demo):
    demo.start("dot_product", "#dot_product?lang=nl")
    demo.read(r"Stap 1 van \d")


def test_a_link_that_makes_no_sense_is_told(demo):
    demo.start("dot_product", "#dot_product?a=7,one")
    demo.read(r"This link cannot be opened: .*one")
    demo.read(r"a = \(7, 1\)")


def test_a_link_to_no_lesson_is_told(demo):
    demo.start("lab", "#dot_prodct")
    demo.read(r"There is no lesson “dot_prodct”")


def test_another_link_is_followed_without_loading_the_page_again(demo):
    demo.start("dot_product")
    demo.page.evaluate(f"location.hash = '{LINK}'")
    demo.read(r"a = \(3, 1\)")
