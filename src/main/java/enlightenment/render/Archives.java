package enlightenment.render;

import enlightenment.engine.DividedRender;
import enlightenment.engine.EarlierUnits;
import enlightenment.engine.FilmAssembly;
import enlightenment.engine.GrowingMaker;
import enlightenment.engine.KeptPlan;
import enlightenment.engine.RenderOutline;
import enlightenment.film.SampleLog;
import enlightenment.plan.RenderPlan;
import enlightenment.plan.Rounds;
import enlightenment.scene.RenderSettings;
import enlightenment.text.FailureText;
import enlightenment.work.ThreadEnd;
import java.io.IOException;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/**
 * The archives of a render. For use by several threads at once. An archive that fails is not used any more, and the render goes on without
 * it.
 */
final class Archives {
    private static final long TICK_MILLIS = 200;

    /** The worker that archives name as the maker of results. */
    private static final String WORKER = "local";

    private final Consumer<String> listener;

    /** Lock held while the listener of the render is called, so that one thread at a time calls it. */
    private final Object telling = new Object();

    private final List<Kept> all = new ArrayList<>();

    /** An archive, what it calls the plan of this round, and which of its units it has. */
    private static final class Kept {
        final RenderResult.Archive archive;
        int plan;
        final BitSet units = new BitSet();

        /** Plans with fewer samples, those with most of them first. */
        final List<Earlier> earlier = new ArrayList<>();

        /** The samples per pixel of the largest of those plans whose units are others, so that nothing goes on from them; 0 for none. */
        double others;

        Kept(RenderResult.Archive archive) {
            this.archive = archive;
        }
    }

    /** A plan with fewer samples, by its number. */
    private record Earlier(int plan, double samples, EarlierUnits units) {}

    /** One call to an archive. */
    @FunctionalInterface
    private interface Use {
        void of(Kept kept) throws IOException;
    }

    /** @param notes receives a line for each archive that fails, and for what is there already */
    Archives(List<RenderResult.Archive> archives, Consumer<String> notes) {
        listener = notes;
        archives.forEach(archive -> all.add(new Kept(archive)));
    }

    /** Lock to hold while the listener of the render is called, so that one thread at a time calls it. */
    Object telling() {
        return telling;
    }

    private void note(String text) {
        synchronized (telling) {
            listener.accept(text);
        }
    }

