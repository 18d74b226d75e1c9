"""What is made of an attitude quaternion: the direction cosine matrix, and the quaternion normalised once."""

from __future__ import annotations

from qcone.ir.real import F, Matrix, Quaternion, cross, dot, matrix, named, recorded_square, shortened, step


def dcm_squares(q: Quaternion) -> Matrix:
    """Write C_nb by squares, cao (5): 12 squares, 6 products doubled, nothing shared: 30 multiplications."""
    a, b, c, d = q
    rows = [
        a * a + b * b - c * c - d * d,
        2 * (b * c - a * d),
        2 * (b * d + a * c),
        2 * (b * c + a * d),
        a * a - b * b + c * c - d * d,
        2 * (c * d - a * b),
        2 * (b * d - a * c),
        2 * (c * d + a * b),
        a * a - b * b - c * c + d * d,
    ]
    return step("c_nb = C_nb(q)", "cao (5)", matrix(rows))


def dcm(q: Quaternion) -> Matrix:
    """Write C_nb for a unit quaternion, cao (15): nine products, the doubling by addition."""
    w, x, y, z = q
    x2, y2, z2 = named("x2", x + x), named("y2", y + y), named("z2", z + z)
    wx, wy, wz = named("wx", w * x2), named("wy", w * y2), named("wz", w * z2)
    xx, xy, xz = named("xx", x * x2), named("xy", x * y2), named("xz", x * z2)
    yy, yz, zz = (
        named("yy", y * y2),
        named("yz", y * z2),
        step("zz = 2 q_z q_z; wx, wy, ... likewise", "cao (15)", z * z2),
    )
    rows = [
        1 - (yy + zz),
        xy - wz,
        xz + wy,
        xy + wz,
        1 - (xx + zz),
        yz - wx,
        xz - wy,
        yz + wx,
        1 - (xx + yy),
    ]
    c = step("c_nb = C_nb(q)", "cao (15)", matrix(rows))
    c.builder.group("matrix", c.values, (q.group,))
    return c


def orthonormalised(c: Matrix) -> Matrix:
    """Write the rows a and b at unit length and right angles, to second order, and their cross product."""
    a, b = c.row(0), c.row(1)
    e_a = step("e_a = (1 - |a|^2)/2", "", F(1, 2) * (1 - dot(a, a)))
    e_b = step("e_b = (1 - |b|^2)/2", "", F(1, 2) * (1 - dot(b, b)))
    e_ab = step("e_ab = a . b", "", dot(a, b))
    top = shortened(a, step("a_next = a + e_a a", "", a + e_a * a))
    middle = shortened(b, step("b_next = b + e_b b - e_ab a", "", b + e_b * b - e_ab * a), crossed=True)
    bottom = step("c_next = a_next x b_next", "", cross(top, middle))
    return matrix([*top, *middle, *bottom])


def normalised(q: Quaternion) -> Quaternion:
    """Write q (3 - |q|^2)/2 as q + e q, e = (1 - |q|^2)/2: one Newton step, no root, no division."""
    w, x, y, z = q
    square = step("q_square = |q|^2", "", w * w + x * x + y * y + z * z)
    recorded_square(square, q)
    e = step("e = (1 - |q|^2)/2", "", F(1, 2) * (1 - square))
    return shortened(q, step("q_next = q + e q", "", q + e * q))
