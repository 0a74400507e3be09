#!/usr/bin/env python3
"""Centres of gravity in rational arithmetic, for every implication and aggregation.

    exact_centres.py > exact_centres.csv

Each line: implication, aggregation, least and largest value of the output, the centre in 20 digits, and the conclusions,
each a trapezoid's four corners and the degree of its rule. Numbers are such that doubles hold them exactly. The way is
another than the program's: all places where anything could bend are collected first, then polynomials are multiplied out
and integrated.
"""
import itertools
import random
from fractions import Fraction as F

IMPLICATIONS = ("minimum", "product", "bounded-difference")
AGGREGATIONS = ("maximum", "probabilistic-sum", "bounded-sum")


def membership(corners, x):
    a, b, c, d = corners
    if x < a or x > d:
        return F(0)
    if x < b:
        return (x - a) / (b - a)
    if x > c:
        return (d - x) / (d - c)
    return F(1)


def implied(implication, degree, value):
    return {"minimum": min(degree, value), "product": degree * value,
            "bounded-difference": max(F(0), degree + value - 1)}[implication]


def bends(implication, conclusions, least, largest):
    """Where a set bends or jumps."""
    places = {least, largest}
    for (a, b, c, d), h in conclusions:
        places |= {a, b, c, d, a + h * (b - a), d - h * (d - c), b - h * (b - a), c + h * (d - c)}
    return sorted(x for x in places if least <= x <= largest)


def lines(implication, conclusions, left, right):
    """Of every set between two bends: its value at 0 and its slope."""
    one, two = left + (right - left) / 3, left + (right - left) * 2 / 3
    result = []
    for corners, degree in conclusions:
        v, w = (implied(implication, degree, membership(corners, x)) for x in (one, two))
        slope = (w - v) / (two - one)
        result.append((v - slope * one, slope))
    return result


def crossings(aggregation, pieces, left, right):
    """Where the aggregation changes from one piece to another, in between."""
    pairs = []
    if aggregation == "maximum":
        pairs = itertools.combinations(pieces, 2)
    if aggregation == "bounded-sum":
        pairs = [((sum(p for p, _ in pieces), sum(q for _, q in pieces)), (F(1), F(0)))]
    places = {(p - r) / (s - q) for (p, q), (r, s) in pairs if q != s}
    return sorted({left, right} | {x for x in places if left < x < right})


def polynomial(aggregation, pieces, middle):
    """Its coefficients, the lowest first."""
    if aggregation == "maximum":
        return list(max(pieces, key=lambda piece: piece[0] + piece[1] * middle))
    if aggregation == "bounded-sum":
        total = [sum(p for p, _ in pieces), sum(q for _, q in pieces)]
        return total if total[0] + total[1] * middle < 1 else [F(1)]
    rest = [F(1)]
    for p, q in pieces:
        product = [F(0)] * (len(rest) + 1)
        for i, coefficient in enumerate(rest):
            product[i] += coefficient * (1 - p)
            product[i + 1] -= coefficient * q
        rest = product
    return [1 - rest[0]] + [-coefficient for coefficient in rest[1:]]


def integral(coefficients, left, right):
    return sum(c * (right ** (i + 1) - left ** (i + 1)) / (i + 1) for i, c in enumerate(coefficients))


def centre(implication, aggregation, least, largest, conclusions):
    area = moment = F(0)
    places = bends(implication, conclusions, least, largest)
    for left, right in zip(places, places[1:]):
        pieces = lines(implication, conclusions, left, right)
        inner = crossings(aggregation, pieces, left, right)
        for start, end in zip(inner, inner[1:]):
            coefficients = polynomial(aggregation, pieces, (start + end) / 2)
            area += integral(coefficients, start, end)
            moment += integral([F(0)] + coefficients, start, end)
    return moment / area


def digits(value):
    scaled = round(value * 10 ** 20)
    sign, scaled = ("-", -scaled) if scaled < 0 else ("", scaled)
    return "%s%d.%020d" % (sign, scaled // 10 ** 20, scaled % 10 ** 20)


def conclusions_of(generator, count, least, largest):
    result = []
    for i in range(count):
        corners = sorted(F(generator.randint(4 * least - 20, 4 * largest + 20), 4) for _ in range(4))
        if i % 3 == 1:
            corners[0] = corners[1]  # a shoulder
        if i % 4 == 2:
            corners[2] = corners[1]  # a triangle
        result.append((corners, F(generator.randint(1, 32), 32)))
    # At least one reaches into the range whatever the implication leaves of it.
    middle = F(least + largest, 2)
    result[0] = ([middle - 3, middle - 1, middle, middle + 5], F(generator.randint(1, 32), 32))
    return result


def main():
    generator = random.Random(2003)
    print("implication,aggregation,minimum,maximum,centre,conclusions")
    for count, (least, largest) in ((1, (-2, 3)), (2, (0, 10)), (3, (-50, 50)), (4, (0, 100)), (6, (-7, 1)), (9, (0, 150)),
                                    (40, (0, 20))):
        conclusions = conclusions_of(generator, count, least, largest)
        for implication, aggregation in itertools.product(IMPLICATIONS, AGGREGATIONS):
            value = centre(implication, aggregation, F(least), F(largest), conclusions)
            texts = [" ".join(str(float(x)) for x in corners + [degree]) for corners, degree in conclusions]
            print("%s,%s,%d,%d,%s,%s" % (implication, aggregation, least, largest, digits(value), " ".join(texts)))


if __name__ == "__main__":
    main()
