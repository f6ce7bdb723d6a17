"""Binary variables: bytes of any size and content are set, connected, recorded and read back as they are."""

from __future__ import annotations

import base64
import json
from pathlib import Path

import h5py
import numpy as np
import pytest
from arrays_build import bytes_fmu
from helpers import edited, plan_of, read_system, rovbrush, run_of
from native_build import built, needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.exchange.container import write_container
from rovbrush.orchestrator.fmu.binary import bytes_of
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.results.result import Result
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.ssp.write import write_ssp

pytestmark = needs_gcc

DATA, KEY = b"\x00\xff\x10", b"\x01"


@pytest.fixture(scope="module")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("bytes")
    bytes_fmu(folder / "bytes.fmu")
    bytes_fmu(folder / "other.fmu", mime="image/png")
    built(folder)
    return folder


def changed(data: bytes, key: bytes, steps: int) -> bytes:
    """What the FMU makes of its data behind so many steps."""
    return bytes(x ^ key[k % len(key)] for k, x in enumerate(data)) + b"\xee" * (steps % 4)


@pytest.mark.parametrize("isolation", ["none", "process"])
@pytest.mark.parametrize("interpreted", [False, True])
def test_bytes_of_changing_size_are_recorded_row_by_row(
    interpreted: bool, isolation: str, fmus: Path, tmp_path: Path
) -> None:
    more = {"of": {"a": {"isolation": isolation}}} if isolation != "none" else {}
    values = {"=data": "00 ff 00 80", "key": "0102", "=pair_in": ["", "c0ffee"]}
    run = run_of(tmp_path, fmus, {"a": ("bytes", "1 ms", values)}, stop="9 ms", interpreted=interpreted, **more)
    found = Result(run)
    assert found["a.out"].values.tolist() == [changed(b"\0\xff\0\x80", b"\1\2", k) for k in range(10)]
    assert found["a.out too"].values[-1] == found["a.out"].values[-1]
    assert found["a.pair_out[1]"].values[-1] == b"\xc0\xff\xee" and found["a.pair_out[2]"].values[-1] == b""
    assert found["a.size"].values[-1] == 4


@pytest.mark.parametrize("interpreted", [False, True])
def test_bytes_cross_connections_unchanged(interpreted: bool, fmus: Path, tmp_path: Path) -> None:
    parts = {"a": ("bytes", "1 ms"), "b": ("bytes", "1 ms", {"key": "00"})}
    run = run_of(tmp_path, fmus, parts, ["a.out -> b.data", "a.pair_out -> b.pair_in"], stop="6 ms",
                 algorithm="jacobi", interpreted=interpreted)  # fmt: skip
    sent, got = Result(run)["a.out"].values, Result(run)["b.out"].values
    taken = [sent[0], *sent[:-1]]  # b samples: what it is given at the beginning of a step
    assert Result(run)["b.data"].values.tolist() == taken
    assert got.tolist() == [x + b"\xee" * (k % 4) for k, x in enumerate(taken)]
    assert Result(run)["b.pair_out[1]"].values[-1] == b"\xaa"


@pytest.mark.parametrize(
    ("text", "value"),
    [("", b""), ("00ff", b"\0\xff"), (" 00 FF ", b"\0\xff"), ("base64:AP8=", b"\0\xff"), (b"\0", b"\0")],
)
def test_bytes_are_written_in_hexadecimal_or_base64(text: object, value: bytes) -> None:
    assert bytes_of(text, "x") == value


@pytest.mark.parametrize("text", ["0", "0x00", "zz", "base64:A", "base64:???", 5])
def test_what_is_no_bytes_is_an_error_that_says_how_to_write_them(text: object) -> None:
    with pytest.raises(InputError, match="is no binary value: write it in hexadecimal"):
        bytes_of(text, "a.data")


def test_bytes_come_from_files_beside_the_system(fmus: Path, tmp_path: Path) -> None:
    (tmp_path / "picture.bin").write_bytes(bytes(range(256)))
    system = read_system(tmp_path, fmus, {"a": ("bytes", "1 ms", {"=data": "file:picture.bin"})})
    assert system.components["a"].inputs["data"] == bytes(range(256))
    with pytest.raises(InputError, match=r"nothing\.bin cannot be read: No such file"):
        read_system(tmp_path, fmus, {"a": ("bytes", "1 ms", {"=data": "file:nothing.bin"})})


