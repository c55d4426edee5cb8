package enlightenment.physical;

import enlightenment.material.Glossy;
import enlightenment.math.Vec3;
import java.util.SplittableRandom;

/**
 * What a surface that is no single direction reflects, in a frame whose z axis is the normal on the side that light leaves to:
 * formulas as their authors print them, and densities that anybody can check.
 */
abstract class NaiveReflector {
    /** The BRDF in a band. */
    abstract double value(int band, Vec3 out, Vec3 in);

    /** A direction above the surface, or null. */
    abstract Vec3 sample(Vec3 out, SplittableRandom random);

    /** The density of {@link #sample} per solid angle. */
    abstract double density(Vec3 out, Vec3 in);

    /** A point of the unit sphere: uniform in the cube until it lies in the ball. */
    static Vec3 onSphere(SplittableRandom random) {
        while (true) {
            double x = 2 * random.nextDouble() - 1;
            double y = 2 * random.nextDouble() - 1;
            double z = 2 * random.nextDouble() - 1;
            double square = x * x + y * y + z * z;
            if (square > 1e-6 && square <= 1) {
                return new Vec3(x, y, z).times(1 / Math.sqrt(square));
            }
        }
    }

    /** A direction with a density of cosine/π: the sphere that touches the surface, seen from where it touches. */
    static Vec3 byCosine(SplittableRandom random) {
        Vec3 onTangentSphere = onSphere(random).plus(Vec3.Z);
        return onTangentSphere.length() > 1e-9 ? onTangentSphere.normalized() : Vec3.Z;
    }

    /** J. H. Lambert, 1760. */
    static final class Lambert extends NaiveReflector {
        private final double[] reflectance;

        Lambert(double[] reflectance) {
            this.reflectance = reflectance;
        }

        @Override
        double value(int band, Vec3 out, Vec3 in) {
            return reflectance[band] / Math.PI;
        }

        @Override
        Vec3 sample(Vec3 out, SplittableRandom random) {
            return byCosine(random);
        }

        @Override
        double density(Vec3 out, Vec3 in) {
            return in.z() / Math.PI;
        }
    }

    /** Portsmouth, Kutz and Hill, "EON: a practical energy-preserving rough diffuse BRDF", 2025. */
    static final class Rough extends NaiveReflector {
        private final double[] reflectance;
        private final double r;
        private final double a;

        Rough(double[] reflectance, double roughness) {
            this.reflectance = reflectance;
            this.r = roughness;
            this.a = 1 / (1 + (0.5 - 2 / (3 * Math.PI)) * r);
        }

        private double single(double mu) {
            double theta = Math.acos(Math.min(1, mu));
            double s = Math.sin(theta);
            double g = s * (theta - s * mu) + 2 / 3.0 * (s / mu * (1 - s * s * s) - s);
            return a + r * a / Math.PI * g;
        }

        @Override
        double value(int band, Vec3 out, Vec3 in) {
            double rho = reflectance[band];
            double s = in.dot(out) - in.z() * out.z();
            double t = s > 0 ? Math.max(in.z(), out.z()) : 1;
            double once = rho / Math.PI * a * (1 + r * s / t);
            double mean = a * (1 + (2 / 3.0 - 28 / (15 * Math.PI)) * r);
            double left = mean >= 1 ? 0 : (1 - single(out.z())) * (1 - single(in.z())) / (1 - mean);
            return once + rho * rho * mean / (1 - rho * (1 - mean)) / Math.PI * left;
        }

        @Override
        Vec3 sample(Vec3 out, SplittableRandom random) {
            if (random.nextBoolean()) {
                return byCosine(random);
            }
            Vec3 any = onSphere(random);
            return any.z() < 0 ? any.negated() : any;
        }

        @Override
        double density(Vec3 out, Vec3 in) {
            return 0.5 * in.z() / Math.PI + 0.5 / (2 * Math.PI);
        }
    }

    /** Reflection by facets with the distribution GGX (Walter and others, 2007), and what Kulla and Conty (2017) add. */
    static final class Facets extends NaiveReflector {
        private final double[] color;
        private final Glossy material;
        private final NaiveFacets facets;
        private final double[] repeated = new double[3];

        Facets(double[] color, Glossy material) {
            this.color = color;
            this.material = material;
            this.facets = new NaiveFacets(NaiveAmount.squared(material.roughness()));
            for (int band = 0; material.multipleScattering() && band < 3; band++) {
                double f = meanFresnel(band);
                double e = facets.meanAlbedo();
                repeated[band] = f * f * e / (1 - f * (1 - e));
            }
        }

        private double fresnel(int band, double cosine) {
            if (material.conductor().isEmpty()) {
                return NaiveFresnel.schlick(cosine, color[band]);
            }
            Glossy.Conductor c = material.conductor().get();
            double[] eta = {c.eta().r(), c.eta().g(), c.eta().b()};
            double[] k = {c.k().r(), c.k().g(), c.k().b()};
            return color[band] * NaiveFresnel.conductor(cosine, eta[band], k[band]);
        }

        private double meanFresnel(int band) {
            int n = 1000;
            double sum = 0;
            for (int i = 0; i < n; i++) {
                double mu = (i + 0.5) / n;
                sum += 2 * mu * fresnel(band, mu) / n;
            }
            return sum;
        }

        @Override
        double value(int band, Vec3 out, Vec3 in) {
            Vec3 m = out.plus(in).normalized();
            double once = fresnel(band, Math.min(1, out.dot(m)))
                    * facets.distribution(m)
                    * facets.visible(out, in)
                    / (4 * out.z() * in.z());
            if (repeated[band] == 0) {
                return once;
            }
            double left = (1 - facets.albedo(out.z())) * (1 - facets.albedo(in.z())) / (1 - facets.meanAlbedo());
            return once + repeated[band] * left / Math.PI;
        }

        @Override
        Vec3 sample(Vec3 out, SplittableRandom random) {
            if (random.nextBoolean()) {
                return byCosine(random);
            }
            Vec3 m = facets.sample(random);
            Vec3 in = m.times(2 * out.dot(m)).minus(out);
            return in.z() > 0 && out.dot(m) > 0 ? in : null;
        }

        @Override
        double density(Vec3 out, Vec3 in) {
            Vec3 m = out.plus(in).normalized();
            return 0.5 * in.z() / Math.PI + 0.5 * facets.distribution(m) * m.z() / (4 * out.dot(m));
        }
    }
}
