package enlightenment.video;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Frames for tests: a bright disk that moves over a gradient. */
final class Frames {
    static final int COUNT = 12;
    static final int WIDTH = 64;
    static final int HEIGHT = 48;

    private Frames() {}

    static Image image(int number) {
        float[] rgb = new float[3 * WIDTH * HEIGHT];
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                int i = 3 * (y * WIDTH + x);
                boolean inside = Math.hypot(x - 10 - 4 * number, y - 24) < 8;
                rgb[i] = inside ? 0.9f : 0.55f + 0.3f * x / WIDTH;
                rgb[i + 1] = inside ? 0.5f : 0.2f + 0.2f * y / HEIGHT;
                rgb[i + 2] = inside ? 0.2f : 0.15f;
            }
        }
        return new Image(WIDTH, HEIGHT, rgb);
    }

    /** Writes them into a folder. */
    static List<Path> write(Path folder) throws IOException {
        List<Path> files = new ArrayList<>();
        for (int i = 0; i < COUNT; i++) {
            Path file = folder.resolve("frame-" + i + ".png");
            ImageFiles.writePng(image(i), file);
            files.add(file);
        }
        return files;
    }
}
