#!/usr/bin/env python3
"""Makes the test vectors of reading decimal numbers.

    python3 decimals.py [--out ../fixtures/decimals.txt]

Lines of a word and the bits of the nearest float64, ties to even, as sixteen hexadecimal digits, the lower half first.
"""
import argparse
import os
import random
import struct

SEED = 20261122
COUNT = 2400
HERE = os.path.dirname(os.path.abspath(__file__))


def digits(draw, count):
    return "".join(draw.choice("0123456789") for _ in range(count))


def word(draw):
    """As programs write numbers: with some digits behind the point, to the last bit, with exponents; and as none does."""
    kind = draw.randrange(6)
    sign = draw.choice(["", "", "-", "+"])
    if kind == 0:
        return sign + "%.*f" % (draw.randrange(1, 20), draw.uniform(0, 10 ** draw.randrange(-3, 6)))
    if kind == 1:
        return sign + repr(draw.uniform(0, 1) * 10 ** draw.randrange(-12, 12))
    if kind == 2:
        return sign + "%.*e" % (draw.randrange(1, 20), draw.uniform(0, 1) * 10 ** draw.randrange(-290, 275))
    if kind == 3:
        return sign + digits(draw, draw.randrange(0, 30)) + "." + digits(draw, draw.randrange(1, 30))
    if kind == 4:
        return sign + draw.choice(["0", "0.", "0.0", "000", "1", "7."]) + digits(draw, draw.randrange(0, 12)) + draw.choice("eE") + draw.choice(["", "-", "+"]) + digits(draw, 2)
    # halfway between two of them, and next to that
    half = (draw.randrange(2 ** 52, 2 ** 53) * 2 + 1) << draw.randrange(0, 40)
    return sign + str(half + draw.choice([0, 0, 1, -1]))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--out", default=os.path.join(HERE, "../fixtures/decimals.txt"))
    args = parser.parse_args()
    draw = random.Random(SEED)
    with open(args.out, "w") as file:
        for _ in range(COUNT):
            text = word(draw)
            low, high = struct.unpack("<2I", struct.pack("<d", float(text)))
            file.write("%s %08x%08x\n" % (text, low, high))


if __name__ == "__main__":
    main()
