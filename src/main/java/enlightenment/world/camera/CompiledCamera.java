package enlightenment.world.camera;

import enlightenment.camera.Camera;
import enlightenment.frame.Bounds;
import enlightenment.frame.SceneFrame;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;

/** A camera in the scene's frame: it makes the rays of film positions. Immutable, shared by all threads. */
public abstract sealed class CompiledCamera permits AffineCamera, PanoramaCamera {
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

    /** This camera with a pinhole in place of its lens, as classic shading has it. */
    public abstract CompiledCamera withoutLens();

    /** Whether a film position has many rays, which pass a lens of some size. */
    public abstract boolean hasLens();

    /**
     * Whether each film position has one ray and lines are seen as lines: the rays of a tile lie within four planes through those at its
     * corners, and the image of a polygon is a polygon.
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
     * Sets the ray of a film position through a point of the lens; {@link #ray(double, double, Ray)} if there is none.
     *
     * @param sampler of the path, which gives the point's numbers
     */
    public abstract void ray(double x, double y, Sampler sampler, Ray ray);

    /** A box around the places where rays start. */
    public abstract Bounds startBounds();

    /** The places where rays start. */
    public abstract RayStarts rayStarts();

    /**
     * Of a camera without a lens whose rays depend on the position (x, y) linearly: the ray's origin and what x and y add to it, its
     * direction likewise, and the t that it starts at. Null for others.
     */
    public double[] linearForm() {
        return null;
    }
}
