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
    private static final String EXTENSION = "KHR_lights_punctual";

    private final GltfElement document;
    private final ImportDraft draft;

    PunctualLights(GltfElement document, ImportDraft draft) {
        this.document = document;
        this.draft = draft;
    }

    /** Whether a node has a light. */
    static boolean isOn(GltfElement node) throws IOException {
        return node.extension(EXTENSION).isPresent();
    }

    /** Adds the light of a node at these poses, unless it is black, and makes its tracks. */
    void add(GltfElement node, NodePoses poses, NodeTracks tracks) throws IOException {
        GltfElement reference = node.extension(EXTENSION);
        GltfElement all = document.extension(EXTENSION);
        int index =
                reference.index("light", all.size("lights")).orElseThrow(() -> reference.failure("lacks \"light\""));
        GltfElement element = all.item("lights", index);
        double[] color = element.numbers("color", 1, 1, 1);
        double intensity = element.number("intensity", 1);
        try {
            Rgb value = new Rgb(color[0] * intensity, color[1] * intensity, color[2] * intensity);
            if (!value.isBlack()) {
                draft.light(light(element, value, poses.start()));
                // Fail here rather than in the midst of the film.
                for (Affine pose : poses.maps()) {
                    light(element, value, pose);
                }
                move(draft.lights().size() - 1, poses, tracks);
            }
        } catch (InvalidValueException e) {
            throw element.failure(e.getMessage());
        }
    }

    private void move(int number, NodePoses poses, NodeTracks tracks) throws IOException {
        String target = "/lights/" + number;
        Light light = draft.lights().get(number);
        if (!(light instanceof Light.Distant)) {
            tracks.carry(target + "/position", poses, Affine::offset);
        }
        if (!(light instanceof Light.Point)) {
            tracks.carry(target + "/direction", poses, PunctualLights::axis);
        }
    }

    private static Light light(GltfElement light, Rgb value, Affine pose) throws IOException {
        String type = light.text("type", "");
        return switch (type) {
            case "point" -> new Light.Point(Affine.exact(pose.offset()), Rgb.WHITE, Emission.intensity(value));
            case "spot" -> spot(light.get("spot"), value, pose);
            case "directional" -> new Light.Distant(axis(pose), value);
            default -> throw light.failure("must have the type point, spot or directional");
        };
    }

    /** Lights shine along -z. */
    private static Vec3 axis(Affine pose) {
        return pose.vector(new Vec3(0, 0, -1));
    }

    private static Light spot(GltfElement cone, Rgb value, Affine pose) throws IOException {
        double outer = cone.number("outerConeAngle", StrictMath.PI / 4);
        double inner = cone.number("innerConeAngle", 0);
        if (!(inner >= 0 && inner <= outer && outer > 0 && outer <= StrictMath.PI / 2)) {
            throw cone.failure("must have 0 <= innerConeAngle <= outerConeAngle <= pi / 2");
        }
        double angle = StrictMath.toDegrees(outer);
        return new Light.Spot(
                Affine.exact(pose.offset()),
                axis(pose),
                angle,
                Math.min(StrictMath.toDegrees(inner), angle),
                Rgb.WHITE,
                Emission.intensity(value));
    }
}
