package enlightenment.render;

import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The scene whose picture must not depend on where and how large it is: a floor, a box on it, a mirror ball on the box,
 * a glass ball, a cylinder, a tilted cone, a tilted ring and a small ball, under a ball of light. It is a text in which
 * {@code @(x, y, z)} marks positions and {@code ~r} lengths, so that it can be written in other coordinates.
 *
 * <p>And a second one, {@link #TIES}, in which nearly every visible place lies on several surfaces at once.
 *
 * @param camera what it is seen by
 * @param content the text, in which the camera is missing
 */
record ReferenceScene(String camera, String content) {
    /** Numbers that no grid of the scene contains. */
    static final String GENERIC = "\"type\": \"perspective\", \"eye\": @(0.3137, 2.7183, -6.4142),"
            + " \"lookAt\": @(0.1129, 1.0471, 3.9173), \"up\": [0, 1, 0], \"fieldOfView\": 38.7";

    /** Round numbers, the paper's kind of camera. */
    static final String ON_GRID = "\"type\": \"window\", \"eye\": @(0, 2, -6), \"lowerLeft\": @(-3, -0.5, -1),"
            + " \"upperLeft\": @(-3, 4, -1), \"upperRight\": @(3, 4, -1), \"lowerRight\": @(3, -0.5, -1)";

    static final String ORTHOGRAPHIC = "\"type\": \"orthographic\", \"eye\": @(0.1, 4.3, -6),"
            + " \"lookAt\": @(0.2, 1.1, 3), \"up\": [0, 1, 0], \"height\": ~7.7";

    static final String ISOMETRIC = "\"type\": \"isometric\", \"lookAt\": @(0.3, 1, 3.1), \"height\": ~8.9";

    private static final String APART =
            """
            {
              "name": "Reference",
              "image": { "width": 64, "height": 48 },
              "camera": { CAMERA },
              "shading": { "model": "classic", "ambient": 0.3, "shadow": 0.2, "background": "#8fa9c4" },
              "textures": {
                "tiles": { "type": "checker", "colors": ["#e8e4da", "#7a8a96"], "scale": 11 }
              },
              "materials": {
                "floor": { "type": "matte", "color": { "texture": "tiles" } },
                "box": { "type": "matte", "color": "#4d8b57" },
                "mirror": { "type": "mirror", "color": "#e8eef4" },
                "glass": { "type": "glass", "color": "#eaf6ff", "indexOfRefraction": 1.5 },
                "cylinder": { "type": "matte", "color": "#3b6ea8" },
                "cone": { "type": "matte", "color": "#c8402f" },
                "ring": { "type": "matte", "color": "#e0aa3e" },
                "small": { "type": "matte", "color": "#ffffff" }
              },
              "lights": [ { "type": "sphere", "center": @(-2.7, 7.3, -1.1), "radius": ~0.6, "color": "#ffffff" } ],
              "objects": [
                { "type": "rectangle", "material": "floor",
                  "corners": [@(-6, 0, -2), @(-6, 0, 10), @(6, 0, 10), @(6, 0, -2)] },
                { "type": "box", "min": @(-1.3, 0, 3.1), "max": @(0.9, 1.4, 5.3), "material": "box" },
                { "type": "sphere", "center": @(-0.2, 2.1, 4.2), "radius": ~0.7, "material": "mirror" },
                { "type": "sphere", "center": @(2.3, 0.9, 2.2), "radius": ~0.9, "material": "glass" },
                { "type": "cylinder", "base": @(-3.1, 0, 4.6), "top": @(-3.1, 2.2, 4.6), "radius": ~0.6,
                  "material": "cylinder" },
                { "type": "cone", "base": @(-2.6, 0.3, 1.7), "apex": @(-2.1, 1.9, 2.3), "radius": ~0.5,
                  "material": "cone" },
                { "type": "torus", "center": @(3.4, 1.1, 5.7), "axis": [0.3, 1, -0.4], "majorRadius": ~0.9,
                  "minorRadius": ~0.3, "material": "ring" },
                { "type": "sphere", "center": @(0.55, 0.05, 1.45), "radius": ~0.05, "material": "small" }
              ],
              "render": { "antialias": 2, "shadowSamples": 3, "seed": 5 }
            }
            """;

    private static final String TIES =
            """
            {
              "name": "Ties",
              "image": { "width": 64, "height": 48 },
              "camera": { CAMERA },
              "shading": { "model": "classic", "ambient": 0.3, "shadow": 0.2, "background": "#8fa9c4" },
              "textures": {
                "tiles": { "type": "checker", "colors": ["#e8e4da", "#7a8a96"], "scale": 11 }
              },
              "materials": {
                "floor": { "type": "matte", "color": { "texture": "tiles" } },
                "box": { "type": "matte", "color": "#4d8b57" },
                "mirror": { "type": "mirror", "color": "#e8eef4" },
                "glass": { "type": "glass", "color": "#eaf6ff", "indexOfRefraction": 1.5 },
                "water": { "type": "glass", "color": "#d0f0ff", "indexOfRefraction": 1.33 },
                "red": { "type": "matte", "color": "#c8402f" },
                "blue": { "type": "matte", "color": "#3b6ea8" },
                "gold": { "type": "matte", "color": "#e0aa3e" }
              },
              "lights": [
                { "type": "rectangle", "color": "#ffffff",
                  "corners": [@(-1.2, 4.7, 1.1), @(-1.2, 4.7, 2.3), @(0.4, 4.7, 2.3), @(0.4, 4.7, 1.1)] },
                { "type": "point", "position": @(-3.9, 2.9, 6.3), "color": "#aa9988" },
                { "type": "sphere", "center": @(3.1, 3.3, 0.9), "radius": ~0.3, "color": "#ffffff" }
              ],
              "objects": [
                { "type": "rectangle", "material": "floor",
                  "corners": [@(-6, 0, -2), @(-6, 0, 10), @(6, 0, 10), @(6, 0, -2)] },
                { "type": "rectangle", "material": "box",
                  "corners": [@(-6, 4.7, -2), @(-6, 4.7, 10), @(6, 4.7, 10), @(6, 4.7, -2)] },
                { "type": "rectangle", "material": "blue",
                  "corners": [@(-6, 0, 7.3), @(-6, 4.7, 7.3), @(6, 4.7, 7.3), @(6, 0, 7.3)] },
                { "type": "rectangle", "material": "mirror",
                  "corners": [@(-3.3, 1.7, 7.3), @(-3.3, 4.1, 7.3), @(1.1, 4.1, 7.3), @(1.1, 1.7, 7.3)] },
                { "type": "rectangle", "material": "red",
                  "corners": [@(-1.9, 0, 0.7), @(-1.9, 0, 3.9), @(1.7, 0, 3.9), @(1.7, 0, 0.7)] },
                { "type": "box", "min": @(-1.3, 0, 3.1), "max": @(0.9, 1.4, 5.3), "material": "box" },
                { "type": "box", "min": @(-0.3, 0, 2.7), "max": @(0.5, 1.4, 6.1), "material": "gold" },
                { "type": "disk", "center": @(-0.8, 0.7, 3.1), "normal": [0, 0, -1], "radius": ~0.4, "material": "red" },
                { "type": "disk", "center": @(0.1, 1.4, 4.4), "normal": [0, 1, 0], "radius": ~0.7, "material": "mirror" },
                { "type": "sphere", "center": @(2.3, 0.9, 2.2), "radius": ~0.9, "material": "red" },
                { "type": "sphere", "center": @(2.3, 0.9, 2.2), "radius": ~0.9, "rotation": 71, "material": "gold" },
                { "type": "sphere", "center": @(3.1, 3.3, 0.9), "radius": ~0.3, "material": "blue" },
                { "type": "cylinder", "base": @(-3.1, 0.3, 4.6), "top": @(-2.8, 2.2, 4.3), "radius": ~0.6,
                  "material": "blue" },
                { "type": "cylinder", "base": @(-2.8, 2.2, 4.3), "top": @(-3.1, 0.3, 4.6), "radius": ~0.6,
                  "material": "gold" },
                { "type": "cylinder", "base": @(-2.95, 1.25, 4.45), "top": @(-2.8, 2.2, 4.3), "radius": ~0.6,
                  "capped": false, "material": "mirror" },
                { "type": "cone", "base": @(-2.6, 0.3, 1.7), "apex": @(-2.1, 1.9, 2.3), "radius": ~0.5,
                  "material": "gold" },
                { "type": "cone", "base": @(-2.6, 0.3, 1.7), "apex": @(-2.1, 1.9, 2.3), "radius": ~0.5,
                  "capped": false, "material": "blue" },
                { "type": "torus", "center": @(3.4, 1.1, 5.7), "axis": [0.3, 1, -0.4], "majorRadius": ~0.9,
                  "minorRadius": ~0.3, "material": "gold" },
                { "type": "torus", "center": @(3.4, 1.1, 5.7), "axis": [-0.3, -1, 0.4], "majorRadius": ~0.9,
                  "minorRadius": ~0.3, "material": "blue" },
                { "type": "box", "min": @(-4.4, 0, 0.3), "max": @(-3.2, 0.8, 1.5), "material": "glass" },
                { "type": "box", "min": @(-4.4, 0, 0.3), "max": @(-3.2, 0.5, 1.5), "material": "water" },
                { "type": "box", "min": @(-4.3, 2.4, 6.3), "max": @(-3.5, 3.4, 7.3), "material": "red" }
              ],
              "render": { "antialias": 2, "shadowSamples": 3, "seed": 5 }
            }
            """;

    private static final String NUMBER = "(-?[0-9.]+)";
    private static final Pattern POSITION = Pattern.compile("@\\(" + NUMBER + ", " + NUMBER + ", " + NUMBER + "\\)");
    private static final Pattern LENGTH = Pattern.compile("~" + NUMBER);

    /** Both scenes as they are seen by these cameras. */
    static List<ReferenceScene> seenBy(String... cameras) {
        return Stream.of(APART, TIES)
                .flatMap(content -> Stream.of(cameras).map(camera -> new ReferenceScene(camera, content)))
                .toList();
    }

    /** Both scenes as they are seen by all cameras. */
    static List<ReferenceScene> all() {
        return seenBy(GENERIC, ON_GRID, ORTHOGRAPHIC, ISOMETRIC);
    }

    /** The scene as it is. */
    Scene scene() {
        return read(text(v -> v, v -> v));
    }

    /** The scene 10^k times as large, by its text. */
    Scene scaled(int k) {
        return read(text(v -> v.scaleByPowerOfTen(k), v -> v.scaleByPowerOfTen(k)));
    }

    /** The scene with t added to every coordinate in its text. */
    Scene translated(BigDecimal t) {
        return read(text(v -> v.add(t), v -> v));
    }

    /** What the protocol says of pixels whose rays lie on edges. */
    boolean isOnGrid() {
        return !camera.equals(GENERIC);
    }

    @Override
    public String toString() {
        return (content.equals(TIES) ? "ties" : "reference") + " with { " + camera + " }";
    }

    private static Scene read(String text) {
        return SceneReader.readString(text, Path.of("."), "reference");
    }

    private String text(UnaryOperator<BigDecimal> coordinate, UnaryOperator<BigDecimal> length) {
        String all = content.replace("CAMERA", camera);
        String placed = POSITION.matcher(all)
                .replaceAll(m -> "[" + number(m.group(1), coordinate) + ", " + number(m.group(2), coordinate) + ", "
                        + number(m.group(3), coordinate) + "]");
        Matcher lengths = LENGTH.matcher(placed);
        return lengths.replaceAll(m -> number(m.group(1), length));
    }

    private static String number(String decimal, UnaryOperator<BigDecimal> f) {
        return f.apply(new BigDecimal(decimal)).toString();
    }
}
