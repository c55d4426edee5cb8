package enlightenment.view;

import enlightenment.image.Image;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.view.frame.PassPlan;
import java.util.EnumSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The first hit of the ray through the middle of a pixel.
 *
 * @param object name, number and type of the object or light in words; empty where the ray hits nothing
 * @param material the material's name, or its type; empty for a light
 * @param depth distance from the eye in scene units; infinite where the ray hits nothing
 * @param point the hit in scene units, as the nearest floats
 * @param normal unit normal, on the viewer's side
 */
record PixelProbe(Optional<String> object, Optional<String> material, double depth, Vec3 point, Vec3 normal) {
    private static final Set<RenderResult.Auxiliary> WANTED = EnumSet.of(
            RenderResult.Auxiliary.DEPTH,
            RenderResult.Auxiliary.POSITION,
            RenderResult.Auxiliary.NORMAL,
            RenderResult.Auxiliary.OBJECT);

    /**
     * Traces the ray of a pixel.
     *
     * @param shot the view
     * @param preparation prepares the shot's scene
     * @param x column in 0..width − 1
     * @param y row in 0..height − 1
     * @throws enlightenment.scene.SceneException if the scene cannot be rendered
     */
    static PixelProbe of(Shot shot, ScenePreparation preparation, int x, int y) {
        RenderSettings settings = shot.settings(new PassPlan(1, 0, 1, 0), 1).toBuilder()
                .crop(new RenderSettings.Crop(x, y, 1, 1))
                .build();
        RenderResult result = shot.film()
                .render(preparation.request(shot, settings, () -> false).withAuxiliary(WANTED));
        Map<RenderResult.Auxiliary, Image> found = result.auxiliary();
        int index = (int) found.get(RenderResult.Auxiliary.OBJECT).component(0, 0, 0);
        return new PixelProbe(
                object(shot.scene(), index),
                material(shot.scene(), index),
                found.get(RenderResult.Auxiliary.DEPTH).component(0, 0, 0),
                vector(found.get(RenderResult.Auxiliary.POSITION)),
                vector(found.get(RenderResult.Auxiliary.NORMAL)));
    }

    private static Vec3 vector(Image image) {
        return new Vec3(image.component(0, 0, 0), image.component(0, 0, 1), image.component(0, 0, 2));
    }

    /** An object or light in words, by its number in {@link RenderResult.Auxiliary#OBJECT}; empty if the number is neither. */
    static Optional<String> object(Scene scene, int index) {
        int objects = scene.objects().size();
        if (index < 0 || index >= objects + scene.lights().size()) {
            return Optional.empty();
        }
        if (index >= objects) {
            int light = index - objects;
            return Optional.of(
                    "light " + light + " (" + scene.lights().get(light).type() + ")");
        }
        SceneObject object = scene.objects().get(index);
        String kind = "object " + index + " (" + object.shape().type() + ")";
        return Optional.of(object.name().isEmpty() ? kind : object.name() + ", " + kind);
    }

    private static Optional<String> material(Scene scene, int index) {
        if (index < 0 || index >= scene.objects().size()) {
            return Optional.empty();
        }
        SceneObject object = scene.objects().get(index);
        if (!object.faces().isEmpty()) {
            return Optional.of("one for each face");
        }
        String type = object.material().type();
        return Optional.of(scene.materials().entrySet().stream()
                .filter(named -> named.getValue().equals(object.material()))
                .findFirst()
                .map(named -> named.getKey() + " (" + type + ")")
                .orElse(type));
    }

    /** Whether the ray has a hit. */
    boolean isHit() {
        return object.isPresent();
    }

    /** The hit in exact decimals, equal to {@link #point()}. */
    ExactPoint exactPoint() {
        return ExactPoint.of(point.x(), point.y(), point.z());
    }
}
