"""Who is served: tokens, digests, addresses; and what strangers can do at a server."""

from __future__ import annotations

import socket
import threading
from pathlib import Path
from typing import Any

import pytest
from helpers import read_system
from rovbrush.orchestrator.errors import FmuError, InputError
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.elsewhere import greeting
from rovbrush.orchestrator.participant.elsewhere.connection import TOKEN, Connection, token_of
from rovbrush.orchestrator.participant.elsewhere.server import Server
from rovbrush.orchestrator.participant.elsewhere.wire import Wire
from rovbrush.orchestrator.participant.isolated.channel import CALL
from rovbrush.orchestrator.participant.isolated.child_process import ProcessLostError
from rovbrush.orchestrator.sockets import Address, listening, tcp_address
from serving import SERVERS, serving, started, wait_for
from serving import native as native  # a fixture, as the next one is
from serving import quick as quick

pytestmark = SERVERS
WORD, OTHER = "a token of the tests", "quite another token"


@pytest.mark.parametrize(
    ("servers", "masters", "words"),
    [
        (WORD, OTHER, "the server at tcp://.* refused: its token is another one"),
        (WORD, "", "wants a token: give it by token_file or ROVBRUSH_TOKEN"),
        ("", WORD, "has no token; give it this one, or take it away here"),
    ],
)
def test_a_wrong_token_is_refused_by_name(
    servers: str, masters: str, words: str, native: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(TOKEN, masters)
    raises = pytest.raises(FmuError, match=f"component a: .*{words}")
    with serving(native / "feedthrough2.fmu", token=servers) as server, raises:
        started(tmp_path, native, server.address)


def test_the_token_is_that_of_a_file_beside_the_system_and_never_crosses_the_wire(
    native: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    sent: list[bytes] = []
    real = greeting.Channel.send

    def heard(self: greeting.Channel, letter: bytes, body: bytes, *more: Any) -> None:
        sent.append(body)
        real(self, letter, body, *more)

    monkeypatch.setattr(greeting.Channel, "send", heard)
    (tmp_path / "word").write_text(f"{WORD}\n")
    with serving(native / "feedthrough2.fmu", token=WORD) as server:
        started(tmp_path, native, server.address, token_file="word")
        server.says("feedthrough2.fmu runs for")
    assert len(sent) > 3 and not any(WORD.encode() in body for body in sent)
    nonces = [greeting.from_json(body)["nonce"] for body in sent if b'"nonce"' in body]
    assert len(set(nonces)) == 2


def test_a_proof_that_was_heard_is_worth_nothing_the_next_time() -> None:
    heard = greeting.proof(WORD, "master", "1", "2")
    assert heard not in (greeting.proof(WORD, "master", "3", "2"), greeting.proof(WORD, "server", "1", "2"))


def test_another_fmu_is_refused_with_both_digests(native: Path, tmp_path: Path) -> None:
    with serving(native / "feedthrough3.fmu") as server:
        words = r"it serves feedthrough3\.fmu \(\w{12}\), and the system has feedthrough2\.fmu \(\w{12}\); give both"
        with pytest.raises(FmuError, match=words):
            started(tmp_path, native, server.address)


def test_a_stranger_without_the_token_is_told_nothing_of_the_fmus(native: Path) -> None:
    with serving(native / "feedthrough2.fmu", token=WORD) as server:
        fmu = Fmu.open(native / "feedthrough3.fmu")
        with pytest.raises(FmuError) as error:
            Connection(fmu, "a", server.address, OTHER)
        assert "feedthrough" not in str(error.value)


@pytest.mark.parametrize("garbage", [b"GET / HTTP/1.1\r\n\r\n", bytes(range(256)) * 40, b"", b"cBvR" + 12 * b"\xff"])
def test_garbage_from_strangers_is_refused_and_the_server_goes_on(garbage: bytes, native: Path, tmp_path: Path) -> None:
    with serving(native / "feedthrough2.fmu") as server:
        with socket.create_connection((server.address.host, server.address.port)) as stranger:
            stranger.sendall(garbage)
            stranger.shutdown(socket.SHUT_WR)
            server.says("refused 127.0.0.1:")
        started(tmp_path, native, server.address)


@pytest.mark.parametrize(
    "words",
    [
        b"[]",
        b'{"nonce": 1, "proof": "", "digest": "", "component": ""}',
        b'{"nonce": "\\ud800", "proof": "\\ud800", "digest": "", "component": ""}',
        b'{"nonce": {"base64": 5}}',
        b"[" * 4000,
        b'{"nonce": "", "proof": "", "digest": "x", "component": "' + 3900 * b"a" + b'"}',
    ],
)
def test_wrong_words_in_a_right_message_are_refused_too(words: bytes, native: Path, tmp_path: Path) -> None:
    with serving(native / "feedthrough2.fmu", token=WORD) as server:
        stranger = socket.create_connection((server.address.host, server.address.port))
        Wire(stranger, greeting.LONGEST).send(greeting.LETTER, words, 0)
        server.says("refused 127.0.0.1:")
        stranger.close()


def test_a_server_that_answers_nonsense_is_an_error_that_names_it(native: Path) -> None:
    """One that has greeted as it should."""
    fmu = Fmu.open(native / "feedthrough2.fmu")
    for answer in (b"[]", b"{}", b'{"ok"', b'{"error": 5}'):
        with listening("127.0.0.1", 0, "") as listener:

            def speak(listener: socket.socket = listener, answer: bytes = answer) -> None:
                wire = Wire(listener.accept()[0], 1 << 20)
                greeting.welcome(wire, "", {fmu.digest: "f.fmu"}, lambda: "")
                number, letter, _ = wire.receive()
                wire.send(letter, answer, number)

            thread = threading.Thread(target=speak)
            thread.start()
            there = Connection(fmu, "a", Address("127.0.0.1", listener.getsockname()[1]), "")
            with pytest.raises(ProcessLostError, match=r"the server at tcp://\S+ sent what is no answer"):
                there.ask(b"J", b"[]", 10.0)
            thread.join()
            there.close()


def test_strangers_who_say_nothing_keep_nobody_out(
    native: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(greeting, "PATIENCE", 1.0)
    with serving(native / "feedthrough2.fmu", most=1) as server:
        where = (server.address.host, server.address.port)
        silent = [socket.create_connection(where) for _ in range(3)]
        started(tmp_path, native, server.address)
        wait_for(lambda: "all" if sum("did not say who it is" in line for line in server.said) == 3 else "", "refused")
        for stranger in silent:
            stranger.close()


@pytest.mark.parametrize(
    "call",
    [
        CALL.pack(999, 0, 0, 0.0, 0.0, False),
        CALL.pack(0, 1, 1, 0.0, 0.0, False),
        CALL.pack(0, 1 << 60, 1 << 60, 0.0, 0.0, False) + 64 * b"\0",
        b"\0",
    ],
    ids=["no function", "no values", "many values", "no call"],
)
def test_a_call_that_no_master_makes_ends_its_own_instance_alone(call: bytes, native: Path, tmp_path: Path) -> None:
    fmu = Fmu.open(native / "feedthrough2.fmu")
    with serving(fmu.path) as server:
        there = Connection(fmu, "a", server.address, "")
        there.wire.ask(b"J", greeting.to_json(["start", fmu.kind, None, "all", None]), 60.0)
        with pytest.raises(ProcessLostError, match="what came is no call of a master at tcp://"):
            there._answer(b"F", call, 60.0)
        there.close()
        started(tmp_path, native, server.address)


# --- addresses, ports, files ---


def test_where_nobody_listens_the_error_says_what_to_start(native: Path, tmp_path: Path) -> None:
    free = listening("127.0.0.1", 0, "")
    port = free.getsockname()[1]
    free.close()
    words = rf"component a: nobody answers at .*{port} .*; start `rovbrush serve feedthrough2\.fmu --port {port}`"
    with pytest.raises(FmuError, match=words):
        started(tmp_path, native, Address("127.0.0.1", port))


@pytest.mark.parametrize(
    ("says", "words"),
    [(b"", "did not greet within"), (b"220 mail ready, how do you do?\r\n", "is no `rovbrush serve`")],
)
def test_what_listens_and_is_no_server_is_named_as_that(
    says: bytes, words: str, native: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(greeting, "PATIENCE", 0.3)
    with listening("127.0.0.1", 0, "") as listener:
        taken: list[socket.socket] = []

        def answer() -> None:
            taken.append(listener.accept()[0])
            taken[0].sendall(says)

        threading.Thread(target=answer).start()
        with pytest.raises(FmuError, match=f"component a: what listens at tcp://.* {words}"):
            started(tmp_path, native, Address("127.0.0.1", listener.getsockname()[1]))
        taken[0].close()


def test_a_port_in_use_and_a_host_that_others_reach_are_refused(native: Path) -> None:
    fmu = Fmu.open(native / "feedthrough2.fmu")
    with listening("127.0.0.1", 0, "") as taken:
        port = taken.getsockname()[1]
        with pytest.raises(InputError, match=rf"port {port} of 127\.0\.0\.1 is in use; choose another by --port"):
            Server([fmu], "127.0.0.1", port, "", 1, print)
    for host in ("0.0.0.0", "::", "192.0.2.7"):
        with pytest.raises(InputError, match="others reach it, and there is no token; give one of at least 16"):
            Server([fmu], host, 0, "", 1, print)
    with pytest.raises(InputError, match="a port is 1 to 65535"):
        Server([fmu], "127.0.0.1", 70000, "", 1, print)


@pytest.mark.parametrize(
    "text",
    ["tcp://", "tcp://host", "tcp://host:0", "tcp://host:99999", "tcp://host:x", "tcp://:7400", "tcp://a:b@host:1",
     "tcp://host:7400/fmu", "tcp://[::1:7400", "tcp://host:7400?x=1"],
)  # fmt: skip
def test_what_is_no_address_is_refused_with_its_line(text: str, native: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"component a: isolation = .* is no address.*case\.toml, line \d+"):
        started(tmp_path, native, text)


def test_addresses_are_read_as_they_are_written() -> None:
    for text in ("tcp://127.0.0.1:7400", "tcp://[::1]:7400", "tcp://rig.example:1"):
        assert str(tcp_address(text)) == text


@pytest.mark.parametrize(
    ("content", "words"),
    [(None, "cannot be read: No such file"), (b"", "the file is empty"), (b"short\n", "at least 16 characters, not 5"),
     (b"\xff" * 20, "cannot be read")],
)  # fmt: skip
def test_a_token_file_that_holds_none_is_refused(content: bytes | None, words: str, tmp_path: Path) -> None:
    path = tmp_path / "word"
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(InputError, match=words):
        token_of(path, "--token-file")


def test_a_token_file_without_a_server_is_refused(native: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match='token_file needs isolation = "tcp://HOST:PORT"'):
        read_system(tmp_path, native, {"a": ("feedthrough2", "1 ms", {"=u": 1.0})}, of={"a": {"token_file": "word"}})