def test_files_of_results_hold_bytes_as_hexadecimal_and_give_them_back(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "out"
    encoded = "base64:" + base64.b64encode(b"\0\1,\n").decode()
    sets = ["--set", f"data={encoded}", "--set", "key=ff", "--period", "1 ms", "--stop", "3 ms"]
    assert rovbrush(monkeypatch, "run", fmus / "bytes.fmu", *sets, "--out", out) == 0
    with h5py.File(out / "result.nc") as file:
        stored = file["every_1_ms"]["bytes.out"]
        assert stored.attrs["written_as"] in ("hexadecimal", b"hexadecimal")
        assert stored.asstr()[-1] == changed(b"\0\1,\n", b"\xff", 3).hex()
    assert Result.open(out)["bytes.out"].values[-1] == changed(b"\0\1,\n", b"\xff", 3)
    assert changed(b"\0\1,\n", b"\xff", 3).hex() in (out / "result.csv").read_text()
    told = json.loads((out / "manifest.json").read_text())["components"]["bytes"]
    assert told["inputs"]["data"] == "00012c0a" and told["parameters"]["key"] == "ff"


def test_rows_that_went_to_disk_are_the_same(fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from rovbrush.orchestrator.run.recording import recorder

    plan = plan_of(tmp_path, fmus, {"a": ("bytes", "1 ms")}, stop="50 ms")
    whole = Result(simulate(plan))["a.out"].values.tolist()
    monkeypatch.setattr(recorder, "IN_MEMORY", 1000)
    monkeypatch.setattr(recorder, "PIECE", 500)
    with Session(plan, file=tmp_path / "rows.nc") as session:
        session.advance()
        run = session.run()
        assert not isinstance(run.recorded, list)
        assert Result(run)["a.out"].values.tolist() == whole
        assert (run.tables[0][:, 0] == simulate(plan).tables[0][:, 0]).all()


def test_a_session_sets_and_reads_bytes(fmus: Path, tmp_path: Path) -> None:
    with Session(plan_of(tmp_path, fmus, {"a": ("bytes", "1 ms", {"key": "00"})}, stop="5 ms")) as session:
        session.set("a.data", b"\0abc\0")
        session.set("a.pair_in", ["", "00"])
        session.advance(cycles=1)
        assert session.get("a.out") == b"\0abc\0\xee" and session.get("a.pair_out") == [b"\0", b""]
        assert session.set_by_hand["a.data"] == b"\0abc\0".hex()
        with pytest.raises(InputError, match=r"a\.limited: 5 bytes are too many: 4 are allowed \(maxSize\)"):
            session.set("a.limited", b"12345")


@pytest.mark.parametrize("interpreted", [False, True])
@pytest.mark.parametrize("fault", [1, 2])
def test_sizes_that_cannot_be_end_the_run_and_rows_are_kept(
    fault: int, interpreted: bool, fmus: Path, tmp_path: Path
) -> None:
    run = simulate(plan_of(tmp_path, fmus, {"a": ("bytes", "1 ms", {"fault": fault})}, stop="9 ms"), interpreted)
    assert "component a: there is no room for another value of output out" in run.failure
    assert run.end == 0.002 and Result(run)["a.out"].values.tolist() == [changed(DATA, KEY, k) for k in range(3)]


@pytest.mark.parametrize(
    ("wire", "words"),
    [
        ("a.out -> c.data", r"application/x-own and image/png are different kinds of data \(mimeType\)"),
        ("a.out -> d.String_in", r"there is no conversion between them"),
        ("d.String_out -> a.data", r"there is no conversion between them"),
        ("a.out -> b.data (mean)", r"mean"),
    ],
)
def test_bytes_that_mean_something_else_are_not_connected(wire: str, words: str, fmus: Path, tmp_path: Path) -> None:
    parts = {name: (fmu, "1 ms") for name, fmu in zip("abcd", ("bytes", "bytes", "other", "feedthrough3"), strict=True)}
    with pytest.raises(InputError, match=words):
        plan_of(tmp_path, fmus, parts, [wire])


def test_values_survive_an_ssp(fmus: Path, tmp_path: Path) -> None:
    system = read_system(tmp_path, fmus, {"a": ("bytes", "1 ms", {"key": "0aff"}), "b": ("bytes", "1 ms")},
                         ["a.out -> b.data"], stop="5 ms")  # fmt: skip
    for version in ("1.0", "2.0"):
        again = load_system(str(write_ssp(system, tmp_path / f"{version}.ssp", version)))
        assert again.components["a"].parameters["key"] == b"\x0a\xff"
        assert [c.label for c in again.connections] == ["a.out -> b.data"]


def test_start_values_that_are_no_bytes_are_passed_over_and_noted(fmus: Path, tmp_path: Path) -> None:
    bad = edited(fmus / "bytes.fmu", tmp_path / "bad.fmu", {}, {'value="00ff10"': 'value="xyz"'})
    fmu = Fmu.open(bad)
    assert fmu.start("data") == b"" and "start='xyz'" in " ".join(note.found for note in fmu.notes)


def test_bytes_in_a_table_are_refused(fmus: Path, tmp_path: Path) -> None:
    table = {"time": [0.0, 1.0], "values": [0.0, 1.0]}
    with pytest.raises(InputError, match="an input of type Binary takes one value, no series"):
        read_system(tmp_path, fmus, {"a": ("bytes", "1 ms", {"=data": table})})


def test_values_are_objects_of_bytes_in_a_dataset(fmus: Path, tmp_path: Path) -> None:
    found = Result(run_of(tmp_path, fmus, {"a": ("bytes", "1 ms")}, stop="2 ms")).dataset["a.out"]
    assert found.dtype == np.dtype(object) and isinstance(found.values[0], bytes)


def test_a_container_names_what_it_cannot_pass_on(fmus: Path, tmp_path: Path) -> None:
    parts = {
        '<Binary name="pair_out" valueReference="4" causality="output"><Dimension start="2"/></Binary>': "",
        '<Output valueReference="4" dependencies="3"/>': "",
        '<InitialUnknown valueReference="4" dependencies="3"/>': "",
    }
    edited(fmus / "bytes.fmu", tmp_path / "scalar.fmu", {}, parts)
    system = read_system(tmp_path, tmp_path, {"a": ("scalar.fmu", "1 ms")})
    with pytest.raises(InputError, match=r"component a: out is Binary, which a container cannot pass on"):
        write_container(system, tmp_path / "out.fmu")
