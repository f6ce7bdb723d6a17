"""The READMEs and the kernels name the same equations, with the places where they are computed."""

from __future__ import annotations

import pytest
from rovbrush.components.build import COMPONENTS, HERE
from rovbrush.components.describe import theory
from rovbrush.components.errors import BuildError

NUMBERED = [name for name in COMPONENTS if theory.equations(name)]


def readme(name: str) -> str:
    return (HERE / name / "README.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", NUMBERED)
def test_readme_lists_the_equations_of_the_kernel(name: str) -> None:
    assert readme(name) == theory.with_table(readme(name), name), "run `python -m rovbrush.components.describe`"


@pytest.mark.parametrize("name", NUMBERED)
def test_every_equation_of_a_kernel_is_explained_in_its_readme(name: str) -> None:
    explained = theory.numbers(theory.prose(readme(name)))
    assert {one.number for one in theory.equations(name)} <= set(explained)


@pytest.mark.parametrize("name", COMPONENTS)
def test_every_equation_that_a_readme_names_is_a_line_of_a_kernel(name: str) -> None:
    computed = {one.number for other in COMPONENTS for one in theory.equations(other)}
    assert set(theory.numbers(theory.prose(readme(name)))) <= computed


def test_all_equations_of_the_paper_are_computed() -> None:
    computed = {one.number for name in COMPONENTS for one in theory.equations(name)}
    assert computed >= {str(number) for number in range(2, 22)}


def test_an_equation_that_nothing_explains_is_found() -> None:
    assert theory.numbers("as Eq. 7 and Eqs. 14-16, or Eqs. 2, 3") == ["7", "14", "15", "16", "2", "3"]
    assert theory.numbers("Eq. B2, Eqs. B9-B11 and Eqs. B1 and 4") == ["B2", "B9", "B10", "B11", "B1", "4"]
    with pytest.raises(BuildError, match="put them into the file"):
        theory.with_table("no marks", "dc_motor")
