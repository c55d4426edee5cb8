package enlightenment.render;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Random;

/** A picture whose every texel is black or white by chance. */
final class NoiseTexture {
    private NoiseTexture() {}

    static Path write(Path directory, int width, int height) {
        Random random = new Random(5);
        float[] rgb = new float[3 * width * height];
        for (int k = 0; k < rgb.length; k += 3) {
            float v = random.nextBoolean() ? 1 : 0;
            rgb[k] = v;
            rgb[k + 1] = v;
            rgb[k + 2] = v;
        }
        Path file = directory.resolve("noise.png");
        try {
            ImageFiles.writePng(new Image(width, height, rgb), file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return file;
    }
}
