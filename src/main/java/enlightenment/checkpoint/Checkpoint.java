package enlightenment.checkpoint;

import enlightenment.job.RenderIdentity;
import enlightenment.render.RenderResult;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * A journal as the archive of a render in one process. Which results it holds is known from opening it; they themselves are read when they
 * are asked for.
 */
public final class Checkpoint implements RenderResult.Archive {
    private final Path path;
    private final List<byte[]> plans = new ArrayList<>();

    /** Numbers of plans, by their keys. */
    private final Map<Long, Integer> numbers = new HashMap<>();

    /** By key of the plan and by unit, the place of the result in the journal. */
    private final Map<Long, Map<Integer, Long>> places = new HashMap<>();

    /** By machine, the places of its results in the journal. */
    private final Map<Origin, Set<Long>> ofMachines = new HashMap<>();

    private CheckpointJournal journal;

    private Checkpoint(Path path) {
        this.path = path;
    }

    /**
     * Goes on from a checkpoint, or begins one.
     *
     * @param resume whether it may hold results of this render already
     * @throws IOException if the file cannot be used; the message says why. It is left as it is then
     */
    public static Checkpoint open(Path path, RenderIdentity render, boolean resume) throws IOException {
        return open(path, render, resume, file -> file.force(true));
    }

    /** {@link #open(Path, RenderIdentity, boolean)} with another way to force, for tests. */
    static Checkpoint open(Path path, RenderIdentity render, boolean resume, CheckpointJournal.Forcing forcing)
            throws IOException {
        Checkpoint opened = new Checkpoint(path);
        opened.journal = CheckpointJournal.open(path, render, resume, System.nanoTime(), opened::found, forcing);
        return opened;
    }

    private void found(long plan, JournalRecord record, long place) {
        if (record instanceof JournalRecord.Planned planned) {
            number(planned.plan());
        } else if (record instanceof JournalRecord.Kept kept) {
            places.computeIfAbsent(plan, p -> new LinkedHashMap<>()).put(kept.tile(), place);
            if (kept.origin() instanceof Origin.Peer machine) {
                ofMachines.computeIfAbsent(machine, m -> new HashSet<>()).add(place);
            }
        } else if (record instanceof JournalRecord.Revoked revoked) {
            places.computeIfAbsent(plan, p -> new LinkedHashMap<>()).remove(revoked.tile());
        } else if (record instanceof JournalRecord.Expelled expelled) {
            Set<Long> lies = ofMachines.getOrDefault(expelled.machine(), Set.of());
            places.values().forEach(units -> units.values().removeAll(lies));
        }
    }

    private int number(byte[] plan) {
        return numbers.computeIfAbsent(CheckpointJournal.key(plan), key -> {
            plans.add(plan);
            return plans.size() - 1;
        });
    }

    /** The damage that was found, in words; empty if there is none. */
    public List<String> damage() {
        List<String> lines = new ArrayList<>();
        if (journal.gaps() > 0) {
            lines.add("damaged in " + journal.gaps() + " places, " + journal.lostBytes()
                    + " bytes; what they held is rendered again");
        }
        if (journal.cutBytes() > 0) {
            lines.add("a torn end of " + journal.cutBytes() + " bytes was cut off");
        }
        return lines;
    }

    /** The number of results of all plans. */
    public int results() {
        return places.values().stream().mapToInt(Map::size).sum();
    }

    @Override
    public String name() {
        return "checkpoint " + path;
    }

    @Override
    public List<byte[]> plans() {
        return List.copyOf(plans);
    }

    @Override
    public int keep(byte[] plan) throws IOException {
        long key = CheckpointJournal.key(plan);
        if (!numbers.containsKey(key)) {
            // Twice: all results of its units would be of no use without it.
            journal.append(System.nanoTime(), key, new JournalRecord.Planned(plan));
            journal.append(System.nanoTime(), key, new JournalRecord.Planned(plan));
        }
        return number(plan);
    }

    @Override
    public void replay(int plan, Replay to) throws IOException {
        for (int unit : List.copyOf(places(plan).keySet())) {
            Optional<byte[]> result = find(plan, unit);
            if (result.isPresent()) {
                to.result(unit, result.get());
            }
        }
    }

    private Map<Integer, Long> places(int plan) {
        return places.computeIfAbsent(CheckpointJournal.key(plans.get(plan)), key -> new LinkedHashMap<>());
    }

    @Override
    public Optional<byte[]> find(int plan, int unit) throws IOException {
        Long place = places(plan).get(unit);
        return place == null
                ? Optional.empty()
                : journal.read(place)
                        .filter(JournalRecord.Kept.class::isInstance)
                        .map(record -> ((JournalRecord.Kept) record).data());
    }

    @Override
    public void keep(int plan, int unit, String worker, byte[] result) throws IOException {
        long key = CheckpointJournal.key(plans.get(plan));
        long place = journal.append(System.nanoTime(), key, new JournalRecord.Kept(unit, Origin.SERVER, result));
        places(plan).put(unit, place);
    }

    @Override
    public void remove(int plan, int unit) throws IOException {
        long key = CheckpointJournal.key(plans.get(plan));
        journal.append(System.nanoTime(), key, new JournalRecord.Revoked(unit));
        places(plan).remove(unit);
    }

    @Override
    public void tick() throws IOException {
        journal.tick(System.nanoTime());
    }

    @Override
    public void close() throws IOException {
        journal.close();
    }
}
