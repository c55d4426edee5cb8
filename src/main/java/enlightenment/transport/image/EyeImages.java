package enlightenment.transport.image;

import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.ray.Shader;
import enlightenment.transport.state.PathValue;
import enlightenment.world.CompiledScene;
import enlightenment.world.camera.EyeProjection;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;

/**
 * The light that the eye has straight from lights, through panes, or by way of mirrors and smooth glass, in pixels that their images do not
 * cover entirely. Samples of a pixel may all miss an image, or what of it is in the pixel, and then nothing tells of it; however bright the lamp
 * is, it is missing. So every sample takes a second place on the film, within what of the image is in the pixel, and what the first place
 * sees of the image there does not count: all light is found exactly once, whatever polygon the image is taken for. See
 * docs/path-tracing.md. A mutable work object, one per thread.
 */
public final class EyeImages {
    /** So many columns and rows of pixels are remembered, by what is left of their numbers: blocks are smaller. */
    private static final int REMEMBERED = 16;

    private final CompiledScene scene;
    private final PathFollower path;
    private final EyeProjection eye;
    private final MirroredLight light;

    private final RayCounters counters;
    private final boolean isWanted;

    /** Follows the paths of images by chains; null if there are none. */
    private SpecularChain chained;

    /** Finds out where rays start; null if all start outside of all solids. */
    private final PathFollower starts;

    /** Those of the picture; null until a path begins. */
    private LightImage[] all;

    private final Ray ray = new Ray();
    private final double[] pair = new double[2];
    private final ClippedPolygon work = new ClippedPolygon();

    /** Those of the tile. */
    private LightImage[] near;

    private int nearCount;

    /** The box of the tile in pixels. */
    private final double[] tile = new double[4];

    private boolean isNewTile;

    /** What pixels show of images: it depends on the pixel alone. */
    private PixelImages[] pixels;

    /** The pixel that the path began in, if it shows images. */
    private PixelImages here;

    /** Where on the film the path began, in pixels. */
    private double x;

    private double y;

    /** How many images count in the pixel. */
    private int count;

    /** Whether the path began in empty space. */
    private boolean isOutside;

    /** The first mirror that reflected the path, if that was its first event. */
    private int mirror;

    private int face;

    /** How many panes the path has passed, if it has done nothing else. */
    private int panes;

    /** What the path has come by: {@link SpecularChain#NONE} or too short if that is not only mirrors and smooth glass. */
    private long chain;

    /** What was gathered. */
    public double red;

    public double green;
    public double blue;

    /** @param isWanted whether the light is wanted that the eye sees so */
    public EyeImages(CompiledScene scene, RayCounters counters, PathFollower path, boolean isWanted) {
        this.scene = scene;
        this.counters = counters;
        this.path = path;
        // In a medium that fills everything absorption counts as well: left to chance.
        this.isWanted = isWanted && scene.physical.around == null;
        eye = new EyeProjection(scene.camera);
        light = new MirroredLight(scene, counters, path.tracer);
        starts = scene.cameraSolids.length == 0 ? null : new PathFollower(scene, counters, 0);
    }

    /** Sets the tile of the paths to come, as {@link Shader#beginTile}. */
    public void beginTile(double x0, double y0, double x1, double y1) {
        tile[0] = x0;
        tile[1] = y0;
        tile[2] = x1;
        tile[3] = y1;
        isNewTile = isWanted;
        nearCount = 0;
    }

    /** Finds the images of the tile; those of the picture before, which takes some time, once whoever polls for a stop has been set. */
    private void findNear() {
        isNewTile = false;
        if (all == null) {
            all = scene.once(LightImage[].class, () -> LightImages.of(scene));
            near = new LightImage[all.length];
            pixels = new PixelImages[all.length == 0 ? 0 : REMEMBERED * REMEMBERED];
            boolean hasChains = Arrays.stream(all).anyMatch(image -> image.chain != SpecularChain.NONE);
            chained = hasChains ? new SpecularChain(scene, counters) : null;
        }
        double columns = scene.camera.columns;
        double rows = scene.camera.rows;
        boolean hasChains = false;
        for (LightImage image : all) {
            if (image.reaches(tile[0] * columns - 1, tile[1] * rows - 1, tile[2] * columns + 1, tile[3] * rows + 1)) {
                near[nearCount++] = image;
                hasChains |= image.chain != SpecularChain.NONE;
            }
        }
        if (hasChains) {
            chained.beginTile(tile[0], tile[1], tile[2], tile[3]);
        }
    }

