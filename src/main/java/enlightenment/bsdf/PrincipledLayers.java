package enlightenment.bsdf;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Caches the layers of {@link PrincipledReflection} with their tables: surfaces whose two roughnesses come from textures are many
 * combinations of few layers. For one thread.
 */
public final class PrincipledLayers {
    private final Map<List<Double>, DielectricLayer> layers = new HashMap<>();
    private final Map<Double, AlbedoTable> mirrors = new HashMap<>();

    /** The table of sheen; null until a surface has sheen. */
    private SheenAlbedo sheen;

    /** Makes an empty cache. */
    public PrincipledLayers() {}

    /** The layer with these parameters of {@link DielectricLayer}. */
    DielectricLayer layer(double share, double alpha, double index) {
        return layers.computeIfAbsent(List.of(share, alpha, index), key -> new DielectricLayer(share, alpha, index));
    }

    /** The sheen with these parameters of {@link SheenLayer}. */
    SheenLayer sheen(double share, double tint) {
        if (share > 0 && sheen == null) {
            sheen = new SheenAlbedo();
        }
        return new SheenLayer(share, tint, sheen);
    }

    /** The energy loss of single reflection at facets that reflect all light. */
    AlbedoTable mirrors(Microfacets facets) {
        return mirrors.computeIfAbsent(facets.alpha, key -> new AlbedoTable(new VisibleNormals.OfMirrors(facets)));
    }
}
