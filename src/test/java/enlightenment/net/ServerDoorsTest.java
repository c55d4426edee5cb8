package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.listen.ServerLog;
import enlightenment.net.protocol.Limits;
import enlightenment.net.protocol.Message;
import enlightenment.net.schedule.Peers;
import enlightenment.net.secure.Token;
import enlightenment.net.worker.MachineIdentity;
import enlightenment.net.worker.WorkerJobs;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Peers who claim to be somebody else, and strangers who come in numbers. */
@Timeout(600)
class ServerDoorsTest {
    private static final byte[] ALONE = Farm.alone();

    /** More connections than there are places. */
    private static final int REFUSED = Limits.STRANGERS + 16;

    @TempDir
    Path folder;

    private static WorkerJobs.Tamper liar() {
        return (tile, bytes) -> {
            byte[] wrong = bytes.clone();
            ByteBuffer.wrap(wrong).putDouble(wrong.length - 36, 0.125);
            return wrong;
        };
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static void end(Farm farm, CompletableFuture<RenderWorker.Outcome> honest) throws Exception {
        assertArrayEquals(ALONE, Farm.png(farm.result().image()));
        assertTrue(honest.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS).isDone(), "the honest worker stays");
    }

    @Test
    void whoCallsItselfAsTheServerDoesIsAuditedLikeAnybodyElse() throws Exception {
        ServerOptions.Builder options = Farm.options().auditRate(1).localThreads(1);
        try (Farm farm = new Farm(options.awaitWorkers(2, Farm.TIMEOUT_SECONDS)).begin()) {
            farm.join(Farm.worker(1).machine("local").tamper(liar()));
            end(farm, farm.join(Farm.worker(1).machine("honest")));
            assertTrue(farm.logHas(RawPeer.called("local", farm) + " expelled"));
            assertFalse(farm.logHas(RawPeer.called("honest", farm) + " expelled"));
        }
    }

    @Test
    void whoRepeatsWhatAnotherSaidOfItselfDoesNotTakeItsPlace() throws Exception {
        try (Farm farm = new Farm(Farm.options()).begin()) {
            CountDownLatch everybodyCame = new CountDownLatch(1);
            CompletableFuture<RenderWorker.Outcome> honest =
                    farm.join(Farm.worker(1).tamper((tile, bytes) -> {
                        await(everybodyCame);
                        return bytes;
                    }));
            Farm.until(() -> farm.logHas("joined"), "the honest one is there");
            for (String name : new String[] {MachineIdentity.name(), "local", "this process"}) {
                try (RawPeer peer = new RawPeer(farm.server.port())) {
                    peer.join(name, Token.NONE);
                    peer.send(new Message.Heartbeat(List.of()));
                    peer.receive(Message.Alive.class);
                }
            }
            everybodyCame.countDown();
            end(farm, honest);
            assertFalse(farm.logHas("newer connection"), farm.log.toString());
        }
    }

    @Test
    void whoTakesManyNamesDoesNotOutvoteTheHonestOne() throws Exception {
        try (Farm farm = new Farm(Farm.options().auditRate(1)).begin()) {
            AtomicReference<byte[]> first = new AtomicReference<>();
            CountDownLatch everybodyLied = new CountDownLatch(1);
            CompletableFuture<RenderWorker.Outcome> honest =
                    farm.join(Farm.worker(1).machine("honest").tamper((tile, bytes) -> {
                        if (tile > 0) {
                            await(everybodyLied);
                        }
                        first.compareAndSet(null, tile == 0 ? bytes : null);
                        return bytes;
                    }));
            Farm.until(() -> farm.server.round().job().film().has(0) && first.get() != null, "tile 0 is there");
            List<RawPeer> peers = new ArrayList<>();
            for (int i = 0; i < 3; i++) {
                RawPeer peer = new RawPeer(farm.server.port());
                peers.add(peer);
                peer.join("liar " + i, Token.NONE);
                peer.receive(Message.Grant.class);
            }
            byte[] wrong = liar().change(0, first.get());
            for (RawPeer peer : peers) {
                peer.send(new Message.Result(0, farm.server.round().job().hash(), 0, wrong));
            }
            // Heard before the picture is done: then nobody is listened to any more.
            Farm.until(() -> farm.logHas(RawPeer.called("liar 0", farm) + " expelled"), "the first liar is found out");
            assertFalse(farm.logHas(RawPeer.called("liar 1", farm) + " expelled"), "nobody asked it for that tile");
            for (RawPeer peer : peers) {
                peer.close();
            }
            everybodyLied.countDown();
            end(farm, honest);
            assertFalse(farm.logHas(RawPeer.called("honest", farm) + " expelled"));
        }
    }

