package enlightenment.shading;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.EyeProjection;
import enlightenment.compiled.PhysicalLight;
import enlightenment.compiled.RayCounters;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;

/**
 * The light that the eye has straight from lights, or by way of one mirror or reflection at glass, where their images are smaller than a pixel. Samples of a
 * pixel may all miss such an image, and then nothing tells of it; however bright the lamp is, it is missing. So every sample takes a second
 * place on the film, in a box around what of the image is in the pixel, and what the first place sees of the image does not count: all
 * light is found exactly once, whatever the box is. See docs/path-tracing.md. A mutable work object, one per thread.
 */
final class EyeImages {
    private static final int NONE = -1;
    private static final int NUMBERS = 4;

    private final CompiledScene scene;
    private final PathFollower path;
    private final EyeProjection eye;
    private final MirroredLight light;
    private final SmallImage[] all;
    private final Ray ray = new Ray();
    private final double[] pair = new double[2];

    /** Those of the tile. */
    private final SmallImage[] near;

    private int nearCount;

    /** Those of the pixel, and their boxes. */
    private final SmallImage[] here;

    private final double[] boxes;
    private int hereCount;

    /** The pixel, which the last path began in. */
    private int column;

    private int row;

    /** Where on the film the path began, in pixels. */
    private double x;

    private double y;

    /** How many images count for the path. */
    private int count;

    /** The first mirror that reflected the path, if that was its first event. */
    private int mirror;

    private int face;

    /** What was gathered. */
    double red;

    double green;
    double blue;

    /** @param isWanted whether the light is wanted that the eye sees so */
    EyeImages(CompiledScene scene, RayCounters counters, PathFollower path, boolean isWanted) {
        this.scene = scene;
        this.path = path;
        eye = new EyeProjection(scene.camera);
        light = new MirroredLight(scene, counters, path.tracer);
        all = isWanted ? SmallImages.of(scene) : new SmallImage[0];
        near = new SmallImage[all.length];
        here = new SmallImage[all.length];
        boxes = new double[NUMBERS * all.length];
    }

    /** Sets the tile of the paths to come, as {@link Shader#beginTile}. */
    void beginTile(double x0, double y0, double x1, double y1) {
        double columns = scene.camera.columns;
        double rows = scene.camera.rows;
        nearCount = 0;
        for (SmallImage image : all) {
            if (image.reaches(x0 * columns - 1, y0 * rows - 1, x1 * columns + 1, y1 * rows + 1)) {
                near[nearCount++] = image;
            }
        }
        column = NONE;
    }

    /** Begins with a camera ray of the tile, which the path has begun with. */
    void begin(Ray camera) {
        count = 0;
        // In a medium absorption counts as well: left to chance.
        if (nearCount == 0 || path.medium() != null) {
            return;
        }
        mirror = NONE;
        eye.place(camera.ox + camera.dx, camera.oy + camera.dy, camera.oz + camera.dz);
        x = eye.x * scene.camera.columns;
        y = eye.y * scene.camera.rows;
        if ((int) x != column || (int) y != row) {
            column = (int) x;
            row = (int) y;
            enterPixel();
        }
        count = hereCount;
    }

    private void enterPixel() {
        hereCount = 0;
        for (int k = 0; k < nearCount; k++) {
            if (near[k].clip(column, row, boxes, NUMBERS * hereCount)) {
                here[hereCount++] = near[k];
            }
        }
    }

    /** Adds the light of one of the pixel's images to a path that has just begun. */
    void gather(Sampler sampler, PathValue value) {
        if (gather(sampler)) {
            value.add(red, green, blue);
        }
    }

    /** Gathers the light of one of the pixel's images: radiance towards the eye. Returns whether there is any. */
    boolean gather(Sampler sampler) {
        if (count == 0) {
            return false;
        }
        sampler.pair(0, Sampler.Purpose.MIRROR, pair);
        double place = pair[0] * count;
        int k = Math.min((int) place, count - 1);
        SmallImage image = here[k];
        int at = NUMBERS * k;
        double width = boxes[at + 2] - boxes[at];
        double height = boxes[at + 3] - boxes[at + 1];
        scene.camera.ray(
                Math.fma(place - k, width, boxes[at]) / scene.camera.columns,
                Math.fma(pair[1], height, boxes[at + 1]) / scene.camera.rows,
                ray);
        boolean isStraight = image.mirror == SmallImage.STRAIGHT;
        boolean isMet = isStraight
                ? light.isMetBy(ray, image.light)
                : light.isMetBy(ray, image.mirror, image.face, image.light);
        if (isMet) {
            PhysicalLight l = scene.physical.lights[image.light];
            double share = count * width * height;
            red = share * l.r * (isStraight ? 1 : light.red);
            green = share * l.g * (isStraight ? 1 : light.green);
            blue = share * l.b * (isStraight ? 1 : light.blue);
        }
        return isMet;
    }

    /** Tells that the surface that the path is at reflects it as a mirror. */
    void reflected() {
        noteReflection(0);
    }

    /** The same of a surface that the path has left. */
    void wasReflected() {
        noteReflection(1);
    }

    private void noteReflection(int surfaces) {
        if (count > 0 && path.surfaces == surfaces) {
            mirror = path.id;
            face = path.hit.face;
        }
    }

    /** The weight, 0 or 1, of what the surface that the path is at emits, if the eye sees it straight or by way of mirrors and glass. */
    double weight() {
        if (count > 0 && (path.surfaces == 0 || path.surfaces == 1 && mirror != NONE)) {
            int met = scene.physical.lightOf(path.id, path.hit.face);
            for (int k = 0; k < count; k++) {
                if (here[k].light == met && isSeenIn(here[k]) && contains(NUMBERS * k)) {
                    return 0;
                }
            }
        }
        return 1;
    }

    private boolean isSeenIn(SmallImage image) {
        return path.surfaces == 0
                ? image.mirror == SmallImage.STRAIGHT
                : image.mirror == mirror && (image.face == SmallImage.ANY_FACE || image.face == face);
    }

    private boolean contains(int at) {
        return x >= boxes[at] && x <= boxes[at + 2] && y >= boxes[at + 1] && y <= boxes[at + 3];
    }
}
