package enlightenment.net;

import enlightenment.engine.DividedRender;
import enlightenment.engine.FilmAssembly;
import enlightenment.engine.Preview;
import enlightenment.engine.Rendered;
import enlightenment.engine.SharedImages;
import enlightenment.listen.ServerLog;
import enlightenment.net.job.Canary;
import enlightenment.net.job.JobContent;
import enlightenment.net.job.Results;
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
 * Renders a picture on many machines: {@link RenderWorker}s connect to this server, and may come, go and die as they please. The picture is that of
 * {@link enlightenment.render.Renderer}, bit for bit. docs/guide/distributed.md has how it is set up.
 *
 * <p>A server has threads of its own (daemons); its methods may be called by several threads at once. The module {@code
 * tools.jackson.dataformat.cbor} must be there, which nothing else needs.
 */
public final class RenderServer implements Closeable {
    private final ServerRound first;
    private final ServerRounds rounds;

    private RenderServer(ServerRound first, ServedPicture picture) {
        this.first = first;
        rounds = new ServerRounds(first, picture);
    }

    /**
     * Plans the render, which blocks, and begins to listen. Workers that come are given work from then on.
     *
     * @param cancelled asked now and then while the render is planned
     * @throws IOException if the server cannot listen, or a file of the options cannot be used; the message says why
     * @throws IllegalStateException if the library for CBOR, which is optional, is not there
     * @throws enlightenment.scene.SceneException if the scene cannot be used
     * @throws enlightenment.math.InvalidValueException if a setting cannot be used
     * @throws IllegalArgumentException if there is a checkpoint for a render that is planned anew each time, a machine to be
     *     pardoned is not expelled, or scene and textures are too large to be sent
     * @throws java.util.concurrent.CancellationException if it is cancelled before the render is planned: what is kept is as it was
     */
    public static RenderServer start(
            Scene scene, RenderSettings settings, ServerOptions options, BooleanSupplier cancelled) throws IOException {
        CborLibrary.require();
        ServerLog log = new ServerLog(options.log, System::nanoTime);
        boolean isKept = options.checkpoint.isPresent() || !options.archives.isEmpty();
        if (isKept && settings.budget().seconds().isPresent()) {
            throw new IllegalArgumentException(
                    "a budget of time is planned anew each time, so that what is kept would not fit: give samples");
        }
        // Before what takes long: these files may be of no use.
        Secrets secrets = Secrets.open(options.secrets(), log::say);
        Canary.hash();
        DividedRender render = DividedRender.prepare(scene, settings, new SharedImages(), options.room, cancelled);
        render.notes().forEach(log::say);
        Preview preview =
                options.statusPort < 0 ? null : render.preview(cancelled).orElse(null);
        ServedPicture picture =
                ServedPicture.of(render, JobContent.of(scene, render.outline(), options.version), preview);
        return new RenderServer(ServerRound.start(options, log, secrets, picture.job(log)), picture);
    }

    /** The port that it listens at. */
    public int port() {
        return first.port();
    }

    /** The port of the status page, or -1 if there is none. */
    public int statusPort() {
        return first.statusPort();
    }

    /** The certificate that a worker may pin: the SHA-256 of the server's certificate, 64 hexadecimal digits; empty without TLS. */
    public String pin() {
        return first.pin();
    }

    /**
     * Renders until the picture is done, it is cancelled, or the calling thread is interrupted, and closes the server. An interrupt stays
     * set. Where an error was asked for and the picture is not as exact, it is rendered again with more samples, by a server at the same
     * port that the workers come to again. To be called once.
     *
     * @param progress receives the state of the render a few times a second, on the calling thread
     * @param cancelled polled a few times a second on the calling thread
     * @return the last picture that became whole; if not even the first did, what there is of it
     * @throws IOException if something in this process failed
     */
    public RenderResult await(RenderProgress progress, BooleanSupplier cancelled) throws IOException {
        Interrupts stop = new Interrupts(cancelled);
        try {
            return Results.of(rounds.await(progress, stop));
        } finally {
            stop.restore();
        }
    }

    /** The audits of the picture that {@link #await} returned; without meaning before it has. */
    public AuditReport audits() {
        return AuditReport.of(rounds.audits());
    }

