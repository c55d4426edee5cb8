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
 * The auxiliary images of a view, each as it was rendered last, which may be of an earlier generation. Immutable.
 *
 * @param all the images, by kind
 */
record Layers(Map<RenderResult.Auxiliary, Numbers> all) {
    static final Layers NONE = new Layers(Map.of());

    Layers {
        all = Map.copyOf(all);
    }

    /**
     * An auxiliary image with raw values.
     *
     * @param generation the generation of the {@link Shot} that the image shows
     * @param scene the scene of that shot
     * @param shrink side in pixels of the block that each pixel of the image stands for
     * @param image the values, at that resolution
     */
    record Numbers(long generation, Scene scene, int shrink, Image image) {}

    /** The requested images that are missing at full resolution for a generation. */
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

    /** A copy of these layers in which images of the same kind are replaced. */
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
