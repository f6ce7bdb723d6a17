"""Functions from tables: of one variable, straight between places; of two, smooth, from even steps."""

from ..declare.record import Matrix, Vector


def extend(table: Matrix, rows: int, columns: int) -> None:
    """Go on by cubics one place beyond each side of rows x columns values, which stand from table[1, 1] on.

    Slopes at the sides are then one-sided differences.
    """
    for j in range(1, columns + 1):
        table[0, j] = 4.0 * table[1, j] - 6.0 * table[2, j] + 4.0 * table[3, j] - table[4, j]
        table[rows + 1, j] = (
            4.0 * table[rows, j] - 6.0 * table[rows - 1, j] + 4.0 * table[rows - 2, j] - table[rows - 3, j])
    for i in range(rows + 2):
        table[i, 0] = 4.0 * table[i, 1] - 6.0 * table[i, 2] + 4.0 * table[i, 3] - table[i, 4]
        table[i, columns + 1] = (
            4.0 * table[i, columns] - 6.0 * table[i, columns - 1] + 4.0 * table[i, columns - 2] - table[i, columns - 3])


def cubic(u: float, y_0: float, y_1: float, y_2: float, y_3: float) -> float:
    """Catmull and Rom's cubic between y_1 (u = 0) and y_2 (u = 1), whose slopes are central differences."""
    c_2 = 2.0 * y_0 - 5.0 * y_1 + 4.0 * y_2 - y_3
    c_3 = 3.0 * (y_1 - y_2) + y_3 - y_0
    return y_1 + 0.5 * u * (y_2 - y_0 + u * (c_2 + u * c_3))


def along_row(table: Matrix, i: int, j: int, v: float) -> float:
    """In row i between the columns j + 1 and j + 2."""
    return cubic(v, table[i, j], table[i, j + 1], table[i, j + 2], table[i, j + 3])


def look_up(table: Matrix, x: float, y: float, rows: int, columns: int) -> float:
    """An extended table at x rows and y columns from its first value; beyond its sides the last cubic goes on."""
    i = max(0, min(int(x), rows - 2))
    j = max(0, min(int(y), columns - 2))
    v = y - j
    return cubic(
        x - i, along_row(table, i, j, v), along_row(table, i + 1, j, v), along_row(table, i + 2, j, v),
        along_row(table, i + 3, j, v))


def straight(x: float, places: Vector, values: Vector, count: int) -> float:
    """At x, straight between values at rising places; beyond the ends the first or last value."""
    value = values[0]
    for k in range(count - 1):
        width = places[k + 1] - places[k]
        if x >= places[k + 1]:
            value = values[k + 1]
        elif x > places[k] and width > 0.0:
            part = (x - places[k]) / width
            value = values[k] + part * (values[k + 1] - values[k])
    return value
