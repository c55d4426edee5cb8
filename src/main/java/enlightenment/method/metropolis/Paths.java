package enlightenment.method.metropolis;

import enlightenment.method.Block;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.scene.RenderSettings;
import enlightenment.transport.ray.Shader;
import enlightenment.world.CompiledScene;
import java.util.Arrays;

/** Follows paths from anywhere in a block, and tells what they are worth. One per thread. */
final class Paths {
    /** Of luminance; and what each band is worth beside it, so that none is starved. */
    private static final double[] WEIGHTS = {0.2126, 0.7152, 0.0722};

    private static final double OF_ANY_BAND = 1.0 / 9;

    private final CompiledScene scene;
    private final double pictureWidth;
    private final double pictureHeight;
    private final Shader shader;
    private final Ray ray = new Ray();
    private Block block;
    private long lost;

    /** What the last path was worth, and in which of the block's pixels it began, by its index. */
    final double[] color = new double[3];

    int pixel;

    Paths(CompiledScene scene, RenderSettings settings, Shader shader) {
        this.scene = scene;
        this.shader = shader;
        pictureWidth = settings.width();
        pictureHeight = settings.height();
    }

    void begin(Block next) {
        block = next;
        lost = 0;
        shader.beginTile(
                next.x() / pictureWidth,
                next.y() / pictureHeight,
                (next.x() + next.width()) / pictureWidth,
                (next.y() + next.height()) / pictureHeight);
    }

    /** Follows the path that these numbers make; returns its brightness, by which chains choose. */
    double follow(Sampler numbers) {
        double x = numbers.filmX() * block.width();
        double y = numbers.filmY() * block.height();
        pixel = (int) y * block.width() + (int) x;
        scene.camera.ray((block.x() + x) / pictureWidth, (block.y() + y) / pictureHeight, numbers, ray);
        shader.shade(ray, numbers, color);
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

    /** How many paths since the {@linkplain #begin beginning} were worth no finite number, and were taken for black. */
    long lost() {
        return lost;
    }
}
