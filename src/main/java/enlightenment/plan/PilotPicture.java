package enlightenment.plan;

import enlightenment.film.FilmTile;
import enlightenment.film.SplatBatch;
import enlightenment.film.SplatFilm;
import enlightenment.film.SplatScale;
import enlightenment.method.SplatIntegrator;
import enlightenment.method.TileIntegrator;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;
import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * Some pixels of a picture by one method, rendered by one thread.
 *
 * @param tiles linear red, green and blue of each pixel, as camera samples make it
 * @param splats what light paths add to it; as long, or empty for nothing
 * @param counts what was traced for it
 */
record PilotPicture(double[] tiles, double[] splats, RayCounters counts) {
    private static final double[] NOTHING = new double[0];

    /** The light of all pixels. */
    double[] light() {
        double[] light = tiles.clone();
        Arrays.setAll(light, i -> light[i] + (splats.length == 0 ? 0 : splats[i]));
        return light;
    }

    /**
     * Renders a whole picture.
     *
     * @param settings its size and seed
     * @param contribution {@link SplatIntegrator#expectedContribution} of the method's light paths
     * @throws java.util.concurrent.CancellationException soon after it is cancelled
     */
    static PilotPicture whole(
            RenderPlan plan,
            CompiledScene scene,
            RenderSettings settings,
            double contribution,
            BooleanSupplier cancelled) {
        PilotPicture tiles = parts(plan, scene, settings, List.of(settings.region()), cancelled);
        double[] splats =
                plan.lightPaths() == 0 ? NOTHING : splats(plan, scene, settings, contribution, tiles.counts, cancelled);
        return new PilotPicture(tiles.tiles, splats, tiles.counts);
    }

    /** Renders parts of a picture, without light paths. */
    static PilotPicture parts(
            RenderPlan plan,
            CompiledScene scene,
            RenderSettings settings,
            List<RenderSettings.Crop> parts,
            BooleanSupplier cancelled) {
        RayCounters counts = new RayCounters(scene.kindNames.size());
        TileIntegrator integrator = (TileIntegrator) Integrators.of(plan, scene, settings, counts);
        integrator.stopWhen(cancelled);
        double[] light = new double
                [3 * parts.stream().mapToInt(p -> p.width() * p.height()).sum()];
        int i = 0;
        for (RenderSettings.Crop part : parts) {
            FilmTile tile = new FilmTile(part.x(), part.y(), part.width(), part.height(), scene.display);
            integrator.render(tile);
            for (int k = 0; k < 3 * part.width() * part.height(); k++) {
                int column = part.x() + k / 3 % part.width();
                int row = part.y() + k / 3 / part.width();
                light[i++] = tile.mean(column, row, k % 3);
            }
        }
        return new PilotPicture(light, NOTHING, counts);
    }

    /** What the light paths of a plan bring. */
    private static double[] splats(
            RenderPlan plan,
            CompiledScene scene,
            RenderSettings settings,
            double contribution,
            RayCounters counts,
            BooleanSupplier cancelled) {
        int width = settings.width();
        int height = settings.height();
        int pixels = width * height;
        int paths = Math.toIntExact(plan.lightPaths());
        SplatIntegrator integrator = Integrators.splats(plan, scene, settings, counts);
        integrator.stopWhen(cancelled);
        SplatScale scale = SplatScale.of(contribution, paths, pixels);
        SplatBatch batch = new SplatBatch(0, 0, width, height, scale);
        batch.begin(paths);
        integrator.trace(0, paths, batch);
        SplatFilm film = new SplatFilm(0, 0, width, height, pixels, scale, scene.display);
        film.add(0, batch.sums());
        double[] light = new double[3 * pixels];
        Arrays.setAll(light, i -> film.component(i / 3 % width, i / 3 / width, i % 3));
        return light;
    }
}
