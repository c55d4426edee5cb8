package enlightenment.net;

import java.util.Set;

/** The server's own threads as a worker among others. Its calls come under the server's lock, those of its threads without. */
final class LocalWorker implements AutoCloseable {
    /** The number of its connection, which it does not have. */
    static final long ID = 0;

    private final RenderServer server;
    private final RenderPool pool;
    private final int threads;

    LocalWorker(RenderServer server, int threads) {
        this.server = server;
        this.threads = threads;
        pool = new RenderPool(server.job().render(), threads, Integer.MAX_VALUE / 2, server::failed);
    }

    void start() {
        pool.start(this::deliver);
        server.handle(new Event.Joined(ID, null, Origin.SERVER, false, "this process", threads, 1));
    }

    private void deliver() {
        for (WorkerCore.Outgoing tile : pool.outgoing()) {
            server.handle(new Event.Delivered(ID, tile.lease(), tile.tile(), tile.data()));
        }
    }

    /** Says that it lives. */
    void beat() {
        server.handle(new Event.Heard(ID, Set.copyOf(pool.leases())));
    }

    void hear(Message message) {
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
