package enlightenment.net.worker;

import enlightenment.device.share.DeviceShare;
import enlightenment.engine.UnitSource;
import enlightenment.file.ContentHash;
import enlightenment.net.job.TileData;
import enlightenment.net.protocol.Limits;
import enlightenment.net.protocol.Message;
import java.io.IOException;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What a worker knows beyond its connections: contents by their hashes, in memory only, and the job that it works at. */
public final class WorkerJobs implements AutoCloseable {
    private final int threads;
    private final String version;
    private final Tamper tamper;

    /** Null for none. */
    private final DeviceShare device;

    private final Map<ContentHash, byte[]> contents = new HashMap<>();
    private ContentHash job;
    private RenderPool pool;
    private long madeBefore;
    private Throwable failure;

    /** What a machine makes of a tile that it has rendered: the same, but for faulty machines in tests. */
    @FunctionalInterface
    public interface Tamper {
        byte[] change(int tile, byte[] bytes);
    }

    /**
     * No job yet.
     *
     * @param threads number of tiles that are rendered at once by the processor
     * @param device renders others; null for none
     * @param version of this program: only jobs of the same are taken
     * @param tamper what becomes of each tile before it is sent
     */
    public WorkerJobs(int threads, DeviceShare device, String version, Tamper tamper) {
        this.threads = threads;
        this.device = device;
        this.version = version;
        this.tamper = tamper;
    }

    /** Whether the content is here. */
    synchronized boolean has(ContentHash hash) {
        return contents.containsKey(hash);
    }

    /** Lets go of all contents but these; returns how many bytes of them are here. */
    synchronized long retain(List<ContentHash> hashes) {
        contents.keySet().retainAll(hashes);
        return contents.values().stream().mapToLong(content -> content.length).sum();
    }

    /** Keeps a content. */
    synchronized void keep(ContentHash hash, byte[] content) {
        contents.put(hash, content);
    }

    /** The pool that works at this job, whose contents are all here; a new one if it is another job than before. */
    RenderPool pool(Message.Job wanted, Runnable whenFinished) throws IOException {
        synchronized (this) {
            if (wanted.job().equals(job) && failure == null) {
                return pool;
            }
        }
        UnitSource units = units(wanted);
        synchronized (this) {
            end();
            job = wanted.job();
            contents.keySet().retainAll(wanted.contents());
            pool = new RenderPool(
                    units,
                    threads,
                    device,
                    Limits.UNACKNOWLEDGED_TILES,
                    (tile, bytes) -> TileData.plain(tamper.change(tile, bytes)),
                    this::failed);
            pool.start(whenFinished);
            return pool;
        }
    }

    private UnitSource units(Message.Job wanted) throws IOException {
        Map<ContentHash, byte[]> images = new LinkedHashMap<>();
        byte[] document;
        synchronized (this) {
            document = contents.get(wanted.contents().get(0));
            wanted.contents().stream().skip(1).forEach(hash -> images.put(hash, contents.get(hash)));
        }
        return WorkerUnits.of(document, images, wanted.tiles(), version, threads);
    }

    private synchronized void failed(Throwable thrown) {
        failure = thrown;
    }

    /** What went wrong in a rendering thread, or null. */
    synchronized Throwable failure() {
        return failure;
    }

    /** Number of tiles made. */
    public synchronized long made() {
        return madeBefore + (pool == null ? 0 : pool.made());
    }

    private void end() {
        if (pool != null) {
            madeBefore += pool.made();
            pool.close();
        }
    }

    @Override
    public synchronized void close() {
        if (pool != null) {
            pool.close();
        }
        if (device != null) {
            device.note();
        }
    }
}
