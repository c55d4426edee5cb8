package enlightenment.net.server;

import enlightenment.checkpoint.Origin;
import enlightenment.engine.UnitAssembly;
import enlightenment.render.RenderResult;
import enlightenment.text.FailureText;
import java.io.IOException;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;

/**
 * The archives of a job. One that fails is not used any more: the picture is worth more than what is kept of it. From {@link #start} on
 * they are written by a thread of their own.
 */
final class JobArchives implements AutoCloseable {
    static final JobArchives NONE = new JobArchives(List.of(), line -> {});

    /** Results that wait to be written have no more bytes together. */
    private static final long MOST_WAITING = 32L << 20;

    private final Consumer<String> log;
    private final List<Kept> all = new ArrayList<>();

    /** Null before the start, and where there are no archives. */
    private ArchiveThread writer;

    /** An archive, what it calls the plan, and which units it had in the beginning. */
    private static final class Kept {
        final RenderResult.Archive archive;
        int plan;
        final BitSet units = new BitSet();

        Kept(RenderResult.Archive archive) {
            this.archive = archive;
        }
    }

    JobArchives(List<RenderResult.Archive> archives, Consumer<String> log) {
        this.log = log;
        archives.forEach(archive -> all.add(new Kept(archive)));
    }

    /** One call to an archive. */
    @FunctionalInterface
    private interface Use {
        void of(Kept kept) throws IOException;
    }

    /** Receives a result that is not in the picture yet. */
    @FunctionalInterface
    interface Taker {
        void take(int unit, byte[] result);
    }

    private void each(Use use) {
        for (Kept kept : List.copyOf(all)) {
            try {
                use.of(kept);
            } catch (IOException | RuntimeException | LinkageError | OutOfMemoryError e) {
                all.remove(kept);
                log.accept(FailureText.of(kept.archive.name(), e)
                        + "; it is not used any more, the render goes on without");
            }
        }
    }

    private void later(long bytes, Use use) {
        if (writer != null) {
            writer.add(bytes, () -> each(use));
        }
    }

    /**
     * Keeps a plan, and tells what is kept of its units and not in the picture.
     *
     * @param distrusted machines whose results are forgotten
     * @param taker puts results into the picture
     */
    void begin(byte[] plan, Set<Origin.Peer> distrusted, UnitAssembly film, Taker taker) {
        each(kept -> {
            RenderResult.Archive archive = kept.archive;
            kept.plan = archive.keep(plan);
            for (Origin.Peer machine : distrusted) {
                archive.removeAll(kept.plan, machine.toString());
            }
            int[] taken = new int[1];
            archive.replay(kept.plan, (unit, result) -> {
                byte[] bytes = PlainResult.of(film, unit, result);
                Optional<String> problem = film.problem(unit, bytes);
                if (problem.isPresent()) {
                    log.accept(archive.name() + ": tile " + unit + ": " + problem.get());
                    return;
                }
                kept.units.set(unit);
                if (!film.has(unit)) {
                    taker.take(unit, bytes);
                    taken[0]++;
                }
            });
            if (taken[0] > 0) {
                log.accept(archive.name() + ": " + taken[0] + " of " + film.units() + " tiles are done already");
            }
        });
    }

    /** Whether an archive had no result of a unit in the beginning. */
    boolean lack(int unit) {
        return all.stream().anyMatch(kept -> !kept.units.get(unit));
    }

    /** Passes a result to the archives that had none of its unit; before the start. */
    void complete(int unit, Origin origin, byte[] bytes) {
        each(kept -> {
            if (!kept.units.get(unit)) {
                kept.archive.keep(kept.plan, unit, origin.toString(), bytes);
            }
        });
    }

    /** From now on a thread of their own writes them. */
    void start() {
        writer = new ArchiveThread(MOST_WAITING, () -> each(kept -> kept.archive.tick()));
    }

    /** Keeps a result, soon. */
    void keep(int unit, Origin origin, byte[] bytes) {
        later(bytes.length, kept -> kept.archive.keep(kept.plan, unit, origin.toString(), bytes));
    }

    /** Forgets a result, soon. */
    void remove(int unit) {
        later(0, kept -> kept.archive.remove(kept.plan, unit));
    }

    /** Returns when archives have what they were given, and hear of nothing more. */
    @Override
    public void close() {
        if (writer != null) {
            writer.close();
        }
    }
}
