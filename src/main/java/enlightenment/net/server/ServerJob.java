package enlightenment.net.server;

import enlightenment.checkpoint.CheckpointJournal;
import enlightenment.checkpoint.JournalRecord;
import enlightenment.checkpoint.Origin;
import enlightenment.checkpoint.Restored;
import enlightenment.checkpoint.ResultJournal;
import enlightenment.engine.DividedRender;
import enlightenment.engine.FilmAssembly;
import enlightenment.engine.KeptPlan;
import enlightenment.engine.UnitAssembly;
import enlightenment.engine.UnitSource;
import enlightenment.file.ContentHash;
import enlightenment.job.RenderIdentity;
import enlightenment.net.job.JobContent;
import enlightenment.net.job.TileData;
import enlightenment.net.schedule.Action;
import enlightenment.render.RenderResult;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;

/** The state of a server's render: the job, its picture so far and its checkpoint. One thread at a time changes it. */
public final class ServerJob implements Closeable {
    /** Fewer digits may be those of two machines. */
    private static final int FEWEST_DIGITS = 8;

    private final UnitSource units;
    private final JobContent content;
    private final UnitAssembly film;
    private final Consumer<String> log;

    /** The plan that the checkpoint is of; null without one. */
    private final KeptPlan plan;

    /** The hashes of the tiles that are kept. */
    private final ContentHash[] kept;

    /** Results that have to be subtracted when their tiles are revoked. */
    private final ResultJournal results;

    private Restored restored = Restored.NOTHING;
    private CheckpointJournal journal;

    /** The journal's key of the plan. */
    private long key;

    /** By tile, the place of its restored result in the journal, until archives have it. */
    private Map<Integer, Long> places = Map.of();

    private JobArchives archives = JobArchives.NONE;

    private Set<Origin.Peer> alreadyExpelled = Set.of();

    /** The job of one picture. */
    public static ServerJob of(DividedRender render, FilmAssembly film, JobContent content, Consumer<String> log) {
        return new ServerJob(render, film, content, KeptPlan.of(render.round(), render.outline()), log);
    }

    /**
     * The job of a film, which has no checkpoint.
     *
     * @param film where its pictures are put together
     */
    public static ServerJob of(UnitSource units, FrameAssemblies film, JobContent content, Consumer<String> log) {
        return new ServerJob(units, film, content, null, log);
    }

    private ServerJob(UnitSource units, UnitAssembly film, JobContent content, KeptPlan plan, Consumer<String> log) {
        this.units = units;
        this.plan = plan;
        this.content = content;
        this.log = log;
        this.film = film;
        kept = new ContentHash[units.units()];
        results = new ResultJournal(film.needsStore() ? units.units() : 0);
        if (film.needsStore()) {
            film.keepIn(results);
        }
    }

    /** Machines that were found out in a job before this one stay expelled. */
    public void expelledAlready(Set<Origin.Peer> machines) {
        alreadyExpelled = Set.copyOf(machines);
    }

    /** Goes on from a checkpoint, or begins one. */
    public void open(Path checkpoint) throws IOException {
        open(checkpoint, List.of());
    }

    /**
     * Goes on from a checkpoint, or begins one.
     *
     * @param pardoned machines that it says are expelled, and are not any more, each by its first digits
     * @throws IllegalArgumentException if one of them is not expelled
     */
    public void open(Path checkpoint, List<String> pardoned) throws IOException {
        Reading reading = new Reading();
        byte[] bytes = plan.toBytes();
        key = CheckpointJournal.key(bytes);
        reading.plans.addAll(List.of(0L, key));
        journal = CheckpointJournal.open(checkpoint, identity(), true, System.nanoTime(), reading::add);
        places = reading.places;
        if (!reading.knowsPlan) {
            // Twice: all results of its units would be of no use without it.
            journal.append(System.nanoTime(), key, new JournalRecord.Planned(bytes));
            journal.append(System.nanoTime(), key, new JournalRecord.Planned(bytes));
        }
        pardon(pardoned, reading.builder);
        restored = reading.builder.build();
        BitSet there = new BitSet();
        restored.tiles().forEach(tile -> {
            there.set(tile.tile());
            kept[tile.tile()] = tile.hash();
        });
        for (int tile = 0; tile < tiles(); tile++) {
            if (!there.get(tile)) {
                film.remove(tile);
            }
        }
        reading.wrong.forEach(w -> log.accept("checkpoint: " + w));
        tellOfCheckpoint();
    }

