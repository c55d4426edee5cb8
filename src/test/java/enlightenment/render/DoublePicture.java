package enlightenment.render;

import enlightenment.film.FilmTile;
import enlightenment.method.RayTraceMethod;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;

/** A whole picture in doubles, before anything is rounded or clamped for output. */
public final class DoublePicture {
    public final int width;
    public final int height;
    private final double[] rgb;

    private DoublePicture(int width, int height) {
        this.width = width;
        this.height = height;
        rgb = new double[3 * width * height];
    }

    public static DoublePicture of(Scene scene, int antialias, int shadowSamples) {
        return of(
                scene,
                RenderSettings.of(scene)
                        .withAntialias(antialias)
                        .with(new BuiltInMethod.RayTraceSettings(shadowSamples)));
    }

    public static DoublePicture of(Scene scene, RenderSettings settings) {
        CompiledScene compiled = SceneCompiler.compile(scene, settings);
        FilmTile tile = new FilmTile(0, 0, settings.width(), settings.height());
        RayTraceMethod.of(compiled, settings, new RayCounters(compiled.kindNames.size()), 0)
                .render(tile);
        DoublePicture p = new DoublePicture(settings.width(), settings.height());
        for (int i = 0; i < p.rgb.length; i++) {
            p.rgb[i] = tile.mean(i / 3 % p.width, i / 3 / p.width, i % 3);
        }
        return p;
    }

    /** Component 0, 1 or 2 of a pixel. */
    public double at(int x, int y, int component) {
        return rgb[3 * (y * width + x) + component];
    }

    public double[] toArray() {
        return rgb.clone();
    }

    public double least() {
        return Arrays.stream(rgb).min().orElseThrow();
    }

    public double greatest() {
        return Arrays.stream(rgb).max().orElseThrow();
    }

    public boolean isFinite() {
        return Arrays.stream(rgb).allMatch(Double::isFinite);
    }

    /** The greatest difference of any component; infinite where one is not a number. */
    public double difference(DoublePicture o) {
        double most = 0;
        for (int i = 0; i < rgb.length; i++) {
            double d = Math.abs(rgb[i] - o.rgb[i]);
            most = d <= most ? most : d == d ? d : Double.POSITIVE_INFINITY;
        }
        return most;
    }

    /** The share of pixels of which a component differs by more than the tolerance. */
    public double shareBeyond(DoublePicture o, double tolerance) {
        int n = 0;
        for (int i = 0; i < rgb.length; i += 3) {
            boolean same = true;
            for (int c = i; c < i + 3; c++) {
                same &= Math.abs(rgb[c] - o.rgb[c]) <= tolerance;
            }
            n += same ? 0 : 1;
        }
        return (double) n / (width * height);
    }

    /**
     * The number of inner pixels of which a component differs by more than 1e-6 from the median of its 3 × 3
     * neighbourhood, although that neighbourhood is plain in the other picture: no edge runs through it there.
     */
    public int speckles(DoublePicture withoutSpeckles) {
        int n = 0;
        for (int y = 1; y < height - 1; y++) {
            for (int x = 1; x < width - 1; x++) {
                n += isSpeckle(x, y, withoutSpeckles) ? 1 : 0;
            }
        }
        return n;
    }

    private boolean isSpeckle(int x, int y, DoublePicture reference) {
        boolean beyond = false;
        for (int c = 0; c < 3; c++) {
            double[] around = reference.around(x, y, c);
            if (around[8] - around[0] > 1e-6) {
                return false;
            }
            beyond |= !(Math.abs(at(x, y, c) - around(x, y, c)[4]) <= 1e-6);
        }
        return beyond;
    }

    private double[] around(int x, int y, int c) {
        double[] values = new double[9];
        for (int i = 0; i < 9; i++) {
            values[i] = at(x - 1 + i % 3, y - 1 + i / 3, c);
        }
        Arrays.sort(values);
        return values;
    }
}
