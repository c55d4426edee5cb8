package enlightenment.transport.image;

import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.ray.Shader;
import enlightenment.transport.state.PathState;
import enlightenment.transport.state.PathStrategy;
import enlightenment.transport.state.PathValue;
import enlightenment.transport.state.PathVertex;
import enlightenment.world.CompiledScene;
import enlightenment.world.camera.EyeProjection;
import enlightenment.world.light.ClippedPolygon;
import enlightenment.world.light.LightImage;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.parts.RayCounters;

/**
 * Emission that the eye sees directly, in pixels that a light's image covers in part. The samples of a pixel may all miss the image, and
 * neither picture nor error estimate would show it. So every sample takes a second film position within the image's part of the pixel, and
 * emission of that light seen from the first position counts only outside of the image: each path is sampled exactly once, whatever polygon
 * stands for the image. See docs/notes/path-tracing.md. A mutable work object, one per thread.
 */
public final class EyeImages implements PathStrategy {
    /** Direct-mapped cache of 64 × 64 pixels: render blocks are no larger. */
    private static final int CACHE_SIDE = 64;

    /** A part of a pixel, far more than by how much the projection of a camera ray misses the position that it was made for. */
    private static final double BORDER = 0x1p-20;

    private final CompiledScene scene;
    private final PathFollower path;
    private final EyeProjection eye;

    /** Determines the medium in which rays start; null if all start outside of all solids. */
    private final PathFollower starts;

    private final Ray ray = new Ray();
    private final Hit met = new Hit();
    private final double[] pair = new double[2];
    private final ClippedPolygon work = new ClippedPolygon();

    /** All light images of the picture. */
    private final LightImage[] all;

    /** The light images that reach into the tile. */
    private final LightImage[] near;

    private int nearCount;

    /** Cached parts of images by pixel, a function of the pixel alone. */
    private final PixelImages[] pixels;

    /** The parts of images in the path's pixel. */
    private PixelImages here;

    /** The film position of the camera ray, in pixels. */
    private double x;

    private double y;

    /** The number of image parts in the path's pixel. */
    private int count;

    /** Whether the path began in empty space. */
    private boolean isOutside;

    /** The estimate of {@link #gather(Sampler)}: radiance at the eye. */
    public double red;

    public double green;
    public double blue;

    /**
     * @param isWanted whether emission that the eye sees directly is included
     */
    public EyeImages(CompiledScene scene, RayCounters counters, PathFollower path, boolean isWanted) {
        this.scene = scene;
        this.path = path;
        eye = EyeProjection.of(scene.camera);
        starts = scene.cameraSolids.length == 0 ? null : new PathFollower(scene, counters, 0);
        all = isWanted ? scene.lightImages : new LightImage[0];
        near = new LightImage[all.length];
        pixels = new PixelImages[all.length == 0 ? 0 : CACHE_SIDE * CACHE_SIDE];
    }

    /** Sets the tile of the camera rays to come, as {@link Shader#beginTile}. */
    public void beginTile(double x0, double y0, double x1, double y1) {
        double columns = scene.camera.columns;
        double rows = scene.camera.rows;
        nearCount = 0;
        for (LightImage image : all) {
            if (image.reaches(x0 * columns - 1, y0 * rows - 1, x1 * columns + 1, y1 * rows + 1)) {
                near[nearCount++] = image;
            }
        }
    }

    /** Whether any path that begins in a tile may show an image. */
    public boolean mayShow() {
        return nearCount > 0;
    }

    /**
     * Whether a path may show an image that begins at a position on the film of the tile, in pixels, or as near to it as rounding may move
     * that.
     */
    public boolean mayShow(double filmX, double filmY) {
        for (int k = 0; k < 4 && nearCount > 0; k++) {
            int column = (int) (filmX + ((k & 1) == 0 ? -BORDER : BORDER));
            int row = (int) (filmY + ((k & 2) == 0 ? -BORDER : BORDER));
            if (pixel(column, row).count > 0) {
                return true;
            }
        }
        return false;
    }

    /** Begins a path at a camera ray of the tile. */
    public void begin(Ray camera) {
        count = 0;
        if (nearCount == 0) {
            return;
        }
        eye.place(camera.ox + camera.dx, camera.oy + camera.dy, camera.oz + camera.dz);
        x = eye.x * scene.camera.columns;
        y = eye.y * scene.camera.rows;
        here = pixel((int) x, (int) y);
        count = here.count;
        // Images are those seen through empty space; a path that starts in a medium keeps its emission.
        isOutside = starts == null || path.medium() == null;
    }

    private PixelImages pixel(int column, int row) {
        int at = row % CACHE_SIDE * CACHE_SIDE + column % CACHE_SIDE;
        PixelImages known = pixels[at];
        if (known == null || known.column != column || known.row != row) {
            known = PixelImages.of(column, row, near, nearCount, work);
            pixels[at] = known;
        }
        return known;
    }

    /** Adds the light of one sampled image of the pixel to a path that has just begun. */
    public void gather(Sampler sampler, PathValue value) {
        if (gather(sampler)) {
            value.add(red, green, blue);
        }
    }

    /** Samples one image of the pixel and estimates its radiance at the eye; returns whether there is any. */
    public boolean gather(Sampler sampler) {
        if (count == 0) {
            return false;
        }
        sampler.pair(0, Sampler.Purpose.MIRROR, pair);
        here.choose(pair[0], pair[1]);
        ImagePart part = here.chosen;
        scene.camera.ray(part.placeX / scene.camera.columns, part.placeY / scene.camera.rows, ray);
        if (starts != null) {
            starts.beginAgain(ray);
            if (starts.medium() != null) {
                return false;
            }
        }
        int light = part.image.light;
        boolean isMet = path.tracer.meetsLight(ray, met, light);
        if (isMet) {
            PhysicalLight l = scene.physical.lights[light];
            red = here.share * l.r;
            green = here.share * l.g;
            blue = here.share * l.b;
        }
        return isMet;
    }

    /** Adds nothing: {@link #gather} adds directly visible emission once for each path. */
    @Override
    public void direct(PathVertex vertex, PathState state, Sampler sampler, PathValue value) {}

    @Override
    public double weightOfHit(PathState state, Ray camera, int light) {
        return weight();
    }

    /** The MIS weight, 0 or 1, of emission of the current surface: 0 if the eye sees it directly within an image that is sampled. */
    public double weight() {
        if (count > 0 && isOutside && path.surfaces == 0) {
            int lamp = path.at.light;
            int at = here.firstOf(lamp);
            for (ImagePart part = here.of(lamp, at); part != null; part = here.of(lamp, ++at)) {
                if (part.contains(x, y)) {
                    return 0;
                }
            }
        }
        return 1;
    }
}