    /** The records of a checkpoint, which may be of the same picture with other numbers of samples, too. */
    private final class Reading {
        final Restored.Builder builder = new Restored.Builder();
        final List<String> wrong = new ArrayList<>();

        /** The keys of plans with the same units, and that of what is about none. */
        final Set<Long> plans = new HashSet<>();

        /** The last place of each tile. */
        final Map<Integer, Long> places = new HashMap<>();

        boolean knowsPlan;

        void add(long about, JournalRecord entry, long place) {
            if (entry instanceof JournalRecord.Planned planned) {
                knowsPlan |= about == key;
                KeptPlan.read(planned.plan())
                        .filter(p -> p.hasUnitsOf(plan.outline()))
                        .ifPresent(p -> plans.add(about));
            } else if (plans.contains(about)) {
                if (entry instanceof JournalRecord.Kept tile) {
                    put(tile, place);
                } else {
                    builder.add(entry);
                }
            }
        }

        private void put(JournalRecord.Kept tile, long place) {
            byte[] result = PlainResult.of(film, tile.tile(), tile.data());
            Optional<String> problem = film.problem(tile.tile(), result);
            if (problem.isPresent()) {
                wrong.add("tile " + tile.tile() + ": " + problem.get());
                return;
            }
            film.put(tile.tile(), result);
            places.put(tile.tile(), place);
            builder.kept(tile.tile(), tile.origin(), film.digest(tile.tile(), result));
        }
    }

    private void tellOfCheckpoint() {
        if (journal.gaps() > 0) {
            log.accept("checkpoint: damaged in " + journal.gaps() + " places, " + journal.lostBytes()
                    + " bytes; what they held is rendered again");
        }
        if (journal.cutBytes() > 0) {
            log.accept("checkpoint: a torn end of " + journal.cutBytes() + " bytes was cut off");
        }
        if (film.done() > 0) {
            log.accept("checkpoint: " + film.done() + " of " + tiles() + " tiles are done already");
        }
    }

    private RenderIdentity identity() {
        return RenderIdentity.of(content.scene(), plan.outline().settings(), content.build());
    }

    private void pardon(List<String> machines, Restored.Builder builder) throws IOException {
        Set<Origin.Peer> expelled = builder.build().expelled();
        for (String digits : machines) {
            List<Origin.Peer> meant = expelled.stream()
                    .filter(m -> digits.length() >= FEWEST_DIGITS
                            && m.machine().toString().startsWith(digits))
                    .toList();
            if (meant.size() != 1) {
                close();
                throw new IllegalArgumentException("no expelled machine is called " + digits + "; "
                        + (expelled.isEmpty() ? "none is expelled" : "these are: " + words(expelled)));
            }
            JournalRecord pardon = new JournalRecord.Pardoned(meant.get(0));
            builder.add(pardon);
            journal.append(System.nanoTime(), 0, pardon);
            log.accept("machine " + meant.get(0) + " is pardoned");
        }
    }

    private static String words(Set<Origin.Peer> machines) {
        return machines.stream().map(Origin.Peer::toString).sorted().collect(Collectors.joining(", "));
    }

