"""A burning slab by finite differences: steady heat in ammonium perchlorate that recedes at 0.45 cm/s.

    rho c r_b dT/dy = kappa T'',   kappa T' = Q at the surface y = 0,   T = 300 K at y = -300 um

The exact solution is Crawford's truth "slab" with model="thermal"; solve() is second order.
"""

DEPTH = 300e-6  # [m]
KAPPA, RHO_C, RATE, FLUX, COLD = 0.405, 1950.0 * 1255.2, 0.0045, 8.368e6, 300.0  # SI
PARAMETERS = {"model": "thermal", "heat_of_reaction": 0.0, "depth": DEPTH}


def solve_tridiagonal(lower, diagonal, upper, right):
    """Thomas' algorithm."""
    diagonal, right = list(diagonal), list(right)
    for k in range(1, len(diagonal)):
        factor = lower[k] / diagonal[k - 1]
        diagonal[k] -= factor * upper[k - 1]
        right[k] -= factor * right[k - 1]
    solution = [0.0] * len(diagonal)
    for k in reversed(range(len(diagonal))):
        beyond = upper[k] * solution[k + 1] if k + 1 < len(diagonal) else 0.0
        solution[k] = (right[k] - beyond) / diagonal[k]
    return solution


def surface_row(h, diffusion, convection):
    """The equation at the surface itself; the point beyond it follows from the flux."""
    gradient = FLUX / KAPPA
    return -2.0 * diffusion, 2.0 * diffusion, (2.0 * h * diffusion - convection * 2.0 * h) * gradient


def solve(cells, surface=surface_row):
    """Heights [m] and temperatures [K] at cells + 1 points."""
    h = DEPTH / cells
    diffusion, convection = KAPPA / h**2, RHO_C * RATE / (2.0 * h)
    lower = [0.0] + [-diffusion - convection] * (cells - 1)
    diagonal = [1.0] + [2.0 * diffusion] * (cells - 1)
    upper = [0.0] + [-diffusion + convection] * (cells - 1) + [0.0]
    right = [COLD] + [0.0] * (cells - 1)
    for row, value in zip((lower, diagonal, right), surface(h, diffusion, convection)):
        row.append(value)
    y = [-DEPTH + k * h for k in range(cells)] + [0.0]
    return y, solve_tridiagonal(lower, diagonal, upper, right)
