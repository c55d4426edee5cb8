package enlightenment.bsdf;

/** A fixed quadrature over the normals of facets visible from a direction, for the mean loss of light at one facet. */
abstract class VisibleNormals {
    final Microfacets facets;

    /** How uniformly the loss varies over cosines: 0 if mostly at grazing directions, 1 if nowhere in particular. */
    final double even;

    /** Whether tables interpolate the albedo relative to {@link #keptBySmooth}. */
    final boolean isRelative;

    private final int rings;
    private final double[] cosines;

    /** Makes a quadrature over rings and sectors of a half disk, in which visible normals are uniform. */
    VisibleNormals(Microfacets facets, double even, boolean isRelative, int rings, int sectors) {
        this.isRelative = isRelative;
        this.facets = facets;
        this.even = even;
        this.rings = rings;
        cosines = new double[sectors];
        for (int j = 0; j < sectors; j++) {
            cosines[j] = StrictMath.cos(Math.PI * (j + 0.5) / sectors);
        }
    }

    /**
     * The share of light from o that is lost at a facet whose normal is along a vector m.
     *
     * @param out the cosine between o and the surface's normal
     * @param along o·m
     * @param z the component of m along the surface's normal
     * @param length2 m·m
     */
    abstract double lost(double out, double along, double z, double length2);

    /** The albedo of a smooth surface at a cosine, greater than 0: the part of the albedo that varies faster than roughness makes it. */
    double keptBySmooth(double cosine) {
        return 1;
    }

    /** 1 over the index of refraction of the smooth coat that {@link #keptBySmooth} is about; 1 if there is none. */
    double etaOfSmooth() {
        return 1;
    }

    /**
     * The mean loss over the normals visible from a direction. Rings are dense at the edge of the disk, 1 − r² = w⁴ with w uniform: there
     * are the few steep normals at which a smooth surface loses light.
     *
     * @param out the cosine of the direction
     */
    final double meanLoss(double out) {
        double sine = Math.sqrt((1 - out) * (1 + out));
        double x = facets.alpha * sine;
        double scale = 1 / Math.sqrt(Math.fma(x, x, out * out));
        double k = Math.fma(out, scale, 1);
        double total = 0;
        for (int i = 0; i < rings; i++) {
            double w = (i + 0.5) / rings;
            double edge = w * w * w * w;
            double q = Math.sqrt(k * Math.max(2 - (1 - edge) * k, 0) * (1 - edge));
            double ring = 0;
            for (double c : cosines) {
                ring += lost(out, sine, x * scale + q * c, q * q * (1 - c) * (1 + c), k * edge);
            }
            total += 4 * w * w * w * ring;
        }
        return Math.min(total / (rings * cosines.length), 1);
    }

    /** The loss at the normal of slopes αx and αy over z, with y squared. */
    private double lost(double out, double sine, double x, double y2, double z) {
        double alpha = facets.alpha;
        double hx = alpha * x;
        double length2 = Math.fma(hx, hx, Math.fma(z, z, alpha * alpha * y2));
        return lost(out, Math.fma(sine, hx, out * z), z, length2);
    }

    /** Facets that are perfect mirrors. */
    static final class OfMirrors extends VisibleNormals {
        OfMirrors(Microfacets facets) {
            super(facets, 0, false, 128, 64);
        }

        @Override
        double lost(double out, double along, double z, double length2) {
            double in = 2 * along * z / length2 - out;
            return in > 0 ? facets.shadowed(Math.min(in, 1), out) : 1;
        }
    }

    /** Facets of a dielectric coat: the loss is what they do not reflect. */
    static final class OfCoat extends VisibleNormals {
        private final double eta;

        /** @param eta the index on the side of arrival over that of the coat */
        OfCoat(Microfacets facets, double eta) {
            super(facets, 0.5, true, 128, 32);
            this.eta = eta;
        }

        @Override
        double keptBySmooth(double cosine) {
            return DielectricFresnel.reflectance(cosine, eta);
        }

        @Override
        double etaOfSmooth() {
            return eta;
        }

        @Override
        double lost(double out, double along, double z, double length2) {
            double in = 2 * along * z / length2 - out;
            if (!(in > 0)) {
                return 1;
            }
            double facet = Math.min(Math.max(along / Math.sqrt(length2), 0), 1);
            double kept = 1 - facets.shadowed(Math.min(in, 1), out);
            return 1 - DielectricFresnel.reflectance(facet, eta) * kept;
        }
    }

    /** Facets that are the interface of two media. */
    static final class OfInterface extends VisibleNormals {
        private final double eta;

        /** @param eta the index on the side of arrival over that of the other side */
        OfInterface(Microfacets facets, double eta) {
            // The loss varies near the angle of total internal reflection as well.
            super(facets, 0.5, false, 128, 32);
            this.eta = eta;
        }

        @Override
        double lost(double out, double along, double z, double length2) {
            double scale = 1 / Math.sqrt(length2);
            double facet = Math.min(Math.max(along * scale, 0), 1);
            double up = z * scale;
            double in = 2 * facet * up - out;
            double reflected = in > 0 ? facets.shadowed(Math.min(in, 1), out) : 1;
            double through2 = DielectricFresnel.refracted2(facet, eta);
            if (!(through2 >= 0)) {
                return reflected;
            }
            double share = DielectricFresnel.reflectance(facet, eta);
            double below = Math.fma(eta, out - facet * up, Math.sqrt(through2) * up);
            double refracted = below > 0 ? facets.shadowed(Math.min(below, 1), out) : 1;
            return Math.fma(share, reflected - refracted, refracted);
        }
    }
}