    /**
     * Goes on from archives, after the checkpoint, gives each what the other has, and keeps in them what is done from now on; of a job of
     * one picture.
     */
    public void keepIn(List<RenderResult.Archive> all) {
        if (all.isEmpty()) {
            return;
        }
        archives = new JobArchives(all, log);
        List<Restored.Tile> tiles = new ArrayList<>(restored.tiles());
        archives.begin(plan.toBytes(), restored().expelled(), film, (tile, bytes) -> {
            film.put(tile, bytes);
            // They count as the server's own: a process that can write to an archive can write anything there.
            kept[tile] = film.digest(tile, bytes);
            tiles.add(new Restored.Tile(tile, Origin.SERVER, kept[tile], null));
            write(key, new JournalRecord.Kept(tile, Origin.SERVER, bytes));
        });
        for (Restored.Tile tile : restored.tiles()) {
            if (archives.lack(tile.tile())) {
                inJournal(tile.tile()).ifPresent(bytes -> archives.complete(tile.tile(), tile.origin(), bytes));
            }
        }
        places = Map.of();
        tiles.sort(Comparator.comparingInt(Restored.Tile::tile));
        restored = new Restored(tiles, restored.expelled());
        archives.start();
    }

    /**
     * A result of a unit, with the hash by which it is compared.
     *
     * @param bytes without problems
     */
    public TileData result(int unit, byte[] bytes) {
        return new TileData.Bytes(bytes, film.digest(unit, bytes));
    }

    /** The result that the journal brought of a tile. */
    private Optional<byte[]> inJournal(int tile) {
        if (journal == null || !places.containsKey(tile)) {
            return Optional.empty();
        }
        try {
            return journal.read(places.get(tile))
                    .map(entry -> entry instanceof JournalRecord.Kept k ? PlainResult.of(film, tile, k.data()) : null);
        } catch (IOException e) {
            giveUpJournal(e);
            return Optional.empty();
        }
    }

    /** Performs an action on picture, journal and archives; false if it is an action of another kind. */
    public boolean keep(Action action) {
        if (action instanceof Action.Keep a) {
            film.put(a.tile(), a.data().bytes());
            kept[a.tile()] = a.data().hash();
            write(key, new JournalRecord.Kept(a.tile(), a.origin(), a.data().bytes()));
            archives.keep(a.tile(), a.origin(), a.data().bytes());
        } else if (action instanceof Action.Confirm a) {
            write(key, new JournalRecord.Confirmed(a.tile(), a.by(), kept[a.tile()]));
        } else if (action instanceof Action.Revoke a) {
            film.remove(a.tile());
            write(key, new JournalRecord.Revoked(a.tile()));
            archives.remove(a.tile());
        } else if (action instanceof Action.Expel a) {
            log.accept("machine " + a.machine() + " expelled: " + a.reason()
                    + (journal == null ? "" : " (started again with --pardon " + a.machine() + " it is let in)"));
            write(0, new JournalRecord.Expelled(a.machine()));
        } else {
            return false;
        }
        return true;
    }

    private void write(long about, JournalRecord entry) {
        if (journal == null) {
            return;
        }
        try {
            journal.append(System.nanoTime(), about, entry);
        } catch (IOException e) {
            giveUpJournal(e);
        }
    }

    /** The picture is worth more than its checkpoint. */
    private void giveUpJournal(IOException e) {
        log.accept("the checkpoint cannot be written any more, going on without: " + e.getMessage());
        try {
            journal.close();
        } catch (IOException again) {
            log.accept("nor closed: " + again.getMessage());
        }
        journal = null;
    }

    /** Time has passed. */
    public void tick() {
        if (journal != null) {
            try {
                journal.tick(System.nanoTime());
            } catch (IOException e) {
                giveUpJournal(e);
            }
        }
    }

    public UnitSource units() {
        return units;
    }

    public UnitAssembly film() {
        return film;
    }

    public JobContent content() {
        return content;
    }

    public Restored restored() {
        if (alreadyExpelled.isEmpty()) {
            return restored;
        }
        Set<Origin.Peer> all = new HashSet<>(restored.expelled());
        all.addAll(alreadyExpelled);
        return new Restored(restored.tiles(), all);
    }

    public ContentHash hash() {
        return content.hash();
    }

    public int tiles() {
        return units.units();
    }

    @Override
    public void close() throws IOException {
        // Without the server's lock: all that waits for a database is written here.
        archives.close();
        try (results) {
            if (journal != null) {
                journal.close();
                journal = null;
            }
        }
    }
}
