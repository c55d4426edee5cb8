package enlightenment.view;

import enlightenment.render.RenderResult;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;
import java.util.function.LongSupplier;

/** What pages look at beside the picture: only that is rendered. A wish ends unless it is renewed. Safe for several threads. */
final class LayerWishes {
    /** Longer than a page waits for news, so that one that still looks has asked again. */
    static final long WISH_NANOS = 12_000_000_000L;

    private final LongSupplier clock;
    private final Map<RenderResult.Auxiliary, Long> since = new EnumMap<>(RenderResult.Auxiliary.class);

    /** @param clock nanoseconds of any origin */
    LayerWishes(LongSupplier clock) {
        this.clock = clock;
    }

    /** A page looks at a layer now. */
    synchronized void add(Layer layer) {
        layer.source().ifPresent(source -> since.put(source, clock.getAsLong()));
    }

    /** What renders should make beside the picture. */
    synchronized Set<RenderResult.Auxiliary> current() {
        long now = clock.getAsLong();
        since.values().removeIf(then -> now - then > WISH_NANOS);
        return since.isEmpty() ? Set.of() : EnumSet.copyOf(since.keySet());
    }

    /** Ends all wishes: pages that still look ask again. */
    synchronized void clear() {
        since.clear();
    }
}
