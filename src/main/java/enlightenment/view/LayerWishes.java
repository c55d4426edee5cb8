package enlightenment.view;

import enlightenment.render.RenderResult;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;
import java.util.function.LongSupplier;

/** Requests of pages for layers, the only ones that are rendered. A request expires unless it is renewed. Thread-safe. */
final class LayerWishes {
    /** Lifetime of a request: longer than an open page waits for news before it renews its request. */
    static final long WISH_NANOS = 12_000_000_000L;

    private final LongSupplier clock;
    private final Map<RenderResult.Auxiliary, Long> since = new EnumMap<>(RenderResult.Auxiliary.class);

    /** @param clock nanoseconds of any origin */
    LayerWishes(LongSupplier clock) {
        this.clock = clock;
    }

    /** Requests a layer, or renews the request for it. */
    synchronized void add(Layer layer) {
        layer.sources().forEach(source -> since.put(source, clock.getAsLong()));
    }

    /** The auxiliary images of all requests that have not expired. */
    synchronized Set<RenderResult.Auxiliary> current() {
        long now = clock.getAsLong();
        since.values().removeIf(then -> now - then > WISH_NANOS);
        return since.isEmpty() ? Set.of() : EnumSet.copyOf(since.keySet());
    }

    /** Withdraws all requests; open pages request their layers again. */
    synchronized void clear() {
        since.clear();
    }
}