    /** The first round, for tests. */
    ServerRound round() {
        return first;
    }

    /**
     * Ends the server: workers receive the reason, the checkpoint is kept. Blocks for a few seconds at most, until the workers have
     * received it. No effect if the server has ended already.
     */
    @Override
    public void close() {
        rounds.stop();
    }

    /**
     * Which audits of what a server made were made: tiles that a second machine, or the server, has rendered too.
     *
     * @param due how many tiles were to be rendered by two; those of the server's own are not among them
     * @param missing how many of these rest on the word of one machine, as no other was there
     * @param isOfFilm whether {@code where} has frames
     * @param where the numbers of the tiles that are missing, in ascending order; of a film those of the frames that have any
     */
    public record AuditReport(int due, int missing, boolean isOfFilm, List<Integer> where) {
        /** The report of a render without audits. */
        public static final AuditReport NONE = new AuditReport(0, 0, false, List.of());

        /** {@code where} may not be null. */
        public AuditReport {
            where = List.copyOf(where);
        }

        private static AuditReport of(AuditCount c) {
            return new AuditReport(c.due(), c.missing(), c.isOfFilm(), c.where());
        }

        /** Whether a second machine has rendered all that it was to. */
        public boolean isComplete() {
            return missing == 0;
        }

        /** The missing audits, without full stop: {@code 2 of 9 audits were not made: no second machine checked ...}. */
        public String sentence() {
            return new AuditCount(due, missing, isOfFilm, where).sentence();
        }
    }

    /**
     * Renders the frames of a film with the help of {@link RenderWorker}s: each is the picture of {@link
     * enlightenment.render.Renderer}, bit for bit. All frames are one job, so workers stay connected from the first to the last, and begin
     * the next frame while others end the one before. docs/guide/distributed.md tells how it is set up.
     *
     * <p>A server has threads of its own (daemons); its methods may be called by several threads at once. The module {@code
     * tools.jackson.dataformat.cbor} must be there, which nothing else needs.
     */
    public static final class OfFilm implements Closeable {
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
            /** Neither may be null. */
            public Frame {
                Objects.requireNonNull(scene, "scene");
                Objects.requireNonNull(settings, "settings");
            }
        }

        /** Receives finished frames. */
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

        private OfFilm(FilmQueue queue, FilmQueue.Round round, ServerRound first) {
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
        public static OfFilm start(
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
            FilmQueue queue = new FilmQueue(
                    number -> wish(frames.apply(number)), options.room, options.version, log::say, cancelled);
            FilmQueue.Round round = queue.first(List.copyOf(numbers));
            return new OfFilm(queue, round, ServerRound.start(options, log, secrets, round.job()));
        }

        private static FilmQueue.Wish wish(Frame frame) {
            return new FilmQueue.Wish(frame.scene(), frame.settings());
        }

        /** The port that it listens at. */
        public int port() {
            return first.port();
        }

        /** The port of the status page, or -1 if there is none. */
        public int statusPort() {
            return first.statusPort();
        }

        /** The certificate that a worker may pin: the SHA-256 of the server's certificate, 64 hexadecimal digits; empty without TLS. */
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

        /** Passes finished frames to the sink. */
        private void give(FilmQueue.Round now, Sink sink) throws IOException {
            FrameAssemblies film = now.film();
            for (var whole = film.takeWhole(); whole.isPresent(); whole = film.takeWhole()) {
                FilmAssembly picture = whole.get().film();
                Rendered rendered = picture.result();
                film.show(picture.image());
                picture.film().release();
                int number = now.number(whole.get().frame());
                if (queue.isEnough(now, whole.get().frame(), rendered)) {
                    sink.frame(number, Results.of(rendered));
                } else {
                    rendered.image().release();
                }
            }
        }

        /** The audits of the frames that {@link #await} gave to the sink; without meaning before it has returned. */
        public AuditReport audits() {
            return AuditReport.of(audits.count());
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
         * Ends the server: workers receive the reason. Blocks for a few seconds at most, until the workers have received it. No effect if
         * the server has ended already.
         */
        @Override
        public void close() {
            chain.stop();
        }
    }
}
