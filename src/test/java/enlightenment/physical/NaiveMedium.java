package enlightenment.physical;

import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.math.Vec3;
import java.util.SplittableRandom;

/**
 * What fills a place: coefficients by band, per unit of length.
 *
 * @param scattering what is scattered
 * @param extinction what is scattered or absorbed
 * @param anisotropy the mean cosine of the phase function
 */
record NaiveMedium(double[] scattering, double[] extinction, double anisotropy) {
    static final NaiveMedium EMPTY = new NaiveMedium(new double[3], new double[3], 0);

    static NaiveMedium of(Medium medium) {
        Medium.Coefficients c = (Medium.Coefficients) medium;
        double[] scattering = NaiveColors.of(c.scattering());
        double[] extinction = NaiveColors.of(c.absorption());
        for (int band = 0; band < 3; band++) {
            extinction[band] += scattering[band];
        }
        return new NaiveMedium(scattering, extinction, c.anisotropy());
    }

    static NaiveMedium of(Material material) {
        return material instanceof Material.Scattering s
                ? of(s.medium())
                : new NaiveMedium(new double[3], NaiveColors.of(((Glass) material).absorption()), 0);
    }

    /** The boundary of a solid of a material as that of glass. */
    static Glass boundary(Material material) {
        return material instanceof Material.Scattering s
                ? new Glass(s.color(), s.indexOfRefraction(), 1, s.priority(), true).withRoughness(s.roughness())
                : (Glass) material;
    }

    boolean scatters() {
        return scattering[0] + scattering[1] + scattering[2] > 0;
    }

    /** The share of extinction that is scattered. */
    double albedo(int band) {
        return scattering[band] / extinction[band];
    }

    /** What is left of light after a way. */
    double[] transmittance(double length) {
        double[] left = new double[3];
        for (int band = 0; band < 3; band++) {
            left[band] = extinction[band] == 0 ? 1 : Math.exp(-extinction[band] * length);
        }
        return left;
    }

    /** The phase function in the form of the textbooks. */
    double phase(double cosine) {
        double g = anisotropy;
        return (1 - g * g) / (4 * Math.PI * Math.pow(1 + g * g - 2 * g * cosine, 1.5));
    }

    /** A direction with the density of the phase function, by its inverse in the form of the textbooks, after light came along d. */
    Vec3 turned(Vec3 d, SplittableRandom random) {
        double g = anisotropy;
        double u = random.nextDouble();
        double square = (1 - g * g) / (1 - g + 2 * g * u);
        double z = g == 0 ? 2 * u - 1 : (1 + g * g - square * square) / (2 * g);
        double angle = 2 * Math.PI * random.nextDouble();
        double r = Math.sqrt(Math.max(0, 1 - z * z));
        Vec3 x = (Math.abs(d.x()) < 0.6 ? Vec3.X : Vec3.Y).cross(d).normalized();
        Vec3 y = d.cross(x);
        return x.times(r * Math.cos(angle))
                .plus(y.times(r * Math.sin(angle)))
                .plus(d.times(z))
                .normalized();
    }
}
