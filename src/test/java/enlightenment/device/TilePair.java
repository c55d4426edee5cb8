package enlightenment.device;

import enlightenment.film.FilmTile;
import enlightenment.math.InvalidValueException;
import enlightenment.method.RayTraceMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;

/** A picture in one tile by the processor, to be compared with one of a device. */
final class TilePair {
    private TilePair() {}

    static FilmTile onProcessor(CompiledScene scene, RenderSettings settings) {
        FilmTile tile = new FilmTile(0, 0, settings.width(), settings.height(), scene.display);
        RayTraceMethod.of(scene, settings, counters(scene), 0).render(tile);
        return tile;
    }

    static FilmTile by(DeviceTileShader shader, CompiledScene scene, RenderSettings settings) {
        FilmTile tile = new FilmTile(0, 0, settings.width(), settings.height(), scene.display);
        RayTraceMethod.ofTiles(scene, settings, 0, shader).render(tile);
        return tile;
    }

    static RayCounters counters(CompiledScene scene) {
        return new RayCounters(scene.kindNames.size());
    }

    /** How many pixels differ in any bit. */
    static int differences(FilmTile a, FilmTile b) {
        if (a.width != b.width || a.height != b.height) {
            throw new InvalidValueException("size", "differs");
        }
        int count = 0;
        for (int y = 0; y < a.height; y++) {
            for (int x = 0; x < a.width; x++) {
                boolean same = true;
                for (int c = 0; c < 3; c++) {
                    same &= Double.doubleToRawLongBits(a.mean(x, y, c)) == Double.doubleToRawLongBits(b.mean(x, y, c));
                }
                count += same ? 0 : 1;
            }
        }
        return count;
    }
}
