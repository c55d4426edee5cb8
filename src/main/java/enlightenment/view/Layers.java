package enlightenment.view;

import enlightenment.image.Image;
import enlightenment.render.RenderResult;
import enlightenment.scene.Scene;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * What rays of a view meet, each kind as it was rendered last: it may be of a view before.
 *
 * @param all by what they are
 */
record Layers(Map<RenderResult.Auxiliary, Numbers> all) {
    static final Layers NONE = new Layers(Map.of());

    Layers {
        all = Map.copyOf(all);
    }

    /**
     * Raw numbers of each pixel.
     *
     * @param generation of the {@link Shot} that they show
     * @param scene of it
     * @param shrink the side of the squares of pixels that each number stands for
     * @param image as large as a picture of that resolution
     */
    record Numbers(long generation, Scene scene, int shrink, Image image) {}

    /** Which of some wishes are not there at full resolution, of a view as it is now. */
    Set<RenderResult.Auxiliary> missing(long generation, Set<RenderResult.Auxiliary> wishes) {
        EnumSet<RenderResult.Auxiliary> missing = EnumSet.noneOf(RenderResult.Auxiliary.class);
        for (RenderResult.Auxiliary wish : wishes) {
            Numbers there = all.get(wish);
            if (there == null || there.generation != generation || there.shrink != 1) {
                missing.add(wish);
            }
        }
        return missing;
    }

    /** These layers, but for those that were rendered anew. */
    Layers with(Map<RenderResult.Auxiliary, Numbers> next) {
        Map<RenderResult.Auxiliary, Numbers> merged = new EnumMap<>(RenderResult.Auxiliary.class);
        merged.putAll(all);
        merged.putAll(next);
        return new Layers(merged);
    }

    Optional<Numbers> of(RenderResult.Auxiliary kind) {
        return Optional.ofNullable(all.get(kind));
    }
}
