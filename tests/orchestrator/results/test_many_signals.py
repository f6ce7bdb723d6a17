"""Ten thousand signals are ten thousand variables of netCDF, and take little more room than their numbers."""

from __future__ import annotations

import time
from pathlib import Path

import h5py
import numpy as np
import pytest
import xarray
from cells_fmu import cells, scalar
from helpers import Measured, run_of
from native_build import needs_gcc
from rovbrush.orchestrator.results.files.netcdf import TIME, write_netcdf
from rovbrush.orchestrator.results.files.rows_file import RowsFile
from rovbrush.orchestrator.results.opened import open_tables
from rovbrush.orchestrator.results.tables import Run

pytestmark = needs_gcc
ROWS = 101


def many(folder: Path, signals: int) -> Run:
    """A run that records so many outputs, each its number everywhere."""
    variables = [scalar("u", 0, "input", start="0")]
    variables += [scalar(f"block[{k}].sub.signal_{k}", 100 + k) for k in range(signals)]
    cells(folder / "big.fmu", variables)
    return run_of(folder, folder, {"a": ("big", "1 ms")}, stop="0.1 s")


def test_ten_thousand_signals_take_less_than_twice_the_room_of_their_numbers(
    tmp_path: Path, measured: Measured
) -> None:
    run = many(tmp_path, 10_000)
    begun = time.perf_counter()
    write_netcdf(run, tmp_path / "result.nc")
    measured("result.nc of 10 000 signals x 101 rows, written in [s]", time.perf_counter() - begun, "5 (not asserted)")
    numbers = 8 * run.tables[0].size
    share = (tmp_path / "result.nc").stat().st_size / numbers
    measured("result.nc of 10 000 signals x 101 rows: size over that of the numbers", share, "2")
    assert share < 2
    with h5py.File(tmp_path / "result.nc") as file:
        table = file["every_1_ms"]
        assert len(table) == 10_001
        assert table["a.block[9999].sub.signal_9999"][:].tolist() == [100.0 + 9999] * ROWS
        assert table["a.block[77].sub.signal_77"].dims[0][0] == table["time"]


def test_the_room_of_a_signal_does_not_grow_with_their_number(tmp_path: Path) -> None:
    sizes = []
    for signals in (200, 1600):
        (tmp_path / str(signals)).mkdir()
        write_netcdf(many(tmp_path / str(signals), signals), tmp_path / "result.nc")
        sizes.append((tmp_path / "result.nc").stat().st_size / signals)
    assert sizes[1] < 1.05 * sizes[0]


@pytest.mark.parametrize("chunk", [0, 2])
def test_every_type_and_text_comes_back_by_xarray_and_by_opening(chunk: int, tmp_path: Path) -> None:
    values = {
        "x": np.array([0.1, -np.inf, np.nan]), "f": np.array([0.1, 2, 3], dtype=np.float32),
        "n": np.array([-7, 0, 2**31 - 1], dtype=np.int32), "big": np.array([0, 1, 2**64 - 1], dtype=np.uint64),
        "on": np.array([True, False, True]), "text": np.array(["ü", "", 'a "b"'], dtype=object),
    }  # fmt: skip
    texts = {"x": {"units": "m", "long_name": "long" * 30_000}, "f": {"units": "1", "long_name": ""}}
    file = RowsFile(tmp_path / "some.nc", new=True)
    made = file.create("every_1_ms", "1 ms", True, chunk)
    made.add("time", np.arange(3.0), TIME)
    for name, column in values.items():
        made.add(name, column, texts.get(name, {}))
    file.close()
    with xarray.open_datatree(tmp_path / "some.nc", engine="h5netcdf") as tree:
        read = tree["every_1_ms"].to_dataset().load()
    ours = open_tables(tmp_path / "some.nc")["every_1_ms"]
    for table in (read, ours):
        assert dict(table.attrs) == {"period": "1 ms", "complete": 1} and table["time"].attrs == TIME
        for name, column in values.items():
            found = table[name].values
            assert table[name].attrs == texts.get(name, {}), name
            assert found.tolist() == column.tolist() if name == "text" else found.tobytes() == column.tobytes(), name
            assert name == "text" or found.dtype == column.dtype
