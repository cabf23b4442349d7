"""Downloads from a server on this computer: whole, or stopped and nothing left."""

import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import pooch
import pytest
from pyvista.examples import downloads as pyvistas

from app.ui.downloads import DownloadCancelledError, Meter, download

PIECE = bytes(4096)
PIECES, MANY = 50, 20_000
FILE = "cow.vtp"
LONG = 20


class Server(ThreadingHTTPServer):
    """Sends a file piece by piece; the second piece and the rest only once it is let."""

    daemon_threads = True

    def __init__(self):
        super().__init__(("127.0.0.1", 0), Sender)
        self.begun, self.go_on, self.ended = (threading.Event() for _ in range(3))
        self.pieces, self.sent = PIECES, 0

    @property
    def url(self):
        return f"http://127.0.0.1:{self.server_address[1]}/"


class Sender(BaseHTTPRequestHandler):
    def do_GET(self):
        server = self.server
        self.send_response(200)
        self.send_header("Content-Length", str(len(PIECE) * server.pieces))
        self.end_headers()
        try:
            for _ in range(server.pieces):
                self.wfile.write(PIECE)
                server.sent += len(PIECE)
                server.begun.set()
                server.go_on.wait(LONG)
        except OSError:  # nobody listens any more
            pass
        server.ended.set()

    def log_message(self, *_):
        """Say nothing."""


@pytest.fixture
def server(monkeypatch, tmp_path):
    monkeypatch.setenv("NO_PROXY", "127.0.0.1")
    server = Server()
    fetcher = pooch.create(path=tmp_path, base_url=server.url, registry={})
    monkeypatch.setattr(pyvistas, "SOURCE", server.url)
    monkeypatch.setattr(pyvistas, "FETCHER", fetcher)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    yield server
    server.go_on.set()
    server.shutdown()
    server.server_close()
    thread.join()


def left(folder):
    """Files of a folder, without the locks that PyVista puts beside them."""
    return [path for path in folder.rglob("*") if path.is_file() and path.suffix != ".lock"]


def test_a_download_is_whole_and_tells_how_far_it_is(server, tmp_path):
    server.go_on.set()
    meter = Meter()
    assert meter.share() is None
    assert download("cow", meter) == str(tmp_path / FILE)
    assert (tmp_path / FILE).stat().st_size == len(PIECE) * PIECES
    assert meter.share() == 1


def test_a_cancelled_download_stops_and_leaves_nothing(server, tmp_path):
    meter, outcome = Meter(), []
    server.pieces = MANY

    def work():
        try:
            outcome.append(download("cow", meter))
        except DownloadCancelledError as error:
            outcome.append(error)

    thread = threading.Thread(target=work)
    thread.start()
    assert server.begun.wait(LONG)
    meter.cancel()
    server.go_on.set()
    thread.join(LONG)
    assert isinstance(outcome[0], DownloadCancelledError)
    assert left(tmp_path) == []
    del outcome[:]  # the error holds on to the connection
    assert server.ended.wait(LONG)
    assert server.sent < len(PIECE) * MANY


def test_what_was_cancelled_is_downloaded_whole_the_next_time(server, tmp_path):
    stopped = Meter()
    stopped.cancel()
    server.go_on.set()
    with pytest.raises(DownloadCancelledError):
        download("cow", stopped)
    assert download("cow", Meter()) == str(tmp_path / FILE)
    assert (tmp_path / FILE).stat().st_size == len(PIECE) * PIECES
