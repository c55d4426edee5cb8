package enlightenment.net;

import enlightenment.checkpoint.Origin;
import enlightenment.engine.DividedRender;
import enlightenment.engine.FilmAssembly;
import enlightenment.engine.FilmRoom;
import enlightenment.file.ContentHash;
import enlightenment.job.Build;
import enlightenment.net.job.Canary;
import enlightenment.net.job.JobContent;
import enlightenment.net.job.Results;
import enlightenment.net.schedule.Action;
import enlightenment.net.server.ServerJob;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.SceneReader;
import java.io.Closeable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import java.util.stream.IntStream;

/**
 * A render whose tiles are made by another engine for distributed computing, such as Apache Spark. It has what to send there, what is missing, the
 * checkpoint and the picture. The engine decides who makes which tile, and when again. For use by several threads at once.
 */
public final class EngineJob implements Closeable {
    private final ServerJob job;
    private final FilmAssembly film;
    private final ContentHash canary;

    private EngineJob(ServerJob job, FilmAssembly film) {
        this.job = job;
        this.film = film;
        canary = Canary.hash();
    }

    /**
     * Compiles the scene and plans the render.
     *
     * @param checkpoint where to keep what is done, and to go on from; null for nowhere
     * @param log hears of what a person may want to know
     * @param cancelled asked now and then while the render is planned
     * @throws IOException if the checkpoint cannot be used, is in use or is one of another job
     * @throws SceneException if the scene cannot be used
     * @throws enlightenment.math.InvalidValueException if a setting cannot be used
     * @throws IllegalArgumentException if there is a checkpoint for a render that is planned anew each time, or scene and
     *     textures are too large
     * @throws java.util.concurrent.CancellationException if it is cancelled before the render is planned: the checkpoint is as it was
     */
    public static EngineJob start(
            Scene scene, RenderSettings settings, Path checkpoint, Consumer<String> log, BooleanSupplier cancelled)
            throws IOException {
        if (checkpoint != null && settings.budget().seconds().isPresent()) {
            throw new IllegalArgumentException("a render with a checkpoint must not depend on the time that it takes");
        }
        DividedRender render = DividedRender.prepareOnce(scene, settings, FilmRoom.MEMORY, cancelled);
        render.notes().forEach(log);
        FilmAssembly film = render.assembly();
        ServerJob job = ServerJob.of(render, film, JobContent.of(scene, render.outline(), Build.number()), log);
        if (checkpoint != null) {
            job.open(checkpoint);
        }
        return new EngineJob(job, film);
    }

    /** The input of {@link #makers} on any machine: first the job's hash and the canary's, then contents. */
    public List<byte[]> contents() {
        List<byte[]> all = new ArrayList<>(List.of(job.hash().toBytes(), canary.toBytes()));
        job.content().hashes().forEach(hash -> all.add(job.content().content(hash)));
        return all;
    }

    /**
     * Makers of this render's tiles, from the {@link #contents} of a job on another machine. They read no files.
     *
     * @return gives each thread its own maker, which makes of a tile's number the bytes for {@link #put}: the same on every
     *     machine, however often and in whatever order; an {@link IndexOutOfBoundsException} if there is no such tile
     * @throws IOException if the contents are not those that were sent, are of another version, or this machine computes
     *     other bits than the one that sent them
     */
    public static Supplier<IntFunction<byte[]>> makers(List<byte[]> contents) throws IOException {
        Map<ContentHash, byte[]> byHash = new LinkedHashMap<>();
        contents.subList(2, contents.size()).forEach(bytes -> byHash.put(ContentHash.of(bytes), bytes));
        byte[] document = byHash.get(ContentHash.fromBytes(contents.get(0)));
        if (document == null) {
            throw new IOException("the job has changed on its way");
        }
        if (!Arrays.equals(Canary.hash().toBytes(), contents.get(1))) {
            throw new IOException("this machine computes other bits than the one that the job comes from");
        }
        Map<String, byte[]> byName = new LinkedHashMap<>();
        byHash.forEach((hash, bytes) -> byName.put(hash.toString(), bytes));
        JobContent.Document read = JobContent.read(document, new SceneReader.NamedFiles(byName), Build.number(), 1);
        try {
            DividedRender render = DividedRender.planned(
                    read.scene(), read.settings(), read.plan(), (Path file) -> byName.get(file.toString()));
            return () -> render.maker()::make;
        } catch (IllegalArgumentException | SceneException e) {
            throw new IOException("the job cannot be used: " + e.getMessage(), e);
        }
    }

    /** The tiles that are not there yet, in ascending order. */
    public int[] missing() {
        return IntStream.range(0, job.tiles()).filter(tile -> !film.has(tile)).toArray();
    }

    /** The greatest number of bytes that the result of a unit can have. */
    public int longest(int unit) {
        return film.longest(unit);
    }

    /**
     * Puts a tile into picture and checkpoint; nothing if it is there already.
     *
     * @throws IllegalArgumentException if these bytes cannot be that tile
     */
    public synchronized void put(int tile, byte[] bytes, String machine) {
        film.problem(tile, bytes).ifPresent(reason -> {
            throw new IllegalArgumentException("tile " + tile + " of " + machine + ": " + reason);
        });
        if (!film.has(tile)) {
            Origin origin = Origin.Peer.of(machine.getBytes(StandardCharsets.UTF_8));
            job.keep(new Action.Keep(tile, origin, job.result(tile, bytes)));
        }
    }

    /** Lets the checkpoint reach the disk; to be called a few times a second while the engine works. */
    public synchronized void tick() {
        job.tick();
    }

    /** Reports the pixels done to a listener. */
    public void show(RenderProgress progress) {
        progress.progress(film.pixelsDone(), film.pixels(), film::image);
    }

    /** The picture so far, with its report. */
    public RenderResult result() {
        return Results.of(film.result());
    }

    @Override
    public synchronized void close() throws IOException {
        job.close();
    }
}
