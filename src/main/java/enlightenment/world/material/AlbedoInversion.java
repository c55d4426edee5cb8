package enlightenment.world.material;

import enlightenment.bsdf.GaussLegendre;

/**
 * Computes the single-scattering albedo of a thick medium from its reflectance: inverts S. Chandrasekhar's exact solution of the half-space
 * with isotropic scattering ("Radiative Transfer", 1960).
 *
 * <p>With w the albedo of single scattering, the half-space under uniform illumination reflects 1 − 2 sqrt(1 − w) ∫ H(μ) μ dμ. That
 * moment of H stands in the first two terms of 1 / H(μ) for large μ, which its integral equation and the closed form of V. Busbridge ("The
 * Mathematics of Radiative Transfer", 1960) both have; comparing them leaves one integral over an angle,
 *
 * <pre>(4 / π) ∫ (1 − ln(1 + z) / z) (1 − θ cot θ) / sin² θ dθ,   z = w (1 − θ cot θ) / (1 − w),   0 &lt; θ &lt; π/2,</pre>
 *
 * whose integrand is smooth in the logarithm of θ.
 */
final class AlbedoInversion {
    /** The number of halvings of the range of angles; the rest contributes less than a rounding. */
    private static final int OCTAVES = 27;

    private static final int POINTS = 10;

    /** Below this angle 1 − θ cot θ is summed as a power series. */
    private static final double SMALL_ANGLE = 0.125;

    /** Below this z, 1 − ln(1 + z) / z is summed as a power series. */
    private static final double SMALL_RATIO = 0x1p-10;

    private static final int STEPS = 60;

    /** At each angle of the quadrature: 1 − θ cot θ. */
    private static final double[] RISE = new double[OCTAVES * POINTS];

    /** At each angle of the quadrature: (1 − θ cot θ) / sin² θ times the weight of the point; they add up to 1. */
    private static final double[] WEIGHT = new double[OCTAVES * POINTS];

    static {
        for (int i = 0; i < OCTAVES; i++) {
            double low = Math.scalb(Math.PI / 4, -i);
            for (int k = 0; k < POINTS; k++) {
                double angle = low + low * GaussLegendre.node(POINTS, k);
                double sin = StrictMath.sin(angle);
                double rise = rise(angle, sin);
                RISE[i * POINTS + k] = rise;
                WEIGHT[i * POINTS + k] = 4 / Math.PI * low * GaussLegendre.weight(POINTS, k) * rise / (sin * sin);
            }
        }
    }

    private AlbedoInversion() {}

    private static double rise(double angle, double sin) {
        double square = angle * angle;
        if (angle >= SMALL_ANGLE) {
            return (sin - angle * StrictMath.cos(angle)) / sin;
        }
        // (sin θ − θ cos θ) / θ as a power series.
        double sum = 0;
        for (int n = 6; n >= 1; n--) {
            // 2n / (2n + 1)! = 1/3, 1/30, 1/840, ... of alternating signs.
            sum = square * (2 * n / factorial(2 * n + 1) - sum);
        }
        return sum * angle / sin;
    }

    private static double factorial(int n) {
        double product = 1;
        for (int i = 2; i <= n; i++) {
            product *= i;
        }
        return product;
    }

    /**
     * The single-scattering albedo of a half-space with isotropic scattering and no reflecting interface.
     *
     * @param givenBack its reflectance under uniform illumination, 0..1
     * @return 0..1; 1 within 10^-8 of 1
     */
    static double singleScattering(double givenBack) {
        if (givenBack <= 0 || givenBack >= 1) {
            return givenBack <= 0 ? 0 : 1;
        }
        // Bisection in the square root of the absorption, in which the reflectance is nearly linear.
        double low = 0;
        double high = 1;
        for (int i = 0; i < STEPS; i++) {
            double root = 0.5 * (low + high);
            if (givenBack(root) > givenBack) {
                low = root;
            } else {
                high = root;
            }
        }
        return (1 - low) * (1 + low);
    }

    /**
     * The reflectance of a half-space under uniform illumination.
     *
     * @param root the square root of the absorbed share of each scattering event, 0..1
     */
    static double givenBack(double root) {
        double ratio = (1 - root) * (1 + root) / (root * root);
        double sum = 0;
        for (int i = 0; i < RISE.length; i++) {
            double z = ratio * RISE[i];
            sum += WEIGHT[i]
                    * (z < SMALL_RATIO
                            ? z * (0.5 - z * (1.0 / 3 - z * (0.25 - 0.2 * z)))
                            : 1 - StrictMath.log1p(z) / z);
        }
        return sum;
    }
}
