"""The independent oracle: attitude algorithms and motions written by hand in float64.

Nothing here is derived from, or shared with, the code that generates firmware: the package imports NumPy and
the standard library only, coefficient tables are typed in from the literature, and every function is the
textbook formula. It judges the rest, so it must not depend on it.

Conventions: quaternions are scalar first, Hamilton product, body to navigation frame;
q' = 1/2 q (x) (0, omega) and q_{k+1} = q_k (x) r_k; angles in rad, rates in rad/s, times in s.
Arrays may carry leading batch dimensions.
"""
