package enlightenment.view;

import enlightenment.image.Image;
import enlightenment.render.Auxiliary;
import enlightenment.scene.Scene;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * What the rays of a view meet, as raw numbers of each pixel.
 *
 * @param generation of the {@link Shot} that they show
 * @param scene of it
 * @param shrink the side of the squares of pixels that each number stands for
 * @param images as large as a picture of that resolution
 */
record Layers(long generation, Scene scene, int shrink, Map<Auxiliary, Image> images) {
    Layers {
        images = Map.copyOf(images);
    }

    /** Which of some wishes are not there at full resolution. */
    Set<Auxiliary> missing(long ofGeneration, Set<Auxiliary> wishes) {
        EnumSet<Auxiliary> all = EnumSet.noneOf(Auxiliary.class);
        all.addAll(wishes);
        if (generation == ofGeneration && shrink == 1) {
            all.removeAll(images.keySet());
        }
        return all;
    }

    /** These layers and others; where they are of another view or resolution, only the others. */
    static Layers merged(Layers before, Layers next) {
        if (before == null || before.generation != next.generation || before.shrink != next.shrink) {
            return next;
        }
        Map<Auxiliary, Image> all = new EnumMap<>(Auxiliary.class);
        all.putAll(before.images);
        all.putAll(next.images);
        return new Layers(next.generation, next.scene, next.shrink, all);
    }

    Optional<Image> image(Auxiliary kind) {
        return Optional.ofNullable(images.get(kind));
    }
}
