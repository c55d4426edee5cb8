package enlightenment.net;

import enlightenment.engine.TiledRender;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import java.io.IOException;
import java.util.function.BooleanSupplier;

/**
 * The servers that follow a first one, each with more samples than the one before, until the picture is as exact as was asked. To
 * workers each looks like the one before, started anew: they come again.
 */
final class FollowingServers {
    private static final long PAUSE_MILLIS = 200;

    /** How often a server tries to listen where the one before did. */
    private static final int TRIES = 50;

    private final RenderServer first;
    private RenderServer latest;
    private boolean isStopped;

    FollowingServers(RenderServer first) {
        this.first = first;
    }

    /** Renders with one server after the other; returns the last picture that became whole, or what there is of the first. */
    RenderResult await(RenderProgress progress, BooleanSupplier cancelled) throws IOException {
        RenderResult best = first.awaitOne(progress, cancelled);
        RenderServer next = after(first, best, cancelled);
        while (next != null) {
            try {
                RenderResult result = next.awaitOne(progress, cancelled);
                best = result.complete() ? result : best;
                next = after(next, result, cancelled);
            } catch (IOException e) {
                // There is a picture already.
                first.options().log.accept(e.getMessage());
                next = null;
            }
        }
        return best;
    }

    /** Ends a server; returns the one that goes on, or null if there is no more to do. */
    private RenderServer after(RenderServer server, RenderResult result, BooleanSupplier cancelled) {
        TiledRender more = cancelled.getAsBoolean() || isStopped()
                ? null
                : server.job().render().next(result, server.options().log).orElse(null);
        if (more == null) {
            server.end(false);
            return null;
        }
        ServerOptions options = server.options().following(server.port(), server.statusPort(), more.round());
        server.end(true);
        return begun(server, options, more);
    }

    private RenderServer begun(RenderServer before, ServerOptions options, TiledRender more) {
        for (int k = 1; !isStopped(); k++) {
            try {
                return put(RenderServer.follow(before, options, more));
            } catch (IOException e) {
                // The thread that listened here may need a moment to let go of the port.
                if (k == TRIES || !Connections.sleep(PAUSE_MILLIS)) {
                    options.log.accept("the picture cannot be rendered again with more samples: " + e.getMessage());
                    return null;
                }
            }
        }
        return null;
    }

    private RenderServer put(RenderServer server) {
        synchronized (this) {
            latest = server;
        }
        if (isStopped()) {
            server.close();
        }
        return server;
    }

    private synchronized boolean isStopped() {
        return isStopped;
    }

    /** Ends the latest server, and no other will follow. */
    void stop() {
        RenderServer server;
        synchronized (this) {
            isStopped = true;
            server = latest;
        }
        if (server != null) {
            server.close();
        }
    }
}
