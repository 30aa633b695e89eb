#!/usr/bin/env python3
"""Least times of small programs with the parabolic profile (VEL-11), found numerically: writes programs.json.

    python3 -m venv venv && venv/bin/pip install casadi==3.8.2 && venv/bin/python optimal.py > programs.json

Each block is cut into PARTS, and each of these into STEPS intervals of equal time with a constant jerk each; Ipopt looks
for the jerks and times that take the least time in all and keep the limits. It starts from several velocities, and the best result counts. Nothing here
is taken from the planner: lengths, angles and caps of joints are computed from the blocks.
"""

import json
import math
import random
import sys

import casadi

PARTS = 3
STEPS = 14
CYCLE_MS = 2.0
SEED = 872


def joint_cap(before, block, accuracy_um):
    """VEL-4 and VEL-7: the greatest velocity at a joint, mm/s."""
    cap = min(before["feed"], block["feed"]) / 60
    (a, b) = (before["vector"], block["vector"])
    across = math.hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    along = sum(x * y for x, y in zip(a, b))
    half = math.atan2(across, along) / 2
    if accuracy_um > 0 and half > 1e-9:
        cap = min(cap, accuracy_um / (CYCLE_MS * math.tan(half)))
    return cap


def least_time(program, start):
    """The time from one start of the search, or None; `start` is a part of the caps."""
    blocks = program["blocks"]
    opti = casadi.Opti()
    total = 0
    v, a = 0.0, 0.0
    for k, block in enumerate(blocks):
        length = math.hypot(*block["vector"])
        feed = block["feed"] / 60
        accel, jerk_limit = block["accel"], block["p"] / 32.768
        way = 0
        for _ in range(PARTS):
            step = opti.variable()
            opti.subject_to(step >= 1e-9)
            opti.set_initial(step, length / (feed * start) / (PARTS * STEPS))
            jerk = opti.variable(STEPS)
            opti.subject_to(opti.bounded(-1, jerk, 1))
            speed, push = opti.variable(STEPS), opti.variable(STEPS)
            opti.set_initial(speed, feed * start)
            for i in range(STEPS):
                j = jerk[i] * jerk_limit
                way += step * (v + step * (a / 2 + step * j / 6))
                opti.subject_to(speed[i] == v + step * (a + step * j / 2))
                opti.subject_to(push[i] == a + step * j)
                (v, a) = (speed[i], push[i])
            opti.subject_to(opti.bounded(0, speed, feed))
            opti.subject_to(opti.bounded(-accel, push, accel))
            total += STEPS * step
        opti.subject_to(way / length == 1)
        if k + 1 < len(blocks):
            behind = blocks[k + 1]
            opti.subject_to(v <= joint_cap(block, behind, program["accuracy_um"]))
            opti.subject_to(opti.bounded(-behind["accel"], a, behind["accel"]))
    opti.subject_to(v == 0)
    opti.subject_to(a == 0)
    opti.minimize(total)
    opti.solver("ipopt", {"print_time": False}, {"print_level": 0, "sb": "yes", "max_iter": 1500, "tol": 1e-8})
    try:
        return opti.solve().value(total)
    except RuntimeError:
        return None


def programs(rng):
    """Small programs of each kind, with the bound of VEL-13 that is theirs."""
    def scaled(low, high):
        return math.exp(rng.uniform(math.log(low), math.log(high)))

    def vector(length, heading):
        return [round(length * math.cos(heading), 4), round(length * math.sin(heading), 4), 0.0]

    def block(vector, feed, accel, p):
        return {"vector": vector, "feed": round(feed), "accel": round(accel), "p": round(p)}

    def limits():
        return scaled(150, 2000), scaled(10_000, 500_000)

    def program(kind, bound, blocks, accuracy_um=0.0):
        return {"kind": kind, "bound": bound, "accuracy_um": round(accuracy_um, 3), "blocks": blocks}

    for count in [2, 3, 4, 5, 6, 8]:
        for _ in range(2):
            (accel, p), length = limits(), scaled(0.5, 50)
            lengths = [length * scaled(0.3, 3) for _ in range(count)]
            blocks = [block(vector(each, 0), scaled(500, 12_000), accel, p) for each in lengths]
            yield program("changes of feed", 0.05, blocks)
    for count in [3, 4, 5, 6, 8, 10]:
        for feeds in [1, 2]:
            (accel, p), length, turn = limits(), scaled(0.3, 20), scaled(0.05, 0.9)
            heading, feed, blocks = 0.0, scaled(1000, 12_000), []
            for _ in range(count):
                if feeds == 2 and rng.random() < 0.4:
                    feed = scaled(500, 12_000)
                blocks.append(block(vector(length * scaled(0.3, 3), heading), feed, accel, p))
                heading += rng.uniform(-turn, turn)
            yield program("corners", 0.15, blocks, scaled(1, 30))
    for count in [2, 3, 4]:
        for _ in range(1):
            length = scaled(1, 30)
            lengths = [length * scaled(0.3, 3) for _ in range(count)]
            blocks = [block(vector(each, 0), scaled(1000, 8000), *limits()) for each in lengths]
            yield program("changes of sets", 0.15, blocks)
    for _ in range(4):
        yield program("one block", 0.05, [block(vector(scaled(1, 200), 0), scaled(500, 15_000), *limits())])
    for count in [3, 5, 8]:
        for turn in [0.0, 0.01]:
            (accel, p), feed, length = limits(), scaled(500, 15_000), scaled(0.5, 20)
            heading, blocks = 0.0, []
            for _ in range(count):
                blocks.append(block(vector(length * scaled(0.3, 3), heading), feed, accel, p))
                heading += rng.uniform(-turn, turn)
            yield program("collinear", 0.05, blocks, 50.0 if turn else 0.0)


def main():
    rows = []
    for program in programs(random.Random(SEED)):
        times = [least_time(program, start) for start in (0.2, 0.7)]
        found = [time for time in times if time is not None]
        print(program["kind"], len(program["blocks"]), times, file=sys.stderr, flush=True)
        if found:
            rows.append(json.dumps(program | {"time_s": float(f"{min(found):.6g}")}))
    print("[\n" + ",\n".join(rows) + "\n]")


if __name__ == "__main__":
    main()
