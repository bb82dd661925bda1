#!/usr/bin/env python3
"""Writes profiler/builtins/polynomials.h: builtin_polynomials.py > profiler/builtins/polynomials.h (needs mpmath).

Each polynomial interpolates its function at Chebyshev nodes, which comes within a factor of two or so of the best one
(L. N. Trefethen, Approximation Theory and Approximation Practice, chapter 16). Their coefficients are rounded to the type;
the bounds written beside them hold for the rounded ones.
"""
from mpmath import mp, mpf, mpmathify, pi, cos, log, log1p, atan, tan, tanh, sin, sinh, erf, erfc, exp, expm1, loggamma, gamma, \
    sqrt, lu_solve, matrix

mp.dps = 120


def ratio(function, leading, power):
    """(function(x) - leading(x)) / x^power; there are digits enough for what cancels."""
    def g(x):
        x = x if abs(x) > mpf('1e-25') else mpf('1e-25')
        return (function(x) - leading(x)) / x**power
    return g


def of_square(g):
    return lambda s: g(sqrt(s))


# name, what it is, function, interval, degree for float and double (None: not for that type)
POLYNOMIALS = [
    ('log1p', '(log(1 + t) - t + t^2 / 2) / t^3', ratio(log1p, lambda x: x - x * x / 2, 3), (-1 / mpf(3), 1 / mpf(3)), 9,
     None),
    ('atanh', '(log((1 + u) / (1 - u)) - 2 u) / u^3, of u^2',
     of_square(ratio(lambda u: log1p(u) - log1p(-u), lambda u: 2 * u, 3)), (0, mpf('0.0401')), 3, None),
    ('sin', '(sin(r) - r) / r^3, of r^2', of_square(ratio(sin, lambda x: x, 3)), (0, mpf('0.62')), 2, 6),
    ('cos', '(cos(r) - 1 + r^2 / 2) / r^4, of r^2',
     of_square(ratio(cos, lambda x: 1 - x * x / 2, 4)), (0, mpf('0.62')), 2, 6),
    ('tan', '(tan(r) - r) / r^3, of r^2', of_square(ratio(tan, lambda x: x, 3)), (0, mpf('0.62')), 5, 14),
    ('tanh', '(tanh(x) - x) / x^3, of x^2', of_square(ratio(tanh, lambda x: x, 3)), (0, mpf('0.37')), 4, None),
    ('sinh', '(sinh(x) - x) / x^3, of x^2', of_square(ratio(sinh, lambda x: x, 3)), (0, 1), 3, None),
    ('atan', '(atan(x) - x) / x^3, of x^2', of_square(ratio(atan, lambda x: x, 3)), (0, 1), 8, 20),
    ('expm1', '(exp(r) - 1 - r - r^2 / 2) / r^3', ratio(expm1, lambda x: x + x * x / 2, 3),
     (mpf('-0.347'), mpf('0.347')), None, 12),
    ('erf', '(erf(x) - x) / x, of x^2', of_square(ratio(erf, lambda x: x, 1)), (0, 1), 6, 13),
    ('erfc', '(1 + 2 x) exp(x^2) erfc(x), of (x - 4) / (x + 4), x from 0 to 28',
     lambda t: (lambda x: (1 + 2 * x) * exp(x * x) * erfc(x))(4 * (1 + t) / (1 - t)), (-1, mpf('0.75')), 10, 22),
    ('log_gamma', 'log(gamma(2 + t)) / t', ratio(lambda t: loggamma(2 + t), lambda t: 0, 1), (mpf('-0.5'), mpf('0.5')), 9,
     26),
    ('stirling', 'gamma(x) / (sqrt(2 pi) x^(x - 1/2) exp(-x)), of 1 / x, x from 10',
     lambda t: gamma(1 / t) / (sqrt(2 * pi) * exp((1 / t - 0.5) * log(1 / t) - 1 / t)) if t > 1e-9 else 1 + t / 12,
     (0, mpf('0.1')), 3, 9),
    ('log_stirling', 'x (log(gamma(x)) - (x - 1/2) (log(x) - 1) - (log(2 pi) - 1) / 2), of 1 / x, x from 8',
     lambda t: (loggamma(1 / t) - (1 / t - 0.5) * (log(1 / t) - 1) - (log(2 * pi) - 1) / 2) / t
     if t > mpf('1e-9') else 1 / mpf(12), (0, mpf('0.125')), 3, 10),
]


def rounded(value, digits):
    with mp.workprec(digits):
        return +value


def fitted(g, interval, degree, digits):
    """Coefficients, lowest first, each rounded."""
    a, b = (mpmathify(v) for v in interval)
    at = [(a + b) / 2 + (b - a) / 2 * cos(pi * (2 * k + 1) / (2 * degree + 2)) for k in range(degree + 1)]
    powers = matrix([[t**k for k in range(degree + 1)] for t in at])
    return [rounded(c, digits) for c in lu_solve(powers, matrix([g(t) for t in at]))]


def error(g, interval, coefficients):
    a, b = (mpmathify(v) for v in interval)
    at = [a + (b - a) * k / 100 for k in range(101)]
    return max(abs(sum(c * t**k for k, c in enumerate(coefficients)) - g(t)) for t in at)


def literal(value, is_double):
    if is_double:
        return float(value).hex()
    return float(value).hex() + 'f'


def text_of(name, what, g, interval, degree, is_double):
    coefficients = fitted(g, interval, degree, 53 if is_double else 24)
    bound = mp.nstr(log(error(g, interval, coefficients)) / log(2), 3)
    kind = 'double' if is_double else 'float'
    lines = [f'// {what}: within 2^{bound}',
             f'WARPGRAIN_INLINE {kind} warpgrain_{name}_polynomial({kind} t) {{',
             f'  {kind} p = {literal(coefficients[-1], is_double)};']
    lines += [f'  p = fma(p, t, {literal(c, is_double)});' for c in reversed(coefficients[:-1])]
    return '\n'.join(lines + ['  return p;', '}'])


def main():
    print('#pragma once')
    print('// Written by scripts/builtin_polynomials.py; do not edit. Polynomials behind the built-in functions.\n')
    print('#include "profiler/builtins/vectors.h"\n')
    parts = []
    for name, what, g, interval, in_float, in_double in POLYNOMIALS:
        for degree, is_double in ((in_float, False), (in_double, True)):
            if degree is not None:
                parts.append(text_of(name, what, g, interval, degree, is_double))
    print('\n\n'.join(parts))
    print('\n// 64 zero bits, then the bits of 2 / pi behind the point, highest first.')
    print('// clang-format off')
    print('constant ulong warpgrain_two_over_pi[] = {0,')
    mp.dps = 450
    bits = int(mp.floor(2 / pi * mpf(2)**(64 * 22)))
    words = [f'0x{bits >> (64 * (21 - k)) & (2**64 - 1):016x}UL' for k in range(22)]
    for k in range(0, 22, 4):
        print('    ' + ', '.join(words[k:k + 4]) + ('};' if k + 4 >= 22 else ','))
    print('// clang-format on')


main()
