package enlightenment.method.metropolis;

import enlightenment.method.Block;
import enlightenment.method.MomentShaders;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.scene.RenderSettings;
import enlightenment.transport.ray.Shader;
import enlightenment.world.CompiledScene;
import java.util.Arrays;
import java.util.function.BooleanSupplier;
import java.util.function.Function;

/**
 * Traces paths from anywhere in a block, and returns their colour and brightness. With motion blur each path sees one moment, by a random
 * number that chains mutate like the others. One per thread.
 */
final class Paths {
    /** Weights of luminance; brightness adds each band's own worth, so that none is starved. */
    private static final double[] WEIGHTS = {0.2126, 0.7152, 0.0722};

    private static final double OF_ANY_BAND = 1.0 / 9;

    private final MomentShaders shaders;
    private final double pictureWidth;
    private final double pictureHeight;
    private final Ray ray = new Ray();
    private Block block;
    private long lost;

    /** The colour of the last path, and the index, in the block, of the pixel that it began in. */
    final double[] color = new double[3];

    int pixel;

    /** @param shader makes what a path of a moment is worth */
    Paths(CompiledScene scene, RenderSettings settings, Function<CompiledScene, Shader> shader) {
        shaders = new MomentShaders(scene.moments(), shader);
        pictureWidth = settings.width();
        pictureHeight = settings.height();
    }

    void stopWhen(BooleanSupplier cancelled) {
        shaders.stopWhen(cancelled);
    }

    void begin(Block next) {
        block = next;
        lost = 0;
        shaders.beginTile(
                next.x() / pictureWidth,
                next.y() / pictureHeight,
                (next.x() + next.width()) / pictureWidth,
                (next.y() + next.height()) / pictureHeight);
    }

    /** Traces the path that these random numbers make; returns its brightness, the target function of the chains. */
    double follow(Sampler numbers) {
        double x = numbers.filmX() * block.width();
        double y = numbers.filmY() * block.height();
        pixel = (int) y * block.width() + (int) x;
        int moment = shaders.count() == 1 ? 0 : (int) (numbers.unit(0, Sampler.Purpose.TIME) * shaders.count());
        shaders.shade(moment, (block.x() + x) / pictureWidth, (block.y() + y) / pictureHeight, ray, numbers, color);
        double brightness = 0;
        for (int c = 0; c < 3; c++) {
            brightness += (WEIGHTS[c] + OF_ANY_BAND) * Math.abs(color[c]);
        }
        if (brightness < Double.POSITIVE_INFINITY) {
            return brightness;
        }
        lost++;
        Arrays.fill(color, 0);
        return 0;
    }

    /** The number of paths since {@link #begin} whose value was not finite; they count as black. */
    long lost() {
        return lost;
    }
}
