package enlightenment.net.server;

import enlightenment.checkpoint.Origin;
import enlightenment.device.share.DeviceShare;
import enlightenment.engine.UnitSource;
import enlightenment.net.job.TileData;
import enlightenment.net.protocol.Message;
import enlightenment.net.schedule.Event;
import enlightenment.net.schedule.WorkerCore;
import enlightenment.net.worker.RenderPool;
import java.util.Set;
import java.util.function.Consumer;

/** The server's own threads as a worker among others. Its calls come under the server's lock, those of its threads without. */
public final class LocalWorker implements AutoCloseable {
    /** The number of its connection, which it does not have. */
    public static final long ID = 0;

    private final RenderPool pool;
    private final Consumer<Event> events;

    /**
     * A worker without work.
     *
     * @param device renders, too, with threads of its own; null for none
     * @param results makes what is delivered
     * @param events takes what it says, from any thread
     * @param failed hears of what went wrong in a thread, which has then ended
     */
    public LocalWorker(
            UnitSource units,
            int threads,
            DeviceShare device,
            TileData.Maker results,
            Consumer<Event> events,
            Consumer<Throwable> failed) {
        this.events = events;
        pool = new RenderPool(units, threads, device, Integer.MAX_VALUE / 2, results, failed);
    }

    public void start() {
        pool.start(this::deliver);
        events.accept(new Event.Joined(ID, null, Origin.SERVER, false, "this process", pool.threads(), 1));
    }

    private void deliver() {
        for (WorkerCore.Outgoing tile : pool.outgoing()) {
            events.accept(new Event.Delivered(ID, tile.lease(), tile.tile(), tile.data()));
        }
    }

    /** Sends a heartbeat. */
    public void beat() {
        events.accept(new Event.Heard(ID, Set.copyOf(pool.leases())));
    }

    public void hear(Message message) {
        if (message instanceof Message.Grant m) {
            pool.granted(m.lease(), m.first(), m.last());
        } else if (message instanceof Message.Cancel m) {
            pool.cancelled(m.lease());
        } else if (message instanceof Message.Skip m) {
            pool.skipped(m.lease(), m.first(), m.last());
        } else if (message instanceof Message.Acknowledge m) {
            pool.acknowledged(m.tile());
        }
    }

    @Override
    public void close() {
        pool.close();
    }
}
