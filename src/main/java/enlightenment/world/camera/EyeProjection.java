package enlightenment.world.camera;

import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Ray;

/**
 * Where in the picture the camera sees a point, and how much of the picture light that leaves it covers: the camera's rays the other way
 * round, for paths that come from a light. A mutable work object, one per thread.
 *
 * <p>Cameras whose rays start in several places, on a lens or at two eyes, are projected to from one of these at a time, chosen by
 * {@link #sampleStart}: then {@link #importance} is the share of the picture over the probability of the choice. For a lens of area A the
 * importance of PBRT's thin lens camera, which is 1/A times that of a pinhole, is divided by the density 1/A (M. Pharr, W. Jakob and
 * G. Humphreys, "Physically based rendering", section 16.1).
 */
public abstract sealed class EyeProjection permits AffineProjection, PanoramaProjection {
    static final double ERROR = Scale.gamma(64);

    /** The place in the picture, 0..1 from the left. */
    public double x;

    /** From above, 0..1. */
    public double y;

    /** The vector from the point to where the camera's ray begins: what lies between hides the point. */
    public double toEyeX;

    public double toEyeY;
    public double toEyeZ;

    /** How far that vector's end may be from there by rounding, or a surface that the camera's ray begins on: a generous bound. */
    public double error;

    /** The unit vector in that direction. */
    public double dx;

    public double dy;
    public double dz;

    /**
     * The factor that turns β·f·cosθ at the point into the contribution to the picture ({@code SplatBatch.add}): for a light path of
     * power β at a surface with BSDF f towards the eye, θ the angle between that direction and the normal. It is picture area (1 for the
     * whole picture) per area perpendicular to the connection: |g|³/(|det(g₀, gₓ, g_y)| d²) for an eye at distance d in the frame,
     * |g|/|det(g, oₓ, o_y)| for parallel rays, 1/(2π² cosθ d²) at latitude θ of a panorama.
     */
    public double importance;

    EyeProjection() {}

    /** For the camera of a scene. */
    public static EyeProjection of(CompiledCamera camera) {
        return camera instanceof PanoramaCamera p
                ? new PanoramaProjection(p)
                : new AffineProjection((AffineCamera) camera);
    }

    /** Whether rays of one point of the scene start in several places, so that {@link #sampleStart} must choose one. */
    public abstract boolean hasSeveralStarts();

    /**
     * Chooses where on the lens, or at which of two eyes, connections end from now on.
     *
     * @param u a random number, 0..1
     * @param v another one
     */
    public abstract void sampleStart(double u, double v);

    /** Lets {@link #importanceOf} refer to the place on the lens, or the eye, that a camera ray starts at. */
    public abstract void startWith(Ray camera);

    /**
     * Projects a point of the frame.
     *
     * @return whether it lies where the camera's rays go, within the picture; otherwise what was set is of no use
     */
    public abstract boolean project(double px, double py, double pz);

    /**
     * Where a point of the frame appears, in the picture or beside it, whether it can be seen or not.
     *
     * @return whether it lies before the eye; parallel rays and panoramas have everything before them
     */
    public abstract boolean place(double px, double py, double pz);

    /** The eye, in the frame, where all rays come from one; of parallel rays where that of the picture's upper left corner starts. */
    public abstract Vec3 start();

    /** Whether all rays have the same direction. */
    public abstract boolean isParallel();

    /** The {@link #importance} of a point that the camera is known to see. */
    public abstract double importanceOf(double px, double py, double pz);
}
