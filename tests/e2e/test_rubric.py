"""The page with the rubric: on a phone, too, each of its links leads to something that is there."""

import pytest

from demo_page import DemoPage


@pytest.fixture
def rubric(browser, site):
    context = browser.new_context(viewport={"width": 390, "height": 844})
    page = DemoPage(context.new_page(), site)
    page.open("rubric.html")
    yield page.page
    page.close()
    context.close()


def test_every_link_is_answered(rubric):
    links = {link.evaluate("link => link.href.split('#')[0]") for link in rubric.get_by_role("link").all()}
    assert len(links) > 10
    for link in links:
        assert rubric.request.get(link).ok, link


def test_a_test_is_read_as_text(rubric):
    link = rubric.get_by_role("link", name="Test: test_vec2_reflection.gd").first
    answer = rubric.request.get(link.evaluate("link => link.href"))
    assert answer.headers["content-type"].startswith("text/plain")
    assert "func test_the_reflection_of_the_lecture" in answer.text()


def test_nothing_is_wider_than_a_phone(rubric):
    assert rubric.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
