"""A sweep on a Dask cluster gives the same bits."""

from __future__ import annotations

import socket
from pathlib import Path

import pytest
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.studies.sweep.options import Options
from rovbrush.orchestrator.studies.sweep.sweep import sweep


def test_a_dask_cluster_gives_the_same_bits(case: Path, fmus: Path, tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=1, threads_per_worker=2, dashboard_address=None, silence_logs=50
    ) as cluster:
        there = Options(["w.c0=1:5:5"], scheduler=cluster.scheduler_address, fmus=fmus)
        sweep(str(case), tmp_path / "there", there).require_all()
    sweep(str(case), tmp_path / "here", Options(["w.c0=1:5:5"], workers=1, fmus=fmus)).require_all()
    for name in ("sweep.nc", "sweep.csv"):
        assert (tmp_path / "there" / name).read_bytes() == (tmp_path / "here" / name).read_bytes()


def test_a_stranger_at_the_address_of_the_scheduler_is_an_error_within_seconds(
    case: Path, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("distributed")
    monkeypatch.setattr("rovbrush.orchestrator.studies.sweep.workers.dask.ANSWER", 1.0)
    with socket.create_server(("127.0.0.1", 0)) as silent:
        options = Options(["w.c0=1,2"], scheduler=f"tcp://127.0.0.1:{silent.getsockname()[1]}", fmus=fmus)
        with pytest.raises(InputError, match="does not answer as a Dask scheduler within 1 s"):
            sweep(str(case), tmp_path / "out", options).require_all()
    assert not (tmp_path / "out").exists()
