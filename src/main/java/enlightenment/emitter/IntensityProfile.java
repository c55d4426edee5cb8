package enlightenment.emitter;

import enlightenment.math.Vec3;
import java.util.Arrays;

/**
 * The dependence of a point light's radiant intensity on direction, relative to its largest value: 0..1 by band. Directions are unit
 * vectors away from the light, in the frame of a render (which scales and translates scenes, and does not rotate them). Immutable, shared
 * by threads.
 */
public sealed interface IntensityProfile permits SpotProfile, TableProfile, PictureProfile {
    /**
     * The relative intensity of a direction, by band; by default the luminance for all bands.
     *
     * @param rgb receives red, green and blue, 0..1
     */
    default void intensity(double dx, double dy, double dz, double[] rgb) {
        Arrays.fill(rgb, luminance(dx, dy, dz));
    }

    /** The luminance of the relative intensity of a direction, 0..1: 0 only if every band is 0. */
    double luminance(double dx, double dy, double dz);

    /**
     * Samples a direction in proportion to {@link #luminance}, or approximately so: wherever the intensity is not 0, the density is
     * greater than 0.
     *
     * @param u uniform in [0, 1)
     * @param v uniform in [0, 1), independent of u
     * @param out receives the unit vector away from the light
     * @return its density per solid angle, as {@link #density}; 0 if there is no sample
     */
    double sample(double u, double v, double[] out);

    /** The density per solid angle with which {@link #sample} samples a direction. */
    double density(double dx, double dy, double dz);

    /** The integral of {@link #luminance} over all directions, in steradians: 0..4π. */
    double solidAngle();

    /** The unit axis of a cone that contains all directions with an intensity above 0. */
    Vec3 axis();

    /** The angle between the axis of that cone and its side, in radians: 0..π. */
    double coneAngle();

    /** The numbers that define the profile, in a fixed order: profiles of a class are equal if these are. */
    double[] parameters();
}
