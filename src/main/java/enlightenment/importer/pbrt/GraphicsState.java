package enlightenment.importer.pbrt;

import enlightenment.importer.support.Affine;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** What directives change for those after them; kept and restored by AttributeBegin and AttributeEnd. */
final class GraphicsState {
    /** The current transformation matrix: to the world, or to the camera before WorldBegin. */
    Affine ctm = Affine.IDENTITY;

    boolean isReversed;

    /** Whether transformations concern the first key, which is the one that counts. */
    boolean isFirstKeyActive = true;

    MaterialSource material;

    /** Of the area lights that shapes are; null if they are none. */
    Parameters areaLight;

    ColorSpace areaLightSpace = ColorSpace.SRGB;
    String insideMedium = "";
    String outsideMedium = "";
    ColorSpace space = ColorSpace.SRGB;

    /** By target, such as {@code shape}: parameters that directives have unless they say otherwise. */
    private final Map<String, List<Parameter>> defaults = new HashMap<>();

    GraphicsState(Place start) {
        material = new MaterialSource("diffuse", "", new Parameters(start), ColorSpace.SRGB);
    }

    private GraphicsState(GraphicsState other) {
        ctm = other.ctm;
        isReversed = other.isReversed;
        isFirstKeyActive = other.isFirstKeyActive;
        material = other.material;
        areaLight = other.areaLight;
        areaLightSpace = other.areaLightSpace;
        insideMedium = other.insideMedium;
        outsideMedium = other.outsideMedium;
        space = other.space;
        other.defaults.forEach((target, list) -> defaults.put(target, new ArrayList<>(list)));
    }

    GraphicsState copy() {
        return new GraphicsState(this);
    }

    void addDefaults(String target, Parameters parameters) {
        List<Parameter> list = defaults.computeIfAbsent(target, t -> new ArrayList<>());
        for (Parameter p : parameters.all()) {
            list.removeIf(q -> q.name().equals(p.name()));
            list.add(p);
        }
    }

    /** The parameters with the defaults of a target. */
    Parameters with(String target, Parameters parameters) {
        parameters.addDefaults(defaults.getOrDefault(target, List.of()));
        return parameters;
    }
}
