package enlightenment.emitter;

import enlightenment.math.Vec3;

/**
 * The form of a light of classic shading, in the frame of a render; {@link AreaLight} is that of physical shading. Immutable, shared by
 * threads; what depends on the viewer is in an {@link EmitterView}, which must have been aimed at the emitter.
 */
public sealed interface Emitter permits SphereEmitter, RectangleEmitter, PointEmitter {
    /** The centre of the bounding ball. */
    Vec3 ballCenter();

    /** The radius of the bounding ball. */
    double ballRadius();

    /**
     * Whether it has no extent: then all its samples are one point, and densities are with respect to the discrete measure, not to solid
     * angle.
     */
    boolean isDelta();

    /** Sets direction and length of the view to the point for (u, v) in the unit square. */
    void sample(EmitterView view, double u, double v);

    /**
     * The density with which {@link #sample} chose the view's direction: per solid angle, or 1 if {@link #isDelta}. Infinite where the
     * emitter is seen edge-on, and covers no solid angle; 0 for a viewer at the very point.
     */
    double pdf(EmitterView view);

    /**
     * The density per solid angle with which {@link #sample} selects the unit direction (x, y, z): up to rounding {@link #pdf(EmitterView)}
     * of a sampled direction; 0 for one that misses the emitter, and if {@link #isDelta}.
     */
    double pdf(EmitterView view, double x, double y, double z);

    /**
     * The exact mean over the emitter's solid angle of the cosine between direction and unit normal n, clamped at 0: 0 if all of it is
     * below the horizon; a closed form if all is above it and there is one; NaN otherwise.
     */
    double meanCosine(EmitterView view, double nx, double ny, double nz);

    /** Prepares {@link #sampleByCosine} and {@link #sampleDisk} for a normal whose {@link #meanCosine} is above 0. */
    void prepareByCosine(EmitterView view, double nx, double ny, double nz);

    /** As {@link #sample}, with the density of {@link #pdf} times the cosine over the mean cosine. */
    void sampleByCosine(EmitterView view, double u, double v);

    /**
     * As {@link #sampleByCosine} for a position (p, q) in the unit disk itself, whose axes do not turn with the normal, so that
     * neighbouring viewers see the same part of the emitter at nearly the same position.
     */
    void sampleDisk(EmitterView view, double p, double q);
}
