"""The mass matrix of Eq. 19 and its inverse."""


def mass_matrix(
    M: "float[:,:]", m: float, I: "float[:]", I_products: "float[:]", r_g: "float[:]", added_mass: "float[:]",
    added_inertia: "float[:]",
) -> None:
    """M = M_RB + M_A about the body origin (Eq. 19)."""
    for i in range(6):
        for j in range(6):
            M[i, j] = 0.0
    for i in range(3):
        M[i, i] = m + added_mass[i]
        M[3 + i, 3 + i] = I[i] + added_inertia[i]
    M[3, 4] = I_products[0]
    M[4, 3] = I_products[0]
    M[3, 5] = I_products[1]
    M[5, 3] = I_products[1]
    M[4, 5] = I_products[2]
    M[5, 4] = I_products[2]
    # Coupling -m S(r_g) of translation with rotation.
    M[0, 4] = m * r_g[2]
    M[0, 5] = -m * r_g[1]
    M[1, 3] = -m * r_g[2]
    M[1, 5] = m * r_g[0]
    M[2, 3] = m * r_g[1]
    M[2, 4] = -m * r_g[0]
    for i in range(3):
        for j in range(3):
            M[3 + i, j] = M[j, 3 + i]


def inverse(A: "float[:,:]", A_inv: "float[:,:]", work: "float[:]") -> None:
    """A_inv = A^-1, 6 by 6, by Gauss-Jordan without pivoting, which a positive definite matrix does not need."""
    for i in range(6):
        for j in range(6):
            work[6 * i + j] = A[i, j]
            A_inv[i, j] = 0.0
        A_inv[i, i] = 1.0
    for i in range(6):
        pivot = work[7 * i]
        for j in range(6):
            work[6 * i + j] = work[6 * i + j] / pivot
            A_inv[i, j] = A_inv[i, j] / pivot
        for n in range(6):
            if n != i:
                factor = work[6 * n + i]
                for j in range(6):
                    work[6 * n + j] = work[6 * n + j] - factor * work[6 * i + j]
                    A_inv[n, j] = A_inv[n, j] - factor * A_inv[i, j]
