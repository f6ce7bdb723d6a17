"""Small square matrices."""

from ..declare.record import Matrix, Vector


def invert(A: Matrix, A_inv: Matrix, size: int) -> None:
    """A_inv = A^-1 by Gauss-Jordan without pivoting, which a positive definite matrix does not need; A is used up."""
    for i in range(size):
        for j in range(size):
            A_inv[i, j] = 0.0
        A_inv[i, i] = 1.0
    for i in range(size):
        pivot = A[i, i]
        for j in range(size):
            A[i, j] = A[i, j] / pivot
            A_inv[i, j] = A_inv[i, j] / pivot
        for k in range(size):
            if k != i:
                factor = A[k, i]
                for j in range(size):
                    A[k, j] = A[k, j] - factor * A[i, j]
                    A_inv[k, j] = A_inv[k, j] - factor * A_inv[i, j]


def solve(A: Matrix, b: Vector, size: int) -> None:
    """b becomes A^-1 b for a positive definite A, which needs no pivoting; A is used up."""
    for i in range(size):
        for k in range(i + 1, size):
            factor = A[k, i] / A[i, i]
            for j in range(i + 1, size):
                A[k, j] = A[k, j] - factor * A[i, j]
            b[k] = b[k] - factor * b[i]
    for m in range(size):
        i = size - 1 - m
        total = b[i]
        for j in range(i + 1, size):
            total = total - A[i, j] * b[j]
        b[i] = total / A[i, i]


def of_blocks(M: Matrix, upper: Matrix, coupling: Matrix, lower: Matrix) -> None:
    """The symmetric 6 by 6 matrix of two diagonal blocks and the upper right one."""
    for i in range(3):
        for j in range(3):
            M[i, j] = upper[i, j]
            M[i, 3 + j] = coupling[i, j]
            M[3 + i, j] = coupling[j, i]
            M[3 + i, 3 + j] = lower[i, j]


def multiply(size: int, A: Matrix, B: Matrix, C: Matrix) -> None:
    """C = A B for the leading square blocks."""
    for i in range(size):
        for j in range(size):
            total = 0.0
            for k in range(size):
                total = total + A[i, k] * B[k, j]
            C[i, j] = total


def rows_times(out: Vector, A: Matrix, first: int, last: int, v: Vector, size: int) -> None:
    """The product of the rows first .. last-1 of A with a vector of `size` components."""
    for r in range(first, last):
        total = 0.0
        for j in range(size):
            total = total + A[r, j] * v[j]
        out[r - first] = total
