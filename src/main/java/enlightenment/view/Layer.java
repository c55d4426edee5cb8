package enlightenment.view;

import enlightenment.render.RenderResult;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** The layers of a view that a page can show. */
enum Layer {
    /** The picture itself. */
    PICTURE,

    /** Reflectance of the first surface that is neither mirror nor glass; physical shading only. */
    ALBEDO(RenderResult.Auxiliary.ALBEDO),

    /** Unit normal of the first surface, on the viewer's side. */
    NORMAL(RenderResult.Auxiliary.NORMAL),

    /** Distance from the eye along the ray, in scene units. */
    DEPTH(RenderResult.Auxiliary.DEPTH),

    /** Objects and lights in false colours. */
    OBJECT(RenderResult.Auxiliary.OBJECT),

    /** Materials in false colours. */
    MATERIAL(RenderResult.Auxiliary.OBJECT),

    /** Standard error of the displayed colour, estimated from the spread of the passes. */
    ERROR,

    /** Number of samples. */
    SAMPLES,

    /** Root mean square of the components' displayed difference from the picture that was kept. */
    DIFFERENCE,

    /** The picture without grain; physical shading only. */
    DENOISED(RenderResult.Auxiliary.ALBEDO, RenderResult.Auxiliary.NORMAL, RenderResult.Auxiliary.POSITION);

    private final List<RenderResult.Auxiliary> sources;

    Layer(RenderResult.Auxiliary... sources) {
        this.sources = List.of(sources);
    }

    /** The auxiliary images that the layer is made from; empty where the picture and its passes suffice. */
    List<RenderResult.Auxiliary> sources() {
        return sources;
    }

    /** The name of the layer in lower case, as in requests. */
    String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Whether the layer is defined for a scene. */
    boolean isOf(Scene scene) {
        return this != ALBEDO && this != DENOISED || scene.shading() instanceof Shading.Physical;
    }

    /** The number of components of a pixel that tell it: 1 where all are equal. */
    int components() {
        return this == ALBEDO || this == NORMAL || this == DENOISED ? 3 : 1;
    }

    /** @throws BadParameter if no layer has this name */
    static Layer of(String word) {
        return Arrays.stream(values())
                .filter(layer -> layer.word().equals(word))
                .findFirst()
                .orElseThrow(() -> new BadParameter("layer must be one of "
                        + Arrays.stream(values()).map(Layer::word).collect(Collectors.joining(", "))));
    }
}
