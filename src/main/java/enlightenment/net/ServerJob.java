package enlightenment.net;

import enlightenment.render.FilmAssembly;
import enlightenment.render.TiledRender;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;

/** What a server renders: the job, its picture so far and its checkpoint. One thread at a time changes it. */
final class ServerJob implements Closeable {
    private final TiledRender render;
    private final JobContent content;
    private final FilmAssembly film;
    private final Consumer<String> log;
    private Restored restored = Restored.NOTHING;
    private Journal journal;
    private Set<String> alreadyExpelled = Set.of();

    ServerJob(TiledRender render, JobContent content, Consumer<String> log) {
        this.render = render;
        this.content = content;
        this.log = log;
        film = render.assembly();
    }

    /** The job of the same picture with more samples; machines that were found out stay expelled. */
    ServerJob with(TiledRender more, String build, Set<String> expelled) {
        ServerJob next = new ServerJob(more, content.with(more.outline().settings(), more.plan(), build), log);
        next.alreadyExpelled = Set.copyOf(expelled);
        return next;
    }

    /** Goes on from a checkpoint, or begins one. */
    void open(Path checkpoint) throws IOException {
        Restored.Builder builder = new Restored.Builder();
        List<String> wrong = new ArrayList<>();
        journal = Journal.open(checkpoint, hash(), tiles(), System.nanoTime(), entry -> {
            if (entry instanceof JournalRecord.Kept kept) {
                String problem = film.problem(kept.tile(), kept.data()).orElse(null);
                if (problem != null) {
                    wrong.add("tile " + kept.tile() + ": " + problem);
                    return;
                }
                film.put(kept.tile(), kept.data());
            }
            builder.add(entry);
        });
        restored = builder.build();
        BitSet there = new BitSet();
        restored.tiles().forEach(tile -> there.set(tile.tile()));
        for (int tile = 0; tile < tiles(); tile++) {
            if (!there.get(tile)) {
                film.remove(tile);
            }
        }
        wrong.forEach(w -> log.accept("checkpoint: " + w));
        if (journal.cutBytes() > 0) {
            log.accept("checkpoint: a torn end of " + journal.cutBytes() + " bytes was cut off");
        }
        if (film.done() > 0) {
            log.accept("checkpoint: " + film.done() + " of " + tiles() + " tiles are done already");
        }
    }

    /** What is to be kept; false if the action is none of these. */
    boolean keep(Action action) {
        if (action instanceof Action.Keep a) {
            film.put(a.tile(), a.data().bytes());
            write(new JournalRecord.Kept(a.tile(), a.machine(), a.data().bytes()));
        } else if (action instanceof Action.Confirm a) {
            write(new JournalRecord.Confirmed(a.tile()));
        } else if (action instanceof Action.Revoke a) {
            film.remove(a.tile());
            write(new JournalRecord.Revoked(a.tile()));
        } else if (action instanceof Action.Expel a) {
            log.accept(a.machine() + " expelled: " + a.reason());
            write(new JournalRecord.Expelled(a.machine()));
        } else {
            return false;
        }
        return true;
    }

    private void write(JournalRecord entry) {
        if (journal == null) {
            return;
        }
        try {
            journal.append(System.nanoTime(), entry);
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
    void tick() {
        if (journal != null) {
            try {
                journal.tick(System.nanoTime());
            } catch (IOException e) {
                giveUpJournal(e);
            }
        }
    }

    TiledRender render() {
        return render;
    }

    FilmAssembly film() {
        return film;
    }

    JobContent content() {
        return content;
    }

    Restored restored() {
        if (alreadyExpelled.isEmpty()) {
            return restored;
        }
        Set<String> all = new HashSet<>(restored.expelled());
        all.addAll(alreadyExpelled);
        return new Restored(restored.tiles(), all);
    }

    ContentHash hash() {
        return content.hash();
    }

    int tiles() {
        return render.tiles();
    }

    @Override
    public void close() throws IOException {
        if (journal != null) {
            journal.close();
            journal = null;
        }
    }
}