    /** Begins with a camera ray of the tile, which the path has begun with. */
    public void begin(Ray camera) {
        count = 0;
        panes = 0;
        chain = SpecularChain.STRAIGHT;
        if (isNewTile) {
            findNear();
        }
        if (nearCount == 0) {
            return;
        }
        mirror = LightImage.STRAIGHT;
        eye.place(camera.ox + camera.dx, camera.oy + camera.dy, camera.oz + camera.dz);
        x = eye.x * scene.camera.columns;
        y = eye.y * scene.camera.rows;
        here = pixel((int) x, (int) y);
        count = here.count;
        // What rays that start in a medium see is no image of any kind.
        isOutside = starts == null || path.medium() == null;
    }

    private PixelImages pixel(int column, int row) {
        int at = row % REMEMBERED * REMEMBERED + column % REMEMBERED;
        PixelImages known = pixels[at];
        if (known == null || known.column != column || known.row != row) {
            known = PixelImages.of(column, row, near, nearCount, work);
            pixels[at] = known;
        }
        return known;
    }

    /** Adds the light of one of the pixel's images to a path that has just begun. */
    public void gather(Sampler sampler, PathValue value) {
        if (gather(sampler)) {
            value.add(red, green, blue);
        }
    }

    /** Gathers the light of one of the pixel's images: radiance towards the eye. Returns whether there is any. */
    public boolean gather(Sampler sampler) {
        if (count == 0) {
            return false;
        }
        sampler.pair(0, Sampler.Purpose.MIRROR, pair);
        here.choose(pair[0], pair[1]);
        ImagePart part = here.chosen;
        LightImage image = part.image;
        scene.camera.ray(part.placeX / scene.camera.columns, part.placeY / scene.camera.rows, ray);
        if (starts != null) {
            starts.beginAgain(ray);
            if (starts.medium() != null) {
                return false;
            }
        }
        if (image.chain != SpecularChain.NONE) {
            return gatherChained(image);
        }
        boolean isMet = image.isStraight()
                ? light.isSeenBy(ray, image.light)
                : light.isMetBy(ray, image.mirror, image.face, image.light);
        if (isMet) {
            set(image, light.red, light.green, light.blue);
        }
        return isMet;
    }

    private boolean gatherChained(LightImage image) {
        boolean isMet = chained.follow(ray, image.chain) && chained.isOwn(image.chain) && chained.isAt(image.light);
        if (isMet) {
            set(image, chained.red, chained.green, chained.blue);
        }
        return isMet;
    }

    private void set(LightImage image, double r, double g, double b) {
        PhysicalLight l = scene.physical.lights[image.light];
        red = here.share * l.r * r;
        green = here.share * l.g * g;
        blue = here.share * l.b * b;
    }

    /** The number of vertices of the path that was gathered, from the eye to the lamp. */
    public int vertices() {
        LightImage image = here.chosen.image;
        return image.isStraight() ? 2 : image.chain == SpecularChain.NONE ? 3 : 2 + chained.bounces();
    }

    /** Tells that the surface that the path is at reflects it as a mirror. */
    public void reflected() {
        noteReflection(0);
    }

    /** The same of a surface that the path has left. */
    public void wasReflected() {
        noteReflection(1);
    }

    /** Tells that the path passes the glass that it is at, straight. */
    public void passed() {
        notePassage(0);
    }

    /** The same of glass that the path has left. */
    public void hasPassed() {
        notePassage(1);
    }

    /** Tells that the path has been refracted by smooth glass. */
    public void refracted() {
        chain = SpecularChain.and(chain, true);
    }

    private void notePassage(int surfaces) {
        chain = SpecularChain.and(chain, true);
        if (count > 0 && path.surfaces == panes + surfaces && light.isPane(path.id, path.hit.face)) {
            panes++;
        }
    }

    /** Tells that the path was scattered by something else. */
    public void scattered() {
        chain = SpecularChain.NONE;
    }

    private void noteReflection(int surfaces) {
        chain = SpecularChain.and(chain, false);
        if (count > 0 && path.surfaces == surfaces) {
            mirror = path.id;
            face = path.hit.face;
        }
    }

    /** The weight, 0 or 1, of what the surface that the path is at emits, if the eye sees it straight or by way of mirrors and glass. */
    public double weight() {
        boolean isStraight = path.surfaces == panes;
        boolean isSeen = isStraight || SpecularChain.length(chain) == path.surfaces;
        if (count > 0 && isOutside && isSeen) {
            int met = scene.physical.lightOf(path.id, path.hit.face);
            int at = here.firstOf(met);
            for (ImagePart part = here.of(met, at); part != null; part = here.of(met, ++at)) {
                if ((isStraight ? part.image.isStraight() : isSeenIn(part.image)) && part.contains(x, y)) {
                    return 0;
                }
            }
        }
        return 1;
    }

    private boolean isSeenIn(LightImage image) {
        return path.surfaces == 1 && image.mirror != LightImage.STRAIGHT
                ? image.mirror == mirror && (image.face == LightImage.ANY_FACE || image.face == face)
                : image.isSeenBy(chain);
    }
}
