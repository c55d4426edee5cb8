package enlightenment.net;

import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;

/**
 * Measures how busy real workers are kept: tiles take their time by sleeping, so that two processors suffice for eight. A
 * program and no test, as the figures depend on how busy the machine is; docs/guide/distributed.md has some.
 */
final class ScalingRun {
    private static final int TILE_MILLIS = 30;

    private ScalingRun() {}

    /** The share of their time for which so many workers slept. */
    private static double busy(int workers) throws Exception {
        RenderSettings settings =
                Farm.SETTINGS.withSize(400, 200).withAntialias(1).with(new BuiltInMethod.RayTraceSettings(1));
        ServerOptions.Builder options =
                Farm.options().awaitWorkers(workers, Farm.TIMEOUT_SECONDS).auditRate(0);
        try (Farm farm = new Farm(Farm.SCENE, settings, options)) {
            for (int i = 0; i < workers; i++) {
                farm.join(Farm.slow(TILE_MILLIS).machine("machine " + i));
            }
            farm.begin();
            Farm.until(() -> farm.server.round().snapshot().done() > 0, "the first tile is done");
            long start = System.nanoTime();
            farm.result();
            double seconds = (System.nanoTime() - start) / 1e9;
            return farm.server.round().job().tiles() * TILE_MILLIS / 1e3 / workers / seconds;
        }
    }

    public static void main(String[] args) throws Exception {
        for (int workers : new int[] {1, 2, 8}) {
            System.out.printf("%d workers were busy %.3f of the time%n", workers, busy(workers));
        }
    }
}
