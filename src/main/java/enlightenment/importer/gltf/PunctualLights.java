package enlightenment.importer.gltf;

import enlightenment.color.Rgb;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.ImportDraft;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import java.io.IOException;

/** The lights of KHR_lights_punctual. Candela and lux are taken for our numbers of intensity and irradiance. */
final class PunctualLights {
    static final String EXTENSION = "KHR_lights_punctual";

    private final GltfElement document;
    private final ImportDraft draft;

    PunctualLights(GltfElement document, ImportDraft draft) {
        this.document = document;
        this.draft = draft;
    }

    /** Adds the light of a node, if it has one. */
    void add(GltfElement node, Affine toScene) throws IOException {
        GltfElement reference = node.extension(EXTENSION);
        if (!reference.isPresent()) {
            return;
        }
        GltfElement all = document.extension(EXTENSION);
        int index =
                reference.index("light", all.size("lights")).orElseThrow(() -> reference.failure("lacks \"light\""));
        GltfElement light = all.item("lights", index);
        double[] color = light.numbers("color", 1, 1, 1);
        double intensity = light.number("intensity", 1);
        try {
            Rgb value = new Rgb(color[0] * intensity, color[1] * intensity, color[2] * intensity);
            if (!value.equals(Rgb.BLACK)) {
                add(light, value, toScene);
            }
        } catch (InvalidValueException e) {
            throw light.failure(e.getMessage());
        }
    }

    private void add(GltfElement light, Rgb value, Affine toScene) throws IOException {
        String type = light.text("type", "");
        switch (type) {
            case "point" ->
                draft.light(new Light.Point(Affine.exact(toScene.offset()), Rgb.WHITE, Emission.intensity(value)));
            case "spot" -> draft.light(spot(light.get("spot"), value, toScene));
            case "directional" -> draft.light(new Light.Distant(toScene.vector(new Vec3(0, 0, -1)), value));
            default -> throw light.failure("must have the type point, spot or directional");
        }
    }

    /** It shines along -z. */
    private static Light spot(GltfElement cone, Rgb value, Affine toScene) throws IOException {
        double outer = cone.number("outerConeAngle", StrictMath.PI / 4);
        double inner = cone.number("innerConeAngle", 0);
        if (!(inner >= 0 && inner <= outer && outer > 0 && outer <= StrictMath.PI / 2)) {
            throw cone.failure("must have 0 <= innerConeAngle <= outerConeAngle <= pi / 2");
        }
        double angle = StrictMath.toDegrees(outer);
        return new Light.Spot(
                Affine.exact(toScene.offset()),
                toScene.vector(new Vec3(0, 0, -1)),
                angle,
                Math.min(StrictMath.toDegrees(inner), angle),
                Rgb.WHITE,
                Emission.intensity(value));
    }
}
