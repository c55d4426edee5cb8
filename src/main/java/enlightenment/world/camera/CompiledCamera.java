package enlightenment.world.camera;

import enlightenment.camera.Camera;
import enlightenment.frame.Bounds;
import enlightenment.frame.SceneFrame;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;

/** A camera in the scene's frame: it makes the rays of film positions. Immutable, shared by all threads. */
public abstract sealed class CompiledCamera permits AffineCamera, PanoramaCamera {
    private static final double[] NO_LENS = {};

    /** The picture's width and height in pixels. */
    public final int columns;

    public final int rows;

    CompiledCamera(int columns, int rows) {
        this.columns = columns;
        this.rows = rows;
    }

    /**
     * The camera in a frame whose origin is {@link Camera#origin}.
     *
     * @param width the picture's width in pixels
     * @param height its height; cameras without a window take the aspect ratio from the picture
     */
    public static CompiledCamera of(Camera camera, SceneFrame frame, int width, int height) {
        return camera instanceof Camera.Panorama p
                ? PanoramaCamera.compile(p, frame, width, height)
                : AffineCamera.compile(camera, frame, width, height);
    }

    /** This camera with a pinhole in place of its lens, for classic shading. */
    public abstract CompiledCamera withoutLens();

    /** Whether the camera has a lens of positive size, so that a film position has many rays. */
    public abstract boolean hasLens();

    /**
     * Whether each film position has one ray and lines project to lines: then the rays of a tile lie within four planes through those at
     * its corners, and the image of a polygon is a polygon.
     */
    public abstract boolean isPinholeOrParallel();

    /**
     * Sets the ray of a film position, through the middle of the lens if there is one.
     *
     * @param x 0..1 from the picture's left side
     * @param y 0..1 from its upper side
     */
    public abstract void ray(double x, double y, Ray ray);

    /**
     * Sets the ray of a film position through a sampled point of the lens; without a lens as {@link #ray(double, double, Ray)}.
     *
     * @param sampler of the path, which has the point's random numbers
     */
    public abstract void ray(double x, double y, Sampler sampler, Ray ray);

    /** A box around the origins of all rays, in the frame. */
    public abstract Bounds startBounds();

    /** The origins of all rays. */
    public abstract RayStarts rayStarts();

    /**
     * Of a camera whose rays through the middle of the lens are linear in the film position (x, y): the ray's origin and its derivatives by
     * x and y, its direction likewise, and the t that it starts at. Null for others.
     */
    public double[] linearForm() {
        return null;
    }

    /**
     * The lens of such a camera, as vectors of the frame and numbers: the radius to the right and upwards, both over the distance of the
     * plane in focus, and the x and then the y of the aperture's corners, of which the first is also the last; no corners of a disk. Empty
     * without a lens.
     */
    public double[] lensForm() {
        return NO_LENS;
    }
}
