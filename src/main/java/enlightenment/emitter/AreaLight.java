package enlightenment.emitter;

import enlightenment.math.Vec3;

/**
 * A light with extent, or an emitting face of an object, in the frame of a render, for physical shading. Radiance is not part of it: closed
 * forms are for radiance 1. Immutable, shared by threads; what depends on the receiver is in a {@link LightSample}, which must have been
 * {@link #aim aimed}.
 *
 * <p>Occlusion of a sampled point, by the light itself or by others, is left to the caller's shadow ray.
 */
public sealed interface AreaLight permits SphereLight, SurfaceLight {
    /** Prepares samples of this light for the receiver (x, y, z), and sets the sample's cone around the light's ball. */
    void aim(LightSample s, double x, double y, double z);

    /**
     * Samples a point of the light and sets {@link LightSample#dx} and so on (unit direction to it), {@link LightSample#length} (distance
     * in the frame), {@link LightSample#pdf} (per solid angle at the receiver) and {@link LightSample#cosine}. The pdf is 0 if there is no
     * sample: the receiver is inside a sphere, in the plane of a flat light or on a side of it that does not shine, or the point faces away from it.
     *
     * @param u with v a uniform point of the unit square
     */
    void sample(LightSample s, double u, double v);

    /**
     * The density, per solid angle at the receiver, with which {@link #sample} samples a direction that is known to hit the light, as
     * multiple importance sampling needs it: up to rounding the {@link LightSample#pdf} of the same direction. Does not include the choice
     * of the light.
     *
     * @param dx with dy and dz the unit direction from the receiver
     * @param distance from the receiver to the hit, in units of the frame
     * @param cosine at the hit, as {@link LightSample#cosine}
     * @return 0 for directions that are never chosen
     */
    double pdf(LightSample s, double dx, double dy, double dz, double distance, double cosine);

    /**
     * The unoccluded irradiance at a receiver with the unit normal n for radiance 1, 0..π (sr, projected solid angle): the integral of
     * the cosine over the directions of the light above the receiver's horizon.
     *
     * @return NaN if there is no closed form
     */
    double irradiance(LightSample s, double nx, double ny, double nz);

    /**
     * Whether light may reach a receiver with the unit normal n: false if the receiver is behind the light, or the light below the horizon,
     * where {@link #irradiance} is 0, up to rounding. Cheaper than that, and a function of receiver and light alone.
     */
    default boolean reaches(LightSample s, double nx, double ny, double nz) {
        return irradiance(s, nx, ny, nz) != 0;
    }

    /** Whether {@link #irradiance} is a number for all receivers; for a ball, for all outside of it. */
    default boolean hasClosedForm() {
        return false;
    }

    /**
     * As {@link #sample}, but where {@link #samplesByCosine} holds with a density proportional to the cosine with the unit normal n;
     * {@link LightSample#pdf} is the density, per solid angle, of the strategy that was used.
     */
    default void sampleByCosine(LightSample s, double nx, double ny, double nz, double u, double v) {
        sample(s, u, v);
    }

    /** Whether {@link #sampleByCosine} samples in proportion to the cosine: then its density is the cosine over {@link #irradiance}. */
    default boolean samplesByCosine(LightSample s, double nx, double ny, double nz) {
        return false;
    }

    /** The area of one side, in squared units of the frame. */
    double area();

    /** Whether a flat light or a curved surface emits from both of its sides. */
    boolean isTwoSided();

    /** Samples a point uniformly over the area, for (u, v) in the unit square, with its normal. */
    void samplePoint(double u, double v, SurfacePoint point);

    /** The centre of the bounding ball. */
    Vec3 ballCenter();

    /** The radius of the bounding ball. */
    double ballRadius();

    /** The unit normal of a flat light, on its front unless only its back emits; the zero vector for a light that is not flat. */
    Vec3 flatNormal();

    /** The numbers that define the light, in a fixed order: lights of a kind are equal if these are. */
    double[] parameters();
}
