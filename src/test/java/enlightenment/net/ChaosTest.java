package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.net.protocol.Timing;
import enlightenment.net.worker.WorkerJobs;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Renders while everything goes wrong: faults of all kinds, chosen by a seed, some every few dozen milliseconds. After each
 * render the bytes are those of one process. (When exactly a fault strikes, the operating system decides.)
 */
class ChaosTest {
    private static final byte[] ALONE = Farm.alone();

    /** Long enough for workers on a busy machine, short enough for a test. */
    private static final Timing TIMING = new Timing(3_000, 1_000, 1_000, 2_000, 50, 600);

    private enum Fault {
        CUT,
        FREEZE,
        SILENCE,
        FLIP,
        SLOW,
        WORKER_GONE,
        WORKER_COMES,
        SERVER_STOPS,
        GARBAGE,
        TWO_GIBIBYTES,
        HALF_OPEN,
        WRONG_TOKEN,
        WRONG_VERSION,
        NAN,
        WRONG_SIZE
    }

    @TempDir
    Path folder;

    private final Map<Fault, Integer> count = new EnumMap<>(Fault.class);
    private final List<AtomicBoolean> stops = new ArrayList<>();
    private Farm farm;
    private FaultProxy proxy;
    private int port;
    private Random random;
    private Path checkpoint;

    @Test
    @Timeout(600)
    void aShortRunOfFaultsChangesNoBit() throws Exception {
        assertTrue(run(2, 20) >= 20);
    }

    @Test
    @Tag("full")
    @Timeout(900)
    void hundredsOfFaultsChangeNoBit() throws Exception {
        assertTrue(run(20, 250) >= 250);
        assertTrue(count.size() == Fault.values().length, "kinds of faults: " + count);
    }

    /** Renders at least so often and until there were so many faults; returns how many there were. */
    private int run(int renders, int faults) throws Exception {
        int done = 0;
        for (int seed = 0; seed < renders || done < faults; seed++) {
            random = new Random(seed);
            done += render(seed);
        }
        return done;
    }

    private int render(int seed) throws Exception {
        port = 0;
        checkpoint = folder.resolve("checkpoint-" + seed);
        int faults = 0;
        startServer();
        // Servers that come after it listen there, too.
        port = farm.server.port();
        proxy = new FaultProxy(port);
        try {
            for (int i = 0; i < 3; i++) {
                worker();
            }
            while (faults < 14
                    && farm.server.round().job().film().done()
                            < farm.server.round().job().tiles()) {
                Farm.sleep(20 + random.nextInt(60));
                Fault fault = Fault.values()[random.nextInt(Fault.values().length)];
                strike(fault);
                count.merge(fault, 1, Integer::sum);
                faults++;
            }
            proxy.slow(false);
            honest(2);
            assertArrayEquals(ALONE, Farm.png(farm.result().image()), "seed " + seed + " " + count);
        } finally {
            stops.forEach(stop -> stop.set(true));
            stops.clear();
            proxy.close();
            farm.close();
        }
        return faults;
    }

    private void startServer() throws IOException {
        farm = new Farm(Farm.options()
                        .address("127.0.0.1", port)
                        .timing(TIMING)
                        .awaitWorkers(1, Farm.TIMEOUT_SECONDS)
                        .checkpoint(checkpoint))
                .begin();
    }

    /** A worker behind the proxy, on a machine of its own, slow enough for faults to find it at work. */
    private void worker() {
        join(Farm.slow(25).machine("machine " + random.nextInt()).timing(TIMING), proxy.port());
    }

    private void honest(int threads) {
        join(Farm.worker(threads).machine("honest " + random.nextInt()), port);
    }

    private void join(RenderWorker.Options.Builder options, int at) {
        AtomicBoolean stop = new AtomicBoolean();
        stops.add(stop);
        farm.join(options, at, stop::get);
    }

    private void strike(Fault fault) throws Exception {
        switch (fault) {
            case CUT -> proxy.cut();
            case FREEZE -> proxy.freeze(200);
            case SILENCE -> proxy.freeze(1_000);
            case FLIP -> proxy.flip(1 + random.nextInt(3));
            case SLOW -> proxy.slow(random.nextBoolean());
            case WORKER_GONE -> stops.get(random.nextInt(stops.size())).set(true);
            case WORKER_COMES -> worker();
            case SERVER_STOPS -> {
                farm.stop();
                farm.close();
                startServer();
                worker();
            }
            case GARBAGE -> knock(garbage());
            case TWO_GIBIBYTES -> knock(new byte[] {0x7f, -1, -1, -1, 0});
            case HALF_OPEN -> new RawPeer(port).bytes("0000");
            case WRONG_TOKEN -> wrongToken();
            case WRONG_VERSION -> join(Farm.worker(1).version("other"), port);
            case NAN ->
                lie((tile, bytes) -> {
                    java.nio.ByteBuffer.wrap(bytes).putDouble(bytes.length - 36, Double.NaN);
                    return bytes;
                });
            default -> lie((tile, bytes) -> new byte[tile]);
        }
    }

    private byte[] garbage() {
        byte[] garbage = new byte[1 + random.nextInt(500)];
        random.nextBytes(garbage);
        return garbage;
    }

    private void knock(byte[] bytes) {
        try (RawPeer peer = new RawPeer(port)) {
            peer.bytes(bytes);
        } catch (IOException e) {
            // The server may hang up before all is said.
            return;
        }
    }

    private void wrongToken() {
        try (RawPeer peer = new RawPeer(port)) {
            peer.enter("burglar", "not the token at all".getBytes(java.nio.charset.StandardCharsets.US_ASCII));
            throw new AssertionError("a wrong token was taken");
        } catch (IOException refused) {
            return;
        }
    }

    private void lie(WorkerJobs.Tamper tamper) {
        join(Farm.worker(1).tamper(tamper).machine("liar " + random.nextInt()), port);
    }
}
