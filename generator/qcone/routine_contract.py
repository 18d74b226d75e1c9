"""Contracts of the emitted functions: what stands above each, of its arguments, units, ranges and promises."""

from __future__ import annotations

import textwrap

from qcone import stage_contract
from qcone.contract import WIDTH, Facts, beyond, decimal, digits, rounding, truncation
from qcone.formats.fixed import Fixed
from qcone.ir.statement import Routine


def of_routine(routine: Routine, facts: Facts) -> tuple[str, ...]:
    """Return the contract above a prototype: purpose, arguments with units and ranges, what is promised."""
    ctype, n = facts.number.ctype, facts.algorithm.subsamples
    rates = facts.design.input == "rate"
    text: dict[str, list[str]] = {
        "init": [
            "The attitude is the identity; history and residual are empty.",
            *(["The correction is zero."] if facts.design.rins else []),
        ],
        "set_quaternion": [
            "q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.",
            "One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are cleared.",
            *(["The newest rate is kept: start() need not be called again."] if rates else []),
            *(["The correction is kept."] if facts.design.rins else []),
        ],
        "set_dcm": [
            "c_nb: row major, orthonormal to within the format's rounding; v_n = C_nb v_b.",
            "One Newton step orthonormalises two rows, the third is their cross product. History is cleared.",
        ],
        "set_euler": [
            f"angles: roll, pitch, yaw, rad, each at most pi in size; convention {facts.design.euler}. "
            "History is cleared."
        ],
        "start": ["omega: rad/s, sensor axes. To be called once before the first update."],
        "renormalise": [
            "To be called by the user now and then: a length 1 + e, |e| <= 1/2, becomes 1 within 3/2 e^2 + 1/2 |e|^3.",
            _how_often(facts),
        ],
        "quaternion": [f"q_nb: w, x, y, z; body to navigation. |q_nb| = 1 {_norm(facts)}."],
        "dcm": [f"c_nb: row major, v_n = C_nb v_b, {_matrix(facts)}."],
        "euler": _angles(facts),
        "error_estimate": ["e: Milne's estimate of the last step's error, components w, x, y, z of the quaternion."],
        "ready": [
            "1 once the attitude belongs to the time of the newest rate; 0 before the first update, and while the "
            "starter waits."
        ],
    }
    text |= stage_contract.of_routines(facts.number, facts.known, _angles(facts))
    if routine.name != "update":
        lines = text[routine.name]
    else:
        given, unit, bound = _given(facts)
        lines = [
            f"{given}: {n} x 3 values, {given}[3*k + axis], sub-sample k = 0 first; {unit}; sensor axes.",
            f"Range: {bound}; {beyond(facts)}.",
            f"Truncation: {truncation(facts)}.",
            f"Rounding: {rounding(facts)}.",
        ]
        if rates:
            lines.insert(1, "The rate at the start of the interval is the last one of the update before, or start()'s.")
        if facts.algorithm.previous:
            lines.append(f"The first {facts.algorithm.previous} updates after a restart use no history.")
        if any(phase.name == "hold" for phase in facts.algorithm.phases):
            lines.append(
                "After a restart the attitude is held for two updates and current from the third on: see ready()."
            )
    tail = ["Arguments must not overlap the state. A reader that interrupts an update may see a torn state."]
    wrapped = [line for text_line in [*lines, *(tail if routine.name == "update" else [])] for line in _wrap(text_line)]
    return (*_wrap(f"{routine.summary} Type of values: {ctype}."), "", *wrapped)


def _how_often(facts: Facts) -> str:
    if facts.proved is None or facts.proved.updates is None:
        return "How often is not proven for this format: its rounding bound is not computed."
    return f"To be called at least once in {facts.proved.updates} updates (renormalise_every), proved."


def _wrap(text: str) -> list[str]:
    return textwrap.wrap(text, WIDTH, subsequent_indent="  ")


def _given(facts: Facts) -> tuple[str, str, str]:
    """Return what an update is handed: its name, its unit, its range."""
    design = facts.design
    if design.input == "counts":
        assert design.imu.quantum_dps is not None
        unit = f"whole counts of {design.imu.quantum_dps} deg/s, the mean rate of each sub-sample"
        less = " less the bias, by the calibration" * bool(design.imu.bias_dps or design.imu.calibration)
        return "counts", unit, f"rate{less} at most {decimal(design.imu.max_rate_dps)} deg/s in norm"
    if design.input == "rate":
        return "omega", "rad/s, the newest rate last", f"norm of each at most {digits(facts.known.rate)}"
    unit = "rad, the integral of the body rate over each sub-sample"
    return "dtheta", unit, f"norm of each at most {digits(facts.known.increment)}"


def _norm(facts: Facts) -> str:
    design, state = facts.design, facts.algorithm.state
    renormalised = design.form == "factored" and design.renormalise == "every"
    if state == "euler" or (renormalised and facts.exponential):
        return "to within a few units of the last place"
    if renormalised:
        return "but for rounding and what the truncation of one update adds"
    return "up to the drift of truncation and rounding, not bounded"


def _matrix(facts: Facts) -> str:
    if facts.algorithm.state == "dcm":
        return "as it is kept"
    return "of the attitude as quaternion() gives it"


def _angles(facts: Facts) -> list[str]:
    convention = facts.design.euler
    if facts.algorithm.state == "euler":
        return [
            f"angles: roll, pitch, yaw, rad, convention {convention}, as they are kept: each in [-pi, pi]. "
            "Past a pole the pitch goes on beyond pi/2."
        ]
    within = [
        "The attitude of the three angles is within 8 units in the last place of pi of the quaternion's, poles "
        "included; each angle within 4 such units over cos(pitch).",
    ]
    if isinstance(facts.number, Fixed):
        within = [
            "The attitude of the three angles is within 16 last bits of theirs of the quaternion's, poles included; "
            "roll and yaw each within 16 such bits over cos(pitch).",
        ]
    return [
        f"rpy: roll, pitch, yaw, rad, convention {convention}; roll and yaw in [-pi, pi], pitch at most pi/2 in size.",
        *within,
    ]
