package enlightenment.world.camera;

import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Ray;

/**
 * Projects points onto the film and computes the camera's importance: the inverse of its rays, for light paths connected to the eye. A
 * mutable work object, one per thread.
 *
 * <p>Of cameras whose rays start in several places, on a lens or at two eyes, one place is used at a time, sampled by {@link #sampleStart}:
 * then {@link #importance} is divided by the probability of the choice. For a lens of area A the importance of PBRT's thin lens camera,
 * which is 1/A times that of a pinhole, is divided by the density 1/A (M. Pharr, W. Jakob and G. Humphreys, "Physically based rendering",
 * section 16.1).
 */
public abstract sealed class EyeProjection permits AffineProjection, PanoramaProjection {
    static final double ERROR = Scale.gamma(64);

    /** The film position, 0..1 from the left. */
    public double x;

    /** The film position, 0..1 from above. */
    public double y;

    /** The vector from the point to the origin of the camera's ray: a surface in between occludes the point. */
    public double toEyeX;

    public double toEyeY;
    public double toEyeZ;

    /**
     * A generous bound of the distance, by rounding, between that vector's end and the ray's origin, or a surface that the ray begins on.
     */
    public double error;

    /** The unit vector from the point to the origin of the camera's ray. */
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

    /** Whether the camera's rays start in several places for one point of the scene, so that {@link #sampleStart} must choose one. */
    public abstract boolean hasSeveralStarts();

    /**
     * Samples the point of the lens, or one of two eyes, at which connections end from now on.
     *
     * @param u uniform in 0..1
     * @param v uniform in 0..1
     */
    public abstract void sampleStart(double u, double v);

    /** Sets the point of the lens, or the eye, to that of a camera ray, for {@link #importanceOf}. */
    public abstract void startWith(Ray camera);

    /**
     * Projects a point of the frame and computes its importance.
     *
     * @return whether it is within the picture, before the start of the camera's rays; if not, the fields are of no use
     */
    public abstract boolean project(double px, double py, double pz);

    /**
     * Projects a point of the frame to a film position, in the picture or beside it, visible or not.
     *
     * @return whether it lies before the eye; always true for parallel rays and panoramas
     */
    public abstract boolean place(double px, double py, double pz);

    /** The eye, in the frame, where all rays start at one point; of parallel rays the origin of that at the picture's upper left corner. */
    public abstract Vec3 start();

    /** Whether all rays have the same direction. */
    public abstract boolean isParallel();

    /** The {@link #importance} of a point that is known to be visible from the camera. */
    public abstract double importanceOf(double px, double py, double pz);
}
