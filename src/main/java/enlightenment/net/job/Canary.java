package enlightenment.net.job;

import enlightenment.engine.DividedRender;
import enlightenment.engine.UnitMaker;
import enlightenment.file.ContentHash;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RayTraceSettings;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.security.MessageDigest;

/**
 * A small picture that every machine computes before it joins: who gets other bits here would spoil pictures. It has glass,
 * a mirror, a checkerboard, a torus (cubic and quartic equations), soft shadows and all methods of this program.
 */
public final class Canary {
    private static final String SCENE =
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

    /** What a client says that makes tiles without computing: nobody knows whether its pixels are the right ones. */
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
        Scene scene = SceneReader.readString(SCENE, Path.of(""), "canary");
        MessageDigest digest = ContentHash.sha256();
        for (Method method : BuiltInMethod.rendering(scene.shading().model())) {
            RenderSettings settings = RenderSettings.of(scene)
                    .withMethod(method)
                    .withAntialias(1)
                    .with(new RayTraceSettings(2))
                    .withThreads(1);
            DividedRender render = DividedRender.prepare(scene, settings, () -> false);
            UnitMaker maker = render.maker();
            for (int tile = 0; tile < render.units(); tile++) {
                digest.update(maker.make(tile));
            }
        }
        return ContentHash.fromBytes(digest.digest());
    }
}
