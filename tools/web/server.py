"""Serves a folder on 127.0.0.1 as a static web host does: right content types, compressed copies where they are accepted.

Usage: server.py FOLDER [PORT]   (without PORT: 8000, or a free one). Prints the address; Ctrl+C ends it.
"""

import functools
import http.server
import os
import sys

USUAL_PORT = 8000

# Endings that need not be in the machine's own list.
TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".json": "application/json",
    ".pck": "application/octet-stream",
    ".wasm": "application/wasm",
    ".webmanifest": "application/manifest+json",
}
# Copies beside a file, the smallest first.
COPIES = {"br": ".br", "gzip": ".gz"}


class Handler(http.server.SimpleHTTPRequestHandler):
    """Files below one folder; the base class keeps paths with `..` inside it."""

    protocol_version = "HTTP/1.1"
    encoding = None
    extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map, **TYPES}

    def send_head(self):
        self.encoding = self._encoding()
        if self.encoding:
            self.path = self.path.partition("?")[0] + COPIES[self.encoding]
        return super().send_head()

    def guess_type(self, path):
        return super().guess_type(path.removesuffix(COPIES.get(self.encoding, "")))

    def end_headers(self):
        if self.encoding:
            self.send_header("Content-Encoding", self.encoding)
        self.send_header("Vary", "Accept-Encoding")
        # A new export must be seen at once: the browser asks whether its copy is still right.
        self.send_header("Cache-Control", "no-cache")
        super().end_headers()

    def list_directory(self, path):
        self.send_error(http.HTTPStatus.NOT_FOUND)

    def log_message(self, format, *args):
        pass

    def log_error(self, format, *args):
        print(f"{self.path}: {format % args}", file=sys.stderr)

    def _encoding(self):
        """The name of a compression that the browser takes and that there is a copy of."""
        path = self.translate_path(self.path)
        accepted = {part.split(";")[0].strip() for part in self.headers.get("Accept-Encoding", "").split(",")}
        for name, ending in COPIES.items():
            if name in accepted and os.path.isfile(path) and os.path.isfile(path + ending):
                return name
        return None


def open_server(folder, port):
    return http.server.ThreadingHTTPServer(("127.0.0.1", port), functools.partial(Handler, directory=folder))


def main():
    folder, port = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else USUAL_PORT
    try:
        server = open_server(folder, port)
    except OSError as error:
        if len(sys.argv) > 2:
            sys.exit(f"lab: port {port} cannot be used ({error.strerror}); './lab serve' alone finds a free one")
        server = open_server(folder, 0)
    print(f"lab: http://127.0.0.1:{server.server_port}/ (Ctrl+C ends it)", flush=True)
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        print()


if __name__ == "__main__":
    main()
