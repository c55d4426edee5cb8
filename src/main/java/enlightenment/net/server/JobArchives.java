package enlightenment.net.server;

import enlightenment.checkpoint.Origin;
import enlightenment.engine.UnitAssembly;
import enlightenment.file.ContentHash;
import enlightenment.render.ResultArchive;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;

/** The archives of a job. One that fails is not used any more: the picture is worth more than what is kept of it. */
final class JobArchives {
    static final JobArchives NONE = new JobArchives(List.of(), line -> {});

    private final Consumer<String> log;

    /** With the number that each has given the plan. */
    private final Map<ResultArchive, Integer> plans = new LinkedHashMap<>();

    private final Map<Integer, ContentHash> hashes = new TreeMap<>();

    JobArchives(List<ResultArchive> archives, Consumer<String> log) {
        this.log = log;
        archives.forEach(archive -> plans.put(archive, 0));
    }

    /** What an archive is asked for. */
    @FunctionalInterface
    private interface Use {
        void of(ResultArchive archive, int plan) throws IOException;
    }

    private void each(Use use) {
        for (ResultArchive archive : List.copyOf(plans.keySet())) {
            try {
                use.of(archive, plans.get(archive));
            } catch (IOException | RuntimeException e) {
                plans.remove(archive);
                String why = e instanceof IOException && e.getMessage() != null ? e.getMessage() : e.toString();
                log.accept(archive.name() + ": " + why + "; it is not used any more, the render goes on without");
            }
        }
    }

    /**
     * Keeps a plan, and puts into the picture what is kept of its units and is not there.
     *
     * @return those units, in ascending order
     */
    Set<Integer> begin(byte[] plan, UnitAssembly film) {
        each((archive, none) -> {
            plans.put(archive, archive.keep(plan));
            archive.replay(plans.get(archive), (unit, result) -> {
                byte[] bytes = PlainResult.of(film, unit, result);
                Optional<String> problem = film.problem(unit, bytes);
                if (problem.isPresent()) {
                    log.accept(archive.name() + ": tile " + unit + ": " + problem.get());
                } else if (!film.has(unit)) {
                    film.put(unit, bytes);
                    hashes.put(unit, ContentHash.of(bytes));
                }
            });
            if (!hashes.isEmpty()) {
                log.accept(archive.name() + ": " + hashes.size() + " of " + film.units() + " tiles are done already");
            }
        });
        return hashes.keySet();
    }

    /** The hash of a unit that {@link #begin} has put into the picture. */
    ContentHash hash(int unit) {
        return hashes.get(unit);
    }

    void keep(int unit, Origin origin, byte[] bytes) {
        each((archive, plan) -> archive.keep(plan, unit, origin.toString(), bytes));
    }

    void remove(int unit) {
        each((archive, plan) -> archive.remove(plan, unit));
    }

    void tick() {
        each((archive, plan) -> archive.tick());
    }
}
