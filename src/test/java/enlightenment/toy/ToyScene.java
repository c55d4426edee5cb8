package enlightenment.toy;

import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;

/** White balls, one of them behind another and all behind a black pole; nothing has a shadow. */
public final class ToyScene {
    public static final String TEXT =
            """
            { "image": { "width": 40, "height": 24 },
              "camera": { "type": "perspective", "eye": [0.3, 1, -6], "lookAt": [0, 0.2, 0], "up": [0.1, 1, 0], "fieldOfView": 40 },
              "shading": { "model": "classic", "ambient": 1 },
              "render": { "antialias": 16 },
              "lights": [ { "type": "point", "position": [0, 9, 0], "color": "#ffffff" } ],
              "objects": [
                { "type": "sphere", "center": [-0.8, 0, 0.5], "radius": 1, "material": { "type": "matte", "color": "#ffffff" } },
                { "type": "sphere", "center": [0.7, 0.3, -1], "radius": 0.6, "material": { "type": "matte", "color": "#ffffff" } },
                { "type": "sphere", "center": [1.4, 1.4, 3], "radius": 0.5, "material": { "type": "matte", "color": "#ffffff" } },
                { "type": "cylinder", "base": [-1, -3, -1.5], "top": [-0.6, 3, -1.5], "radius": 0.1,
                  "material": { "type": "matte", "color": "#000000" } } ] }
            """;

    private ToyScene() {}

    public static Scene scene() {
        return SceneReader.readString(TEXT, Path.of(""), "");
    }
}
