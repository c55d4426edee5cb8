package enlightenment.net;

import enlightenment.engine.Rendered;
import enlightenment.listen.ServerLog;
import enlightenment.net.job.Canary;
import enlightenment.net.secure.Secrets;
import enlightenment.net.server.FrameAssemblies;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.Closeable;
import java.io.IOException;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.IntFunction;

/**
 * Renders the frames of a film with the help of {@link RenderWorker}s: each is the picture of {@link
 * enlightenment.render.Renderer}, bit for bit. All frames are one job, so workers stay connected from the first to the last, and begin
 * the next frame while others end the one before. docs/guide/distributed.md tells how it is set up.
 *
 * <p>A server has threads of its own (daemons); its methods may be called by several threads at once. The module {@code
 * tools.jackson.dataformat.cbor} must be there, which nothing else needs.
 */
public final class FilmServer implements Closeable {
    private final FilmQueue queue;
    private final RoundChain chain;
    private final ServerRound first;
    private final FilmAudits audits = new FilmAudits();
    private FilmQueue.Round round;

    /**
     * A frame.
     *
     * @param scene its scene
     * @param settings how it is rendered; without a budget of time, which is planned anew each time
     */
    public record Frame(Scene scene, RenderSettings settings) {
        /** Nothing may be null. */
        public Frame {
            Objects.requireNonNull(scene, "scene");
            Objects.requireNonNull(settings, "settings");
        }
    }

    /** Takes finished frames. */
    @FunctionalInterface
    public interface Sink {
        /**
         * A frame is whole. It comes once more, and takes the place of what came before, if a machine that made a part of it turns out
         * to compute wrongly.
         *
         * @param number of the frame
         */
        void frame(int number, RenderResult result) throws IOException;
    }

    private FilmServer(FilmQueue queue, FilmQueue.Round round, ServerRound first) {
        this.queue = queue;
        this.round = round;
        this.first = first;
        chain = new RoundChain(first);
    }

    /**
     * Plans all frames, which blocks, and begins to listen. Workers that come are given work from then on.
     *
     * @param numbers of the frames, in the order in which they are to be made; at least one
     * @param frames makes a frame; asked on the calling thread for one after the other, and again for frames that take more samples
     *     than their first plan had
     * @param options without a checkpoint: finished frames are what is kept
     * @param cancelled asked now and then while frames are planned
     * @throws IOException if the server cannot listen, or a file of the options cannot be used; the message says why
     * @throws IllegalStateException if the library for CBOR, which is optional, is not there
     * @throws enlightenment.scene.SceneException if the scene of a frame cannot be used
     * @throws enlightenment.math.InvalidValueException if a setting cannot be used
     * @throws IllegalArgumentException if there is a checkpoint or a budget of time, or the scenes are too large to be sent
     * @throws CancellationException if it is cancelled before all frames are planned
     */
    public static FilmServer start(
            List<Integer> numbers, IntFunction<Frame> frames, ServerOptions options, BooleanSupplier cancelled)
            throws IOException {
        CborLibrary.require();
        if (options.checkpoint.isPresent()) {
            throw new IllegalArgumentException("a film has no checkpoint: its finished frames are what is kept");
        }
        ServerLog log = new ServerLog(options.log, System::nanoTime);
        // Before what takes long: these files may be of no use.
        Secrets secrets = Secrets.open(options.secrets(), log::say);
        Canary.hash();
        FilmQueue queue = new FilmQueue(frames, options.version, log::say, cancelled);
        FilmQueue.Round round = queue.first(List.copyOf(numbers));
        return new FilmServer(queue, round, ServerRound.start(options, log, secrets, round.job()));
    }

    /** The port that it listens at. */
    public int port() {
        return first.port();
    }

    /** The port of the status page, or -1 if there is none. */
    public int statusPort() {
        return first.statusPort();
    }

    /** What a worker may pin: the SHA-256 of the server's certificate, 64 hexadecimal digits; empty without TLS. */
    public String pin() {
        return first.pin();
    }

    /**
     * Renders until all frames are done, it is cancelled, or the calling thread is interrupted, and closes the server. An interrupt stays
     * set. Where an error was asked for and frames are not as exact, these are rendered again with more samples when all others are
     * done, by a server at the same port that the workers come to again. To be called once.
     *
     * @param sink takes each frame as soon as it is whole, on the calling thread; frames that are to be rendered again come then
     * @param progress hears how the film gets on, a few times a second, on the calling thread
     * @param cancelled asked a few times a second on the calling thread
     * @return whether all frames were given to the sink
     * @throws IOException if something in this process failed, or the sink does
     */
    public boolean await(Sink sink, RenderProgress progress, BooleanSupplier cancelled) throws IOException {
        Interrupts stop = new Interrupts(cancelled);
        try (this) {
            ServerRound server = first;
            while (server != null) {
                FilmQueue.Round now = round;
                server.await(progress, stop, () -> give(now, sink));
                audits.add(now, server);
                server = now.isDone() && !stop.getAsBoolean() ? after(now) : null;
            }
            return queue.isDone();
        } finally {
            queue.close();
            stop.restore();
        }
    }

    /** Gives what is whole to the sink. */
    private void give(FilmQueue.Round now, Sink sink) throws IOException {
        FrameAssemblies film = now.film();
        for (var whole = film.takeWhole(); whole.isPresent(); whole = film.takeWhole()) {
            Rendered rendered = whole.get().film().result();
            film.show(rendered.image());
            int number = now.number(whole.get().frame());
            if (queue.isEnough(now, whole.get().frame(), rendered)) {
                sink.frame(number, Results.of(rendered));
            }
        }
    }

    /** The audits of the frames that {@link #await} gave to the sink; without meaning before it has returned. */
    public RenderServer.AuditReport audits() {
        return audits.report();
    }

    private ServerRound after(FilmQueue.Round before) {
        FilmQueue.Round more;
        try {
            more = queue.next(before);
        } catch (CancellationException e) {
            return null;
        }
        if (more == null) {
            return null;
        }
        round = more;
        return chain.follow(more::job);
    }

    /**
     * Ends the server: workers are told why. Blocks for a few seconds at most, until the workers have heard of it. Harmless if it has
     * ended already.
     */
    @Override
    public void close() {
        chain.stop();
    }
}
