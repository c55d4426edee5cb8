package enlightenment.view;

import enlightenment.image.Image;
import enlightenment.render.RenderResult;
import enlightenment.view.frame.Frame;
import enlightenment.view.frame.Kept;
import java.util.Map;
import java.util.Set;

/** What pages look at beside the picture: layers, and the picture that later ones are compared with. Guarded by the session that holds it. */
final class Looks {
    private final LayerWishes wishes;

    /** Each kind as it was rendered last. */
    private Layers layers = Layers.NONE;

    /** Null if none is kept. */
    private Kept kept;

    private long keptSoFar;

    /** @param wishes none yet */
    Looks(LayerWishes wishes) {
        this.wishes = wishes;
    }

    /** A page looks at a layer now. */
    void wish(Layer layer) {
        wishes.add(layer);
    }

    /** Ends all wishes: pages that still look ask again. */
    void clearWishes() {
        wishes.clear();
    }

    /** Which layers pages look at that are not there at full resolution, of a view as it is now. */
    Set<RenderResult.Auxiliary> missing(long generation) {
        return layers.missing(generation, wishes.current());
    }

    /** Layers that were rendered. */
    void add(Map<RenderResult.Auxiliary, Layers.Numbers> next) {
        layers = layers.with(next);
    }

    Layers layers() {
        return layers;
    }

    /**
     * Keeps a picture in place of the one before.
     *
     * @param shown the picture of the frame, as it is shown
     */
    void keep(Frame frame, Image shown) {
        kept = Kept.of(++keptSoFar, frame, shown);
    }

    /** Forgets the picture that was kept. */
    void forget() {
        kept = null;
    }

    /** The picture that others are compared with; null if there is none. */
    Kept kept() {
        return kept;
    }
}
