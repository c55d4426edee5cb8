package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.engine.TilePicture;
import enlightenment.film.Film;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.plan.Planner;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.work.Stopwatch;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;

/**
 * A rendered picture before it is rounded to floats, and its file.
 *
 * @param width the number of columns
 * @param rgb three doubles per pixel, row by row
 * @param png the bytes of its 16-bit PNG file
 */
record RawPicture(int width, double[] rgb, byte[] png) {
    /** Renders a scene as {@link Renderer} does. */
    static RawPicture of(Scene scene, RenderSettings settings) {
        return of(SceneCompiler.compile(scene, settings), settings);
    }

    static RawPicture of(CompiledScene compiled, RenderSettings settings) {
        LocalRender render = ManySeeds.finished(
                compiled, settings, new Planner(compiled, settings, () -> false).plan(Stopwatch.started(), 0));
        Film film = ((TilePicture) render.film()).film();
        double[] rgb = new double[3 * settings.width() * settings.height()];
        for (int i = 0; i < rgb.length; i++) {
            int pixel = i / 3;
            rgb[i] = film.component(pixel % settings.width(), pixel / settings.width(), i % 3);
        }
        return new RawPicture(settings.width(), rgb, png(render.image()));
    }

    private static byte[] png(Image image) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try {
            ImageFiles.toPng(image, out, ImageFiles.PngOptions.DEFAULT.withDepth(16));
        } catch (IOException e) {
            throw new AssertionError(e);
        }
        return out.toByteArray();
    }

    /** Fails unless the other picture has the same bits in every component and the same file. */
    void assertSameBits(RawPicture other, String what) {
        for (int i = 0; i < rgb.length; i++) {
            if (Double.doubleToRawLongBits(rgb[i]) != Double.doubleToRawLongBits(other.rgb[i])) {
                assertEquals(rgb[i], other.rgb[i], what + ": first difference at " + place(i));
            }
        }
        assertEquals(true, Arrays.equals(png, other.png), what + ": the files differ");
    }

    private String place(int i) {
        return "column " + i / 3 % width + ", row " + i / 3 / width + ", component " + i % 3;
    }

    /** The greatest difference of a component among the pixels that differ by at most {@code limit}. */
    double greatestDifferenceUpTo(RawPicture other, double limit) {
        double greatest = 0;
        for (int i = 0; i < rgb.length; i++) {
            double d = Math.abs(rgb[i] - other.rgb[i]);
            greatest = d <= limit && d > greatest ? d : greatest;
        }
        return greatest;
    }

    /** The number of pixels of which a component differs by more than {@code limit}, or is no number. */
    int pixelsBeyond(RawPicture other, double limit) {
        int n = 0;
        for (int i = 0; i < rgb.length; i += 3) {
            boolean near = true;
            for (int c = i; c < i + 3; c++) {
                near &= Math.abs(rgb[c] - other.rgb[c]) <= limit;
            }
            n += near ? 0 : 1;
        }
        return n;
    }

    int pixels() {
        return rgb.length / 3;
    }
}
