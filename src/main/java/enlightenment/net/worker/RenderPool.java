package enlightenment.net.worker;

import enlightenment.device.share.DeviceShare;
import enlightenment.engine.UnitMaker;
import enlightenment.engine.UnitSource;
import enlightenment.net.job.TileData;
import enlightenment.net.protocol.Limits;
import enlightenment.net.schedule.WorkerCore;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** Threads that render what a {@link WorkerCore} says. All waits end by themselves when the pool is closed. */
public final class RenderPool implements AutoCloseable {
    private static final long WAIT_MILLIS = 500;

    private final TileData.Maker results;
    private final WorkerCore core;
    private final Consumer<Throwable> failed;
    private final List<Thread> threads = new ArrayList<>();
    private Runnable flush = () -> {};
    private volatile boolean closed;
    private long made;

    /**
     * A pool that waits for work.
     *
     * @param device takes part with threads of its own; null for none
     * @param window largest number of tiles that are sent and not acknowledged
     * @param results makes what is delivered
     * @param failed receives what went wrong in a thread, which has then ended
     */
    public RenderPool(
            UnitSource units,
            int threads,
            DeviceShare device,
            int window,
            TileData.Maker results,
            Consumer<Throwable> failed) {
        this.results = results;
        this.failed = failed;
        int ofDevice = device == null ? 0 : DeviceShare.THREADS;
        core = new WorkerCore(threads + ofDevice, window, Long.MAX_VALUE);
        add(threads, "tiles-", () -> units.maker(() -> closed));
        add(ofDevice, "device-", () -> units.maker(device, () -> closed));
    }

    private void add(int count, String name, Supplier<UnitMaker> makers) {
        for (int i = 0; i < count; i++) {
            Thread thread = new Thread(() -> work(makers), name + i);
            thread.setDaemon(true);
            threads.add(thread);
        }
    }

    /** The number of its threads, those of a device included. */
    public int threads() {
        return threads.size();
    }

    /**
     * Starts the threads.
     *
     * @param whenFinished called whenever a tile is finished, by the thread that made it, without locks
     */
    public void start(Runnable whenFinished) {
        flush = whenFinished;
        threads.forEach(Thread::start);
    }

    private void work(Supplier<UnitMaker> makers) {
        try (UnitMaker maker = makers.get()) {
            for (WorkerCore.Task task = next(); task != null; task = next()) {
                TileData data = results.of(task.tile(), checked(maker.make(task.tile())));
                finished(task, data);
                flush.run();
            }
        } catch (CancellationException e) {
            // The tile is not needed any more.
            return;
        } catch (RuntimeException | Error e) {
            failed.accept(e);
        }
    }

    private static byte[] checked(byte[] result) {
        if (result.length > Limits.RESULT) {
            throw new IllegalStateException("a unit of work has a result of " + result.length + " bytes; at most "
                    + Limits.RESULT + " can be sent");
        }
        return result;
    }

    private synchronized WorkerCore.Task next() {
        while (!closed) {
            Optional<WorkerCore.Task> task = core.begin();
            if (task.isPresent()) {
                return task.get();
            }
            try {
                wait(WAIT_MILLIS);
            } catch (InterruptedException e) {
                return null;
            }
        }
        return null;
    }

    private synchronized void finished(WorkerCore.Task task, TileData data) {
        core.finished(task, data);
        made++;
    }

    /** The tiles to send now. */
    public synchronized List<WorkerCore.Outgoing> outgoing() {
        return core.outgoing(System.nanoTime());
    }

    public synchronized void granted(long lease, int first, int last) {
        core.granted(lease, first, last);
        notifyAll();
    }

    public synchronized void cancelled(long lease) {
        core.cancelled(lease);
    }

    public synchronized void skipped(long lease, int first, int last) {
        core.skipped(lease, first, last);
    }

    /** The server has the tile; false if it is none that the pool has sent. */
    public synchronized boolean acknowledged(int tile) {
        boolean wasOurs = core.acknowledged(tile);
        notifyAll();
        return wasOurs;
    }

    synchronized void disconnected() {
        core.disconnected();
    }

    public synchronized List<Long> leases() {
        return core.leases();
    }

    /** Number of tiles made. */
    synchronized long made() {
        return made;
    }

    /** Ends the threads, soon and in the middle of the tiles that they have in hand. */
    @Override
    public synchronized void close() {
        closed = true;
        notifyAll();
    }
}
