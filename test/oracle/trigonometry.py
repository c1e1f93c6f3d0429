#!/usr/bin/env python3
"""Makes the test vectors of sine, cosine and arctangent.

    python3 trigonometry.py [--out ../fixtures/trigonometry.bin]

Little-endian records of nine float64: an angle in degrees, its sine and cosine, y and x, their arctangent in degrees; each of the three
results as the nearest float64 and what that is off by.
"""
import argparse
import math
import os
import random
import struct

import mpmath

SEED = 20261121
COUNT = 3000
HERE = os.path.dirname(os.path.abspath(__file__))


def angle(draw):
    """Of all magnitudes, near to quarter turns, whole."""
    kind = draw.randrange(4)
    if kind == 0:
        return draw.uniform(-360, 360)
    if kind == 1:
        return draw.choice([-1, 1]) * 10 ** draw.uniform(-12, 12)
    if kind == 2:
        return 90.0 * draw.randrange(-8, 9) + draw.choice([-1, 1]) * 10 ** draw.uniform(-14, 1)
    return float(draw.randrange(-720, 721))


def coordinate(draw):
    return draw.choice([-1, 1]) * 10 ** draw.uniform(-8, 8)


def parts(exact):
    nearest = float(exact)
    return nearest, float(exact - mpmath.mpf(nearest))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--out", default=os.path.join(HERE, "../fixtures/trigonometry.bin"))
    args = parser.parse_args()
    mpmath.mp.prec = 400
    draw = random.Random(SEED)
    with open(args.out, "wb") as file:
        for _ in range(COUNT):
            degrees = angle(draw)
            radians = mpmath.mpf(degrees) * mpmath.pi / 180
            quarters = math.fmod(degrees, 360) / 90
            sine = mpmath.mpf([0, 1, 0, -1][int(quarters) % 4]) if quarters == int(quarters) else mpmath.sin(radians)
            cosine = mpmath.mpf([1, 0, -1, 0][int(quarters) % 4]) if quarters == int(quarters) else mpmath.cos(radians)
            y, x = coordinate(draw), coordinate(draw)
            if draw.randrange(4) == 0:
                x = y * draw.choice([-1, 1]) * (1 + draw.uniform(-1, 1) * 10 ** draw.uniform(-16, 0))
            turn = mpmath.atan2(mpmath.mpf(y), mpmath.mpf(x)) * 180 / mpmath.pi
            file.write(struct.pack("<9d", degrees, *parts(sine), *parts(cosine), y, x, *parts(turn)))


if __name__ == "__main__":
    main()
