package enlightenment.net.job;

import enlightenment.engine.DividedRender;
import enlightenment.engine.UnitMaker;
import enlightenment.file.ContentHash;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.List;

/**
 * Small pictures that every machine computes before it joins: who gets other bits here would spoil pictures. They have glass, mirrors, a
 * checkerboard, a torus (cubic and quartic equations), soft shadows, rough metal, a sky with a sun, fog and all methods of this program.
 */
public final class Canary {
    private static final String CLASSIC =
            """
            { "image": { "width": 24, "height": 16 },
              "camera": { "type": "perspective", "eye": [0, 1, -5], "lookAt": [0, 0, 0], "up": [0, 1, 0],
                          "fieldOfView": 50 },
              "textures": { "board": { "type": "checker", "colors": ["#ffffff", "#402010"], "scale": 12 } },
              "lights": [ { "type": "sphere", "center": [2, 4, -3], "radius": 0.7, "color": "#fff0e0" } ],
              "objects": [
                { "type": "sphere", "center": [-1, 0, 0], "radius": 0.9,
                  "material": { "type": "glass", "color": "#f0ffff", "indexOfRefraction": 1.5 } },
                { "type": "sphere", "center": [1.2, 0.1, 1], "radius": 1,
                  "material": { "type": "mirror", "color": "#e0e0e0" } },
                { "type": "torus", "center": [0, -0.6, -1], "axis": [0.2, 1, 0.1], "majorRadius": 0.7,
                  "minorRadius": 0.2, "material": { "type": "matte", "color": "#3060c0" } },
                { "type": "rectangle", "corners": [[-9, -1, -5], [-9, -1, 9], [9, -1, 9], [9, -1, -5]],
                  "material": { "type": "matte", "color": { "texture": "board" } } } ] }
            """;

    private static final String PHYSICAL =
            """
            { "image": { "width": 16, "height": 12 },
              "shading": { "model": "physical", "background": { "type": "sky", "elevation": 40, "radiance": 0.3 } },
              "camera": { "type": "perspective", "eye": [0, 1, -5], "lookAt": [0, 0, 0], "up": [0, 1, 0],
                          "fieldOfView": 50 },
              "lights": [ { "type": "sphere", "center": [2, 4, -3], "radius": 0.7, "color": "#fff0e0", "radiance": 9 } ],
              "objects": [
                { "type": "sphere", "center": [-1, 0, 0], "radius": 0.9,
                  "material": { "type": "glass", "color": "#f0ffff", "indexOfRefraction": 1.5, "absorption": [0.1, 0.3, 0.2] } },
                { "type": "sphere", "center": [1.2, 0.1, 1], "radius": 1,
                  "material": { "type": "glossy", "color": "#e0c080", "roughness": 0.4 } },
                { "type": "box", "min": [-0.4, -1, -2.4], "max": [0.6, -0.2, -1.4],
                  "material": { "type": "scattering", "color": "#e0d0b0", "meanFreePath": 0.3 } },
                { "type": "rectangle", "corners": [[-9, -1, -5], [-9, -1, 9], [9, -1, 9], [9, -1, -5]],
                  "material": { "type": "matte", "color": "#8090a0", "roughness": 0.5 } } ] }
            """;

    /** On each side of a square of camera rays in a pixel: enough for all methods to do what they do in large pictures. */
    private static final int RAYS = 3;

    /** Stands in a worker's greeting for a canary that it did not compute: its arithmetic is unproven. */
    public static final ContentHash NOT_COMPUTED = new ContentHash(0, 0, 0, 0);

    private static ContentHash hash;

    private Canary() {}

    /** The hash of the canary as this machine computes it; computed once. */
    public static synchronized ContentHash hash() {
        if (hash == null) {
            hash = compute();
        }
        return hash;
    }

    private static ContentHash compute() {
        MessageDigest digest = ContentHash.sha256();
        for (DividedRender render : renders()) {
            UnitMaker maker = render.maker();
            for (int unit = 0; unit < render.units(); unit++) {
                digest.update(maker.make(unit));
            }
        }
        return ContentHash.fromBytes(digest.digest());
    }

    /** Each scene by each method of its shading. */
    static List<DividedRender> renders() {
        List<DividedRender> all = new ArrayList<>();
        for (String text : List.of(CLASSIC, PHYSICAL)) {
            Scene scene = SceneReader.readString(text, Path.of(""), "canary");
            for (Method method : BuiltInMethod.rendering(scene.shading().model())) {
                RenderSettings settings = RenderSettings.of(scene)
                        .withMethod(method)
                        .withAntialias(RAYS)
                        .with(new BuiltInMethod.RayTraceSettings(2))
                        .withThreads(1);
                all.add(DividedRender.prepare(scene, settings, () -> false));
            }
        }
        return all;
    }
}
