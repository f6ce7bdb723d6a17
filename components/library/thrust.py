"""What thrusters do to a vehicle (Eq. 20), for the vehicle and for the controller's allocation."""

from ..declare.record import Matrix, Vector


def allocation_matrix(B: Matrix, position: Vector, direction: Vector) -> None:
    """B of Eq. 20: column j holds the direction of thruster j and its moment arm, position x direction."""
    for j in range(8):
        p_x = position[3 * j]
        p_y = position[3 * j + 1]
        p_z = position[3 * j + 2]
        d_x = direction[3 * j]
        d_y = direction[3 * j + 1]
        d_z = direction[3 * j + 2]
        B[0, j] = d_x
        B[1, j] = d_y
        B[2, j] = d_z
        B[3, j] = p_y * d_z - p_z * d_y
        B[4, j] = p_z * d_x - p_x * d_z
        B[5, j] = p_x * d_y - p_y * d_x
