"""The server of `./lab serve`: types, compressed copies, nothing outside its folder."""

import http.client

import pytest


@pytest.fixture
def ask(site):
    def ask(path, **headers):
        connection = http.client.HTTPConnection(site.removeprefix("http://"))
        connection.request("GET", path, headers=headers)
        answer = connection.getresponse()
        answer.read()
        connection.close()
        return answer

    return ask


@pytest.mark.parametrize(
    ("path", "kind"),
    [
        ("/", "text/html; charset=utf-8"),
        ("/engine/godot.wasm", "application/wasm"),
        ("/engine/godot.js", "text/javascript; charset=utf-8"),
        ("/dot_product/dot_product.pck", "application/octet-stream"),
        ("/cards/dot_product.png", "image/png"),
        ("/icon.svg", "image/svg+xml"),
        ("/manifest.webmanifest", "application/manifest+json"),
    ],
)
def test_the_kind_of_each_file_is_told(ask, path, kind):
    answer = ask(path)
    assert (answer.status, answer.headers["Content-Type"]) == (200, kind)


def test_who_accepts_it_gets_the_compressed_copy(ask):
    plain = ask("/engine/godot.wasm")
    small = ask("/engine/godot.wasm?again", **{"Accept-Encoding": "deflate, gzip;q=1.0"})
    assert (plain.headers["Content-Encoding"], small.headers["Content-Encoding"]) == (None, "gzip")
    assert small.headers["Content-Type"] == "application/wasm"
    assert int(small.headers["Content-Length"]) < int(plain.headers["Content-Length"]) / 3


def test_a_copy_that_is_still_right_is_not_sent_again(ask):
    seen = ask("/engine/godot.wasm", **{"Accept-Encoding": "gzip"}).headers["Last-Modified"]
    again = ask("/engine/godot.wasm", **{"Accept-Encoding": "gzip", "If-Modified-Since": seen})
    assert again.status == 304


@pytest.mark.parametrize("path", ["/../../../lab", "/%2e%2e/%2e%2e/%2e%2e/lab", "/engine/", "/none.html"])
def test_nothing_outside_and_no_list_of_files_is_told(ask, path):
    assert ask(path).status in (301, 404)
    assert ask(path.rstrip("/") + "/project.godot").status == 404
