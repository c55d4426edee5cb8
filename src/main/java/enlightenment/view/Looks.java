package enlightenment.view;

import enlightenment.image.Image;
import enlightenment.render.RenderResult;
import enlightenment.view.frame.Frame;
import enlightenment.view.frame.Kept;
import java.util.Map;
import java.util.Set;

/** Layers of a view, and the kept picture that later ones are compared with. Guarded by the session that owns it. */
final class Looks {
    private final LayerWishes wishes;

    /** The auxiliary images, each as it was rendered last. */
    private Layers layers = Layers.NONE;

    /** The kept picture, or null. */
    private Kept kept;

    private long keptSoFar;

    /** @param wishes without requests yet */
    Looks(LayerWishes wishes) {
        this.wishes = wishes;
    }

    /** Requests a layer that a page shows. */
    void wish(Layer layer) {
        wishes.add(layer);
    }

    /** Withdraws all requests; open pages request their layers again. */
    void clearWishes() {
        wishes.clear();
    }

    /** The requested images that are missing at full resolution for a generation. */
    Set<RenderResult.Auxiliary> missing(long generation) {
        return layers.missing(generation, wishes.current());
    }

    /** Adds rendered images, in place of earlier ones of the same kind. */
    void add(Map<RenderResult.Auxiliary, Layers.Numbers> next) {
        layers = layers.with(next);
    }

    Layers layers() {
        return layers;
    }

    /**
     * Keeps a picture in place of the one before.
     *
     * @param shown the image of the frame, with the exposure of the view
     */
    void keep(Frame frame, Image shown) {
        kept = Kept.of(++keptSoFar, frame, shown);
    }

    /** Discards the kept picture. */
    void forget() {
        kept = null;
    }

    /** The kept picture; null if there is none. */
    Kept kept() {
        return kept;
    }
}
