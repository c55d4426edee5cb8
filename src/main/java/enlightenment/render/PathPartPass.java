package enlightenment.render;

import enlightenment.engine.TileGrid;
import enlightenment.film.FilmTile;
import enlightenment.image.Image;
import enlightenment.math.InvalidValueException;
import enlightenment.method.RayTraceMethod;
import enlightenment.plan.RenderPlan;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.work.Workers;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.EnumMap;
import java.util.Map;
import java.util.Set;
import java.util.function.BooleanSupplier;

/**
 * The beginnings of the picture's paths: with method {@code raytrace} of the very same ones, so that what is direct is a part of the
 * picture sample by sample; with others of as many.
 */
final class PathPartPass {
    private final CompiledScene scene;
    private final RenderSettings settings;
    private final RenderSettings.Crop region;
    private final TileGrid grid;
    private final Set<RenderResult.Auxiliary> kinds;
    private final Map<RenderResult.Auxiliary, float[]> numbers = new EnumMap<>(RenderResult.Auxiliary.class);

    /** @throws InvalidValueException (key {@code auxiliary}) if something is asked for that the scene's shading does not have */
    PathPartPass(CompiledScene scene, RenderSettings settings, Set<RenderResult.Auxiliary> kinds) {
        this.scene = scene;
        this.settings = settings;
        this.kinds = kinds;
        region = settings.region();
        grid = new TileGrid(settings);
        for (RenderResult.Auxiliary kind : kinds) {
            if (kind.needsPaths()) {
                if (scene.physical == null) {
                    throw new InvalidValueException(
                            "auxiliary",
                            kind.word() + " is for physical shading: classic shading does not tell it apart");
                }
                numbers.computeIfAbsent(part(kind), p -> new float[3 * region.width() * region.height()]);
            }
        }
    }

    /** The kind that is rendered for a kind: the indirect light is the picture less the direct. */
    private static RenderResult.Auxiliary part(RenderResult.Auxiliary kind) {
        return kind == RenderResult.Auxiliary.INDIRECT ? RenderResult.Auxiliary.DIRECT : kind;
    }

    boolean isNeeded() {
        return !numbers.isEmpty();
    }

    /**
     * The largest time of this pass as a share of the render's: its paths are beginnings of the render's. Among glass that is nearly all of
     * each.
     */
    double share() {
        return numbers.size();
    }

    /** Follows the paths of a plan, unless it is cancelled: then what is not done stays black. */
    void run(RenderPlan plan, BooleanSupplier cancelled) {
        run(plan.method() == BuiltInMethod.RAYTRACE ? plan.level() : Math.max(plan.samples(), 1), cancelled);
    }

    /**
     * Follows paths of all pixels, unless it is cancelled: then what is not done stays black.
     *
     * @param samples per pixel
     */
    void run(double samples, BooleanSupplier cancelled) {
        numbers.forEach((part, rgb) -> Workers.run(settings.threads(), grid.tiles(), cancelled, () -> {
            // These rays are no part of the picture, nor of what its report counts.
            RayCounters unread = new RayCounters(scene.kindNames.size());
            RayTraceMethod method = part == RenderResult.Auxiliary.ALBEDO
                    ? RayTraceMethod.ofAlbedo(scene, settings, unread, samples)
                    : RayTraceMethod.ofDirectLight(scene, settings, unread, samples);
            method.stopWhen(cancelled);
            return number -> {
                RenderSettings.Crop place = grid.place(number);
                FilmTile tile = new FilmTile(place.x(), place.y(), place.width(), place.height(), scene.display);
                method.render(tile);
                put(tile, rgb);
            };
        }));
    }

    private void put(FilmTile tile, float[] rgb) {
        for (int y = tile.y; y < tile.y + tile.height; y++) {
            int k = 3 * ((y - region.y()) * region.width() + tile.x - region.x());
            for (int x = tile.x; x < tile.x + tile.width; x++) {
                for (int c = 0; c < 3; c++) {
                    rgb[k++] = (float) tile.mean(x, y, c);
                }
            }
        }
    }

    /**
     * Adds what was found.
     *
     * @param picture the picture of those paths, of which what is not direct is the rest
     * @param images receives it
     */
    void addTo(Image picture, Map<RenderResult.Auxiliary, Image> images) {
        for (RenderResult.Auxiliary kind : kinds) {
            if (kind.needsPaths()) {
                float[] rgb = numbers.get(part(kind)).clone();
                if (kind == RenderResult.Auxiliary.INDIRECT) {
                    float[] all = picture.toArray();
                    for (int i = 0; i < rgb.length; i++) {
                        rgb[i] = all[i] - rgb[i];
                    }
                }
                images.put(kind, new Image(region.width(), region.height(), rgb, scene.display));
            }
        }
    }
}