    @Test
    void strangersWhoSitAndSayNothingDoNotKeepAWorkerOut() throws Exception {
        try (Farm farm = new Farm(Farm.options()).begin()) {
            List<RawPeer> strangers = new ArrayList<>();
            for (int i = 0; i < Limits.STRANGERS + 16; i++) {
                strangers.add(new RawPeer(farm.server.port()));
            }
            strangers.get(0).awaitClose();
            farm.join(Farm.worker(2));
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
            assertTrue(farm.log.size() < 3 * ServerLog.LINES_ABOUT_ONE + 20, "lines: " + farm.log.size());
            for (RawPeer stranger : strangers) {
                stranger.close();
            }
        }
    }

    @Test
    void whereNoThreadCanBeStartedNoPlaceIsLostAndNothingIsPrinted() throws Exception {
        AtomicInteger refused = new AtomicInteger();
        AtomicReference<Throwable> uncaught = new AtomicReference<>();
        ServerOptions.Builder options = Farm.options().threads(work -> new Thread(work) {
            @Override
            public void start() {
                if (getName().equals("server connection") && refused.getAndIncrement() < REFUSED) {
                    throw new OutOfMemoryError("unable to create native thread");
                }
                setUncaughtExceptionHandler((t, e) -> uncaught.set(e));
                super.start();
            }
        });
        try (Farm farm = new Farm(options).begin()) {
            for (int i = 0; i < REFUSED; i++) {
                try (RawPeer peer = new RawPeer(farm.server.port())) {
                    peer.awaitClose();
                }
            }
            farm.join(Farm.worker(1));
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
            assertTrue(farm.logHas("no thread for 127.0.0.1"));
            assertTrue(farm.log.size() < 30, "lines: " + farm.log.size());
            assertEquals(null, uncaught.get());
        }
    }

    @Test
    void aMachineThatWasExpelledIsLetInAgainOnlyIfItIsPardoned() throws Exception {
        Path checkpoint = folder.resolve("checkpoint");
        ServerOptions options = Farm.options().checkpoint(checkpoint).build();
        String digits;
        try (Farm farm = new Farm(options.toBuilder()).begin()) {
            digits = Peers.machine("odd", farm.server.round().job().hash()).toString();
            try (RawPeer peer = new RawPeer(farm.server.port())) {
                Message.Job job = peer.join("odd", Token.NONE);
                peer.send(new Message.Result(0, job.job(), 0, new byte[3]));
                assertFalse(peer.receive(Message.Refuse.class).again());
            }
            farm.stop();
        }
        try (Farm farm = new Farm(options.toBuilder().awaitWorkers(1, Farm.TIMEOUT_SECONDS)).begin();
                RawPeer peer = new RawPeer(farm.server.port())) {
            peer.join("odd", Token.NONE);
            assertTrue(peer.receive(Message.Refuse.class).reason().contains("expelled"));
        }
        IllegalArgumentException e = assertThrows(
                IllegalArgumentException.class,
                () -> new Farm(options.toBuilder().pardoned(List.of("0123456789"))).close());
        assertTrue(e.getMessage().contains("these are: " + digits), e.getMessage());
        try (Farm farm = new Farm(options.toBuilder().pardoned(List.of(digits.substring(0, 8))))) {
            assertTrue(farm.logHas("machine " + digits + " is pardoned"));
            assertEquals(0, farm.server.round().snapshot().expelled().size());
        }
        try (Farm farm = new Farm(options.toBuilder())) {
            assertEquals(0, farm.server.round().snapshot().expelled().size(), "the checkpoint remembers");
        }
    }

    @Test
    void onlyAMachineThatIsExpelledCanBePardoned() throws IOException {
        assertThrows(
                IllegalArgumentException.class, () -> new Farm(Farm.options().pardoned(List.of("01234567"))));
    }
}
