package enlightenment.method.cluster;

import enlightenment.classic.shading.ClassicShader;
import enlightenment.method.Block;
import enlightenment.method.Dither;
import enlightenment.scene.RenderSettings;
import enlightenment.transport.path.PathIntegrator;
import enlightenment.transport.ray.Shader;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.ArrayList;
import java.util.List;

/**
 * The blocks of a picture that may show more than background, known without tracing; of very large pictures, those in an evenly spread
 * sample. Where an object is small, trials must be taken from these blocks: a spread over the whole picture would miss it.
 *
 * <p>A pure function of the scene and the picture's size.
 */
public final class SeenBlocks {
    /** The largest number of blocks examined: all blocks of four million pixels, or of a million in classic shading. */
    public static final int MOST_LOOKED_AT = 1 << 14;

    private final List<Block> seen = new ArrayList<>();
    private final int width;
    private final int height;
    private final int side;
    private final long all;
    private final int lookedAt;
    private final double share;

    private SeenBlocks(CompiledScene scene, RenderSettings settings, int side) {
        this.side = side;
        width = settings.width();
        height = settings.height();
        long across = (width + side - 1) / side;
        all = across * ((height + side - 1) / side);
        Shader shader = shader(scene);
        long pixels = 0;
        long pixelsSeen = 0;
        List<Block> blocks = Block.spread(width, height, side, MOST_LOOKED_AT);
        for (Block block : blocks) {
            pixels += block.pixels();
            // Objects that move while the shutter is open may be anywhere.
            if (scene.instants.length > 0
                    || seesSomething(shader, settings, block.x(), block.y(), block.width(), block.height())) {
                seen.add(block);
                pixelsSeen += block.pixels();
            }
        }
        lookedAt = blocks.size();
        share = (double) pixelsSeen / pixels;
    }

    /**
     * The blocks of a picture; computed once for all threads.
     *
     * @param side of the blocks, in pixels
     */
    public static SeenBlocks of(CompiledScene scene, RenderSettings settings, int side) {
        SeenBlocks known = scene.once(SeenBlocks.class, () -> new SeenBlocks(scene, settings, side));
        return known.isOf(settings, side) ? known : new SeenBlocks(scene, settings, side);
    }

    private boolean isOf(RenderSettings settings, int ofSide) {
        return width == settings.width() && height == settings.height() && side == ofSide;
    }

    /** Makes a shader that can decide whether a rectangle of pixels shows more than background. */
    public static Shader shader(CompiledScene scene) {
        RayCounters counters = new RayCounters(scene.kindNames.size());
        return scene.physical == null ? new ClassicShader(scene, 1, counters) : new PathIntegrator(scene, counters);
    }

    /** Whether a rectangle of pixels may show more than background. */
    public static boolean seesSomething(Shader shader, RenderSettings settings, int x, int y, int columns, int rows) {
        double width = settings.width();
        double height = settings.height();
        shader.beginTile(x / width, y / height, (x + columns) / width, (y + rows) / height);
        return !shader.seesNothing();
    }

    /** The number of pixels in a block that the picture does not cut. */
    public int pixelsOfBlock() {
        return side * side;
    }

    /** The share of the picture's pixels that are in such blocks. */
    public double share() {
        return share;
    }

    /** The number of such blocks among those examined. */
    public int size() {
        return seen.size();
    }

    /** About this number of such blocks, evenly spread over the picture, or all if there are no more; none only if there are none. */
    public List<Block> spread(int count) {
        // If all blocks are such, these are those of Block.spread.
        double threshold = count / ((double) all * seen.size() / lookedAt);
        List<Block> some = new ArrayList<>();
        for (Block block : seen) {
            if (Dither.at(block.x() / side, block.y() / side) < threshold) {
                some.add(block);
            }
        }
        return some.isEmpty() && !seen.isEmpty() ? List.of(seen.get(0)) : some;
    }
}
