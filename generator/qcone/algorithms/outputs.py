"""Attitude in other forms: Euler angles in two conventions, and the quaternion of a direction cosine matrix.

Euler angles come from half sums and half differences of the quaternion's components (angles halved below):
zyx, C = Rz(yaw) Ry(pitch) Rx(roll):
  (yaw + roll)/2 = atan2(z + x, w - y), (yaw - roll)/2 = atan2(z - x, w + y),
  tan(pitch/2 + pi/4) = |(w + y, z - x)| / |(w - y, z + x)|
zxy, C = Rz(yaw) Rx(pitch) Ry(roll):
  (yaw + roll)/2 = atan2(z + y, w + x), (yaw - roll)/2 = atan2(z - y, w - x),
  tan(pitch/2 + pi/4) = |(w + x, z + y)| / |(w - x, z - y)|
At the poles only one of sum and difference is determined, and that one to full accuracy: the attitude that the
three angles stand for is right everywhere, where cao (16) by arctan and arcsin loses half the digits.
"""

from __future__ import annotations

from qcone.ir.real import (
    PI,
    F,
    Matrix,
    Quaternion,
    Scalar,
    Vector,
    arctangent_2,
    heading,
    less,
    named,
    number,
    quaternion,
    ratio,
    reciprocal_root,
    select,
    sine_cosine,
    square_root,
    square_root_of_unit,
    step,
    vector,
    wide,
    within,
)

ABOVE_HALF_PI = F(15708, 10**4)
ABOVE_ONE = F(129, 128)


def euler_angles(q: Quaternion, convention: str) -> Vector:
    """Write roll, pitch, yaw of an attitude quaternion of any length, rad; roll and yaw in [-pi, pi]."""
    w, x, y, z = q
    if convention == "zyx":
        sum_y, sum_x, difference_y, difference_x = z + x, w - y, z - x, w + y
        up_y, up_x, down_y, down_x = difference_y, difference_x, sum_y, sum_x
    else:
        sum_y, sum_x, difference_y, difference_x = z + y, w + x, z - y, w - x
        up_y, up_x, down_y, down_x = sum_y, sum_x, difference_y, difference_x
    half_sum = step("half_sum = (yaw + roll)/2", convention, arctangent_2(sum_y, sum_x))
    half_difference = step("half_difference = (yaw - roll)/2", convention, arctangent_2(difference_y, difference_x))
    up = step("up = square of the numerator of tan(pitch/2 + pi/4)", "", up_x * up_x + up_y * up_y)
    down = step("down = square of its denominator", "", down_x * down_x + down_y * down_y)
    pitch = step("pitch = 2 atan(sqrt(up/down)) - pi/2", convention, _pitch(up, down))
    roll = step("roll = half_sum - half_difference, in [-pi, pi]", "", wrapped(half_sum - half_difference))
    yaw = step("yaw = half_sum + half_difference, in [-pi, pi]", "", wrapped(half_sum + half_difference))
    return vector(roll, pitch, yaw)


def _pitch(up: Scalar, down: Scalar) -> Scalar:
    if up.builder.writing.fixed:
        # The squares are kept in double words: roots of single ones would lose half the digits at the poles.
        angle = arctangent_2(square_root(wide(F(1, 4) * up)), square_root(wide(F(1, 4) * down)))
        return within(angle + angle - PI / 2, -ABOVE_HALF_PI, ABOVE_HALF_PI)
    above = less(down, up)
    square = ratio(select(above, down, up), select(above, up, down))
    angle = arctangent_2(square_root_of_unit(square), number(1, up))
    from_pole = PI / 2 - (angle + angle)
    return select(above, from_pole, -from_pole)


def wrapped(angle: Scalar) -> Scalar:
    """Write an angle of at most 2 pi in size as one of at most pi."""
    most = 2 * ABOVE_HALF_PI
    angle = within(select(less(number(PI, angle), angle), angle - 2 * PI, angle), -2 * most, most)
    return within(select(less(angle, -PI), angle + 2 * PI, angle), -most, most)


def quaternion_of(c: Matrix) -> Quaternion:
    """Write the quaternion of a direction cosine matrix by Shepperd's rule: the largest component first.

    Its four-fold square lies in [1, 4], so a polynomial and two Newton steps give the reciprocal root.
    """
    c11, c12, c13, c21, c22, c23, c31, c32, c33 = c
    xx, yy, zz = c11 - c22 - c33 + 1, c22 - c11 - c33 + 1, c33 - c11 - c22 + 1
    trace = named("trace", c11 + c22 + c33)
    ww = named("ww", trace + 1)
    wx, wy, wz = named("wx", c32 - c23), named("wy", c13 - c31), named("wz", c21 - c12)
    xy, xz, yz = named("xy", c12 + c21), named("xz", c13 + c31), named("yz", c23 + c32)
    heading("ww = 4 w w, wx = 4 w x and so on", "Shepperd 1978", c)
    largest, parts = ww, (ww, wx, wy, wz)
    for size, others in ((xx, (wx, xx, xy, xz)), (yy, (wy, xy, yy, yz)), (zz, (wz, xz, yz, zz))):
        better = less(largest, size)
        largest = select(better, size, largest)
        first, second, third, fourth = (select(better, a, b) for a, b in zip(others, parts, strict=True))
        parts = (first, second, third, fourth)
    largest = step("largest = the greatest of 4 w w, 4 x x, 4 y y, 4 z z", "Shepperd 1978", largest)
    scale = step("scale = 1/(2 sqrt(largest))", "", F(1, 2) * reciprocal_root(largest))
    w, x, y, z = (within(scale * part, -ABOVE_ONE, ABOVE_ONE) for part in parts)
    return step("q_nb = scale (its row)", "Shepperd 1978", quaternion(w, vector(x, y, z)))


def quaternion_of_angles(angles: Vector, convention: str) -> Quaternion:
    """Write the quaternion of roll, pitch, yaw: the product of three rotations about axes."""
    half_roll, half_pitch, half_yaw = (F(1, 2) * angle for angle in angles)
    (sr, cr), (sp, cp), (sy, cy) = (sine_cosine(angle) for angle in (half_roll, half_pitch, half_yaw))
    if convention == "zyx":
        w, x = cy * cp * cr + sy * sp * sr, cy * cp * sr - sy * sp * cr
        y, z = cy * sp * cr + sy * cp * sr, sy * cp * cr - cy * sp * sr
    else:
        w, x = cy * cp * cr - sy * sp * sr, cy * sp * cr - sy * cp * sr
        y, z = cy * cp * sr + sy * sp * cr, sy * cp * cr + cy * sp * sr
    return step(f"q_nb = quaternion of roll, pitch, yaw ({convention})", "", quaternion(w, vector(x, y, z)))
