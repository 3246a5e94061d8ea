#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Minimax coefficients of the runtime's polynomials.

Remez exchange on  sum_i c_i * phi_i(x) ~ g(x)  with both sides already multiplied by the weight, so
that the levelled error is the one that counts (relative for sin, absolute for cos). Rounding all
coefficients at the end would spoil the fit, so the lowest is rounded to the format first, then the
rest is fitted again around it, and so on: each later coefficient repairs what the rounding of the
earlier ones did. Needs mpmath.

usage: minimax.py            print every table
       minimax.py sin_double print one
"""
import sys
from mpmath import mp, mpf, matrix, lu_solve, cos, sin, atan, asin, expm1, log, sqrt, pi, ldexp, nint, frexp

mp.dps = 50


def rounded(value, bits):
    """value rounded to nearest with the given number of significant bits."""
    if value == 0:
        return mpf(0)
    mantissa, exponent = frexp(value)
    return ldexp(nint(ldexp(mantissa, bits)), exponent - bits)


def extrema(error, low, high, count):
    """One point of largest |error| in each run of equal sign, on a fine Chebyshev grid."""
    steps = 40 * count
    grid = [(low + high) / 2 + (high - low) / 2 * cos(pi * (steps - i) / steps) for i in range(steps + 1)]
    runs = []
    for x in grid[1:]:
        value = error(x)
        if runs and (value >= 0) == (runs[-1][1] >= 0):
            if abs(value) > abs(runs[-1][1]):
                runs[-1] = (x, value)
        else:
            runs.append((x, value))
    while len(runs) > count:
        runs.pop(0 if abs(runs[0][1]) < abs(runs[-1][1]) else -1)
    return runs


def remez(basis, target, low, high):
    """Levelled coefficients of the basis functions and the largest error left."""
    count = len(basis) + 1
    points = [(low + high) / 2 - (high - low) / 2 * cos(pi * (2 * i + 1) / (2 * count)) for i in range(count)]
    for _ in range(12):
        rows = matrix(count, count)
        right = matrix(count, 1)
        for i, x in enumerate(points):
            for j, phi in enumerate(basis):
                rows[i, j] = phi(x)
            rows[i, len(basis)] = (-1) ** i
            right[i] = target(x)
        solution = lu_solve(rows, right)
        coefficients = [solution[j] for j in range(len(basis))]
        runs = extrema(lambda x: target(x) - sum(c * phi(x) for c, phi in zip(coefficients, basis)),
                       low, high, count)
        if len(runs) < count:
            break
        points = [x for x, _ in runs]
        sizes = [abs(value) for _, value in runs]
        if max(sizes) < min(sizes) * mpf("1.0001"):
            break
    return coefficients, max(abs(value) for _, value in runs)


def fit(basis, target, low, high, bits, tried=1):
    """Coefficients rounded one after the other, and the largest error left. For the first `tried` ones
    the neighbours of the rounded value are tried too, for the nearest is not always the best."""
    def complete(done):
        def rest(x):
            return target(x) - sum(c * phi(x) for c, phi in zip(done, basis))
        if len(done) == len(basis):
            return done, max(abs(rest(low + (high - low) * i / 499)) for i in range(1, 500))
        coefficient = remez(basis[len(done):], rest, low, high)[0][0]
        nearest = rounded(coefficient, bits)
        unit = ldexp(1, frexp(nearest)[1] - bits)
        steps = (-1, 0, 1) if len(done) < tried else (0,)
        return min((complete(done + [nearest + step * unit]) for step in steps), key=lambda found: found[1])
    return complete([])


def powers(weight, first, count):
    return [lambda x, p=first + i: weight(x) * x ** p for i in range(count)]


def odd(function, low_count, high, bits, tried=1):
    """function(r) = r + r z P(z), z = r^2: the relative error is levelled."""
    def weight(z):
        return sqrt(z) / function(sqrt(z))
    return fit(powers(weight, 1, low_count), lambda z: 1 - weight(z), mpf(10) ** -12, high ** 2, bits,
               tried)


def cosine(count, high, bits):
    """cos(r) = 1 + z (-1/2 + z Q(z)): the absolute error is levelled (cos >= 0.7)."""
    return fit(powers(lambda z: mpf(1), 2, count), lambda z: cos(sqrt(z)) - 1 + z / 2, mpf(10) ** -12,
               high ** 2, bits)


def exponential(count, bits):
    """exp(r) = 1 + r + r^2 P(r), |r| <= ln2/2. The error of P itself is levelled and its coefficients
    are rounded at once: with a factor r everything would vanish inside the interval and the exchange
    would not work."""
    high = log(mpf(2)) / 2 * mpf("1.0001")
    def exact(r):
        return (expm1(r) - r) / r ** 2 if abs(r) > mpf(10) ** -15 else mpf(1) / 2 + r / 6
    coefficients, error = remez(powers(lambda r: mpf(1), 0, count), exact, -high, high)
    return [rounded(c, bits) for c in coefficients], error * high ** 2


def logarithm(count, bits):
    """log((1+s)/(1-s)) = 2 s + s z P(z), z = s^2, |s| <= (sqrt2 - 1)/(sqrt2 + 1)."""
    high = (sqrt(mpf(2)) - 1) / (sqrt(mpf(2)) + 1) * mpf("1.001")
    def exact(z):
        s = sqrt(z)
        return log((1 + s) / (1 - s)) / s
    return fit([lambda z, p=i + 1: z ** p / exact(z) for i in range(count)], lambda z: 1 - 2 / exact(z),
               mpf(10) ** -12, high ** 2, bits)


QUARTER = mpf("0.78540")
EIGHTH = sqrt(mpf(2)) - 1 + mpf(10) ** -6
TABLES = {
    "sin_double": lambda: odd(sin, 6, QUARTER, 53, tried=2),
    "cos_double": lambda: cosine(6, QUARTER, 53),
    "atan_double": lambda: odd(atan, 11, EIGHTH, 53),
    "asin_double": lambda: odd(asin, 13, mpf("0.5"), 53),
    "exp_double": lambda: exponential(11, 53),
    "log_double": lambda: logarithm(7, 53),
    "sin_float": lambda: odd(sin, 3, QUARTER, 24, tried=3),
    "cos_float": lambda: cosine(3, QUARTER, 24),
    "atan_float": lambda: odd(atan, 5, EIGHTH, 24),
    "asin_float": lambda: odd(asin, 5, mpf("0.5"), 24),
    "exp_float": lambda: exponential(5, 24),
    "log_float": lambda: logarithm(3, 24),
}


def hexadecimal(value, suffix):
    return float(value).hex() + suffix


def main(names):
    for name in names or TABLES:
        coefficients, error = TABLES[name]()
        print(f"{name}: error 2^{float(log(error) / log(2)):.2f}")
        for c in coefficients:
            print(f"  {hexadecimal(c, 'F' if name.endswith('float') else '')},")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
