package enlightenment.physical;

import enlightenment.color.Rgb;
import enlightenment.material.Coated;
import enlightenment.material.Glossy;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import enlightenment.math.Vec3;
import java.util.SplittableRandom;

/** Metal and a coated base side by side, under a clear coat: the sum of the reflectors that they are alone. */
final class NaivePrincipled extends NaiveReflector {
    private static final int STEPS = 2_000;
    private static final int NODES = 40;
    private static final int SIDE = 100;

    private final double[] color;
    private final double metallic;
    private final double clearShare;
    private final NaiveCoat clear;
    private final NaiveCoat coat;

    /** Null where it is smooth. */
    private final NaiveReflector metal;

    private final double mean;
    private final Principled.Sheen sheen;
    private final double[] fibres = new double[NODES + 1];

    NaivePrincipled(double[] color, Principled p) {
        this.color = color;
        metallic = ((Texture.Amount.Constant) p.metallic()).value();
        double root = (p.indexOfRefraction() - 1) / (p.indexOfRefraction() + 1) * Math.sqrt(p.specular());
        double index = (1 + root) / (1 - root);
        coat = new NaiveCoat(color, new Coated(p.color(), p.roughness(), index, false, Rgb.BLACK, 0));
        clear = new NaiveCoat(
                color, Coated.of(p.color(), 0).withRoughness(p.clearcoat().roughness()));
        clearShare = p.clearcoat().share();
        sheen = p.sheen();
        for (int k = 0; k <= NODES; k++) {
            fibres[k] = sheen.share() * albedo((double) k / NODES);
        }
        metal = coat.isSmooth()
                ? null
                : new Facets(color, Glossy.of(p.color(), 1).withRoughness(p.roughness()));
        double sum = 0;
        for (int i = 0; i < STEPS; i++) {
            double mu = (i + 0.5) / STEPS;
            sum += 2 * mu * passing(mu) * coat.through(mu) / STEPS;
        }
        mean = sum;
    }

    /** Of sheen of share 1 in white, from a cosine: over directions evenly spread by their cosine. */
    private static double albedo(double mu) {
        Vec3 out = new Vec3(Math.sqrt(1 - mu * mu), 0, mu);
        double sum = 0;
        for (int i = 0; i < SIDE; i++) {
            double r = Math.sqrt((i + 0.5) / SIDE);
            for (int j = 0; j < SIDE; j++) {
                double turn = 2 * Math.PI * (j + 0.5) / SIDE;
                Vec3 in = new Vec3(r * Math.cos(turn), r * Math.sin(turn), Math.sqrt(1 - r * r));
                sum += Math.PI * fibre(out, in) / (SIDE * SIDE);
            }
        }
        return sum;
    }

    private static double fibre(Vec3 out, Vec3 in) {
        return Math.pow(1 - in.dot(out.plus(in).normalized()), 5);
    }

    /** What the sheen lets pass. */
    private double uncovered(double mu) {
        int k = Math.min(NODES - 1, (int) (mu * NODES));
        return 1 - (fibres[k] + (mu * NODES - k) * (fibres[k + 1] - fibres[k]));
    }

    private double tinted(int band) {
        double most = Math.max(color[0], Math.max(color[1], color[2]));
        return most == 0 ? 1 : 1 - sheen.tint() + sheen.tint() * color[band] / most;
    }

    /** What the clear coat lets pass. */
    private double passing(double mu) {
        return 1 - clearShare * (1 - clear.through(mu));
    }

    /** Whether something of it is smooth. */
    boolean hasMirror() {
        return metal == null || clearShare > 0 && clear.isSmooth();
    }

    /** What is seen of the mirror image. */
    double[] mirrored(double cosine) {
        double[] share = new double[3];
        for (int band = 0; band < 3; band++) {
            double below = (1 - metallic) * uncovered(cosine) * coat.fresnel(cosine)
                    + metallic * NaiveFresnel.schlick(cosine, color[band]);
            share[band] = (clear.isSmooth() ? clearShare * clear.fresnel(cosine) : 0)
                    + (metal == null ? passing(cosine) * below : 0);
        }
        return share;
    }

    @Override
    double value(int band, Vec3 out, Vec3 in) {
        double sum = clear.isSmooth() ? 0 : clearShare * clear.lobe(out, in);
        double a = passing(out.z());
        double b = passing(in.z());
        double q = Math.min(uncovered(out.z()), uncovered(in.z()));
        sum += Math.min(a, b) * (1 - metallic) * sheen.share() * tinted(band) * fibre(out, in);
        if (metal != null) {
            double below = (1 - metallic) * q * coat.lobe(out, in) + metallic * metal.value(band, out, in);
            sum += Math.min(a, b) * below;
        }
        double base = q * a * b * coat.through(out.z()) * coat.through(in.z()) / (Math.PI * mean);
        return sum + (1 - metallic) * color[band] * base;
    }

    @Override
    Vec3 sample(Vec3 out, SplittableRandom random) {
        return (metal == null ? clear : metal).sample(out, random);
    }

    @Override
    double density(Vec3 out, Vec3 in) {
        return (metal == null ? clear : metal).density(out, in);
    }
}
