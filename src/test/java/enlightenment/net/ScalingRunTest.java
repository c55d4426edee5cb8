package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.net.schedule.Snapshot;
import enlightenment.scene.RenderSettings;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** How busy real workers are kept: tiles take their time by sleeping, so that two processors suffice for eight. */
class ScalingRunTest {
    private static final int TILE_MILLIS = 30;

    @ParameterizedTest
    @CsvSource({"1,0.90", "2,0.90", "8,0.85"})
    @Tag("full")
    @Timeout(300)
    void workersAreBusyAlmostAllTheTime(int workers, double least) throws Exception {
        RenderSettings settings =
                Farm.SETTINGS.withSize(400, 200).withAntialias(1).withShadowSamples(1);
        try (Farm farm = new Farm(
                Farm.SCENE, settings, Farm.options().awaitWorkers(workers, 30).auditRate(0))) {
            for (int i = 0; i < workers; i++) {
                farm.join(Farm.slow(TILE_MILLIS).machine("machine " + i));
            }
            farm.begin();
            Farm.until(() -> farm.server.round().snapshot().done() > 0, "the first tile is done");
            long start = System.nanoTime();
            farm.result();
            double seconds = (System.nanoTime() - start) / 1e9;
            List<Snapshot.Worker> list = farm.server.round().snapshot().workers();
            double work = farm.server.round().job().tiles() * TILE_MILLIS / 1e3 / workers;
            assertTrue(
                    work / seconds >= least,
                    workers + " workers were busy " + work / seconds + " of the time: " + list);
            farm.log.add("busy " + work / seconds);
            System.getLogger("scaling").log(System.Logger.Level.INFO, workers + " workers: " + work / seconds);
        }
    }
}