    private synchronized void each(Use use) {
        // Channels to files close themselves on an interrupted thread.
        boolean wasInterrupted = Thread.interrupted();
        try {
            eachWithoutInterrupt(use);
        } finally {
            if (wasInterrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private void eachWithoutInterrupt(Use use) {
        for (Kept kept : List.copyOf(all)) {
            if (all.contains(kept)) {
                ask(kept, use);
            }
        }
    }

    private void ask(Kept kept, Use use) {
        try {
            use.of(kept);
        } catch (IOException | RuntimeException e) {
            all.remove(kept);
            note(FailureText.of(kept.archive.name(), e) + "; it is not used any more, the render goes on without");
        }
    }

    /** The plan that was made for these settings before, in that round. */
    Optional<RenderPlan> planFor(RenderSettings settings, int round) {
        List<RenderPlan> found = new ArrayList<>();
        each(kept -> {
            for (byte[] plan : kept.archive.plans()) {
                KeptPlan.read(plan)
                        .filter(p -> p.isFor(settings, round))
                        .ifPresent(p -> found.add(p.outline().plan()));
            }
        });
        return found.stream().findFirst();
    }

    /** Begins a round: takes over what is kept of its units. */
    void begin(int round, DividedRender render, FilmAssembly film) {
        byte[] plan = KeptPlan.of(round, render.outline()).toBytes();
        each(kept -> {
            kept.plan = kept.archive.keep(plan);
            kept.units.clear();
            kept.earlier.clear();
            kept.others = 0;
            replay(kept, render.outline(), film);
            findEarlier(kept, render.outline());
        });
        each(this::giveOthers);
        if (film.done() > 0) {
            note(film.done() + " of " + film.units() + " units are kept from before");
        }
        noteEarlier(render, film);
    }

    private void findEarlier(Kept kept, RenderOutline outline) throws IOException {
        List<byte[]> plans = kept.archive.plans();
        for (int i = 0; i < plans.size(); i++) {
            KeptPlan plan = KeptPlan.read(plans.get(i))
                    .filter(p -> p.hasFewerSamplesThan(outline))
                    .orElse(null);
            if (plan != null) {
                double samples = plan.outline().plan().samples();
                Optional<EarlierUnits> units = EarlierUnits.of(plan.outline(), outline);
                if (units.isPresent()) {
                    kept.earlier.add(new Earlier(i, samples, units.get()));
                } else {
                    kept.others = Math.max(kept.others, samples);
                }
            }
        }
        kept.earlier.sort(Comparator.comparingDouble(Earlier::samples).reversed());
    }

    private void noteEarlier(DividedRender render, FilmAssembly film) {
        if (film.film().isComplete()) {
            return;
        }
        OptionalDouble tiles = all.stream()
                .flatMap(kept -> kept.earlier.stream())
                .mapToDouble(Earlier::samples)
                .findFirst();
        double most = all.stream().mapToDouble(kept -> kept.others).max().orElse(0);
        if (tiles.isPresent() && render.canGrow()) {
            note("tiles go on from " + Rounds.number(tiles.getAsDouble()) + " samples per pixel where they are kept"
                    + (render.plan().lightPaths() > 0 ? "; paths from lights are followed anew" : ""));
        } else if (tiles.isPresent() || most > 0) {
            note("what is kept has " + Rounds.number(tiles.orElse(most)) + " samples per pixel"
                    + (render.methodCanGrow()
                            ? ", in units of another size, so all are taken anew"
                            : ": " + render.plan().method()
                                    + " takes others where there are more, so all are taken anew"));
        }
    }

    /** The result of an earlier plan that a tile can grow from; null without one. */
    byte[] earlier(int unit, FilmAssembly film, GrowingMaker maker) {
        List<byte[]> found = new ArrayList<>();
        each(kept -> {
            for (Earlier earlier : kept.earlier) {
                OptionalInt number = earlier.units().of(unit);
                if (!found.isEmpty() || number.isEmpty()) {
                    return;
                }
                kept.archive
                        .find(earlier.plan(), number.getAsInt())
                        .filter(bytes -> film.problemOfKept(unit, bytes).isEmpty() && maker.canGrow(unit, bytes))
                        .ifPresent(found::add);
            }
        });
        return found.isEmpty() ? null : found.get(0);
    }

    /** The results of this plan, and of those that have the same units. */
    private void replay(Kept kept, RenderOutline outline, FilmAssembly film) throws IOException {
        List<byte[]> plans = kept.archive.plans();
        List<String> wrong = new ArrayList<>();
        for (int i = 0; i < plans.size(); i++) {
            boolean isSame = i == kept.plan
                    || KeptPlan.read(plans.get(i))
                            .filter(p -> p.hasUnitsOf(outline))
                            .isPresent();
            if (!isSame) {
                continue;
            }
            kept.archive.replay(i, (unit, result) -> {
                Optional<String> problem = film.problemOfKept(unit, result);
                if (problem.isPresent()) {
                    wrong.add("unit " + unit + ": " + problem.get());
                } else {
                    kept.units.set(unit);
                    if (!film.has(unit)) {
                        film.put(unit, result);
                    }
                }
            });
        }
        if (!wrong.isEmpty()) {
            note(kept.archive.name() + ": " + wrong.size() + " results make no sense and are rendered again, such as "
                    + wrong.get(0));
        }
    }

    /** Copies results of an archive to the others that lack them. */
    private void giveOthers(Kept kept) throws IOException {
        for (int unit = kept.units.nextSetBit(0); unit >= 0; unit = kept.units.nextSetBit(unit + 1)) {
            int number = unit;
            List<Kept> without =
                    all.stream().filter(other -> !other.units.get(number)).toList();
            Optional<byte[]> result = without.isEmpty() ? Optional.empty() : kept.archive.find(kept.plan, unit);
            if (result.isPresent()) {
                for (Kept other : without) {
                    ask(other, o -> {
                        o.archive.keep(o.plan, number, WORKER, result.get());
                        o.units.set(number);
                    });
                }
            }
        }
    }

    /** Keeps the result of a unit. */
    void keep(int unit, byte[] result) {
        each(kept -> kept.archive.keep(kept.plan, unit, WORKER, result));
    }

    /**
     * The listener through which one thread's camera samples reach the archives.
     *
     * @param width columns of the whole picture
     */
    Samples samples(int width) {
        return new Samples(width);
    }

    /** Passes the samples of one thread to the archives that keep samples. */
    final class Samples {
        private final SampleLog log;
        private int unit;

        private Samples(int width) {
            boolean[] wanted = new boolean[2];
            each(kept -> {
                if (kept.archive instanceof RenderResult.Archive.OfSamples samples) {
                    wanted[0] |= samples.keepsSamples();
                    wanted[1] |= samples.keepsRays();
                }
            });
            log = wanted[0] ? new SampleLog(wanted[1], width, this::keep) : null;
        }

        /** The log that samples are written to; null if no archive keeps samples. */
        SampleLog log() {
            return log;
        }

        void beginUnit(int number) {
            unit = number;
        }

        private void keep(int kind, int count, byte[] block) {
            each(kept -> {
                if (kept.archive instanceof RenderResult.Archive.OfSamples samples && samples.keepsSamples()) {
                    samples.keepSamples(kept.plan, unit, kind, count, block);
                }
            });
        }
    }

    /** Lets archives know that time passes, until it is closed. */
    Ticker startTicking() {
        return new Ticker();
    }

    /** Calls the archives' tick, by a thread that is never interrupted: the file that it writes to would be closed. */
    final class Ticker implements AutoCloseable {
        private final CountDownLatch over = new CountDownLatch(1);
        private final Thread thread = new Thread(this::tick, "enlightenment-archives");

        private Ticker() {
            thread.setDaemon(true);
            thread.start();
        }

        private void tick() {
            try {
                while (!over.await(TICK_MILLIS, TimeUnit.MILLISECONDS)) {
                    each(kept -> kept.archive.tick());
                }
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }

        /** Ends the thread and waits for it: the caller may then close the archives. */
        @Override
        public void close() {
            over.countDown();
            ThreadEnd.await(thread);
        }
    }
}
