package enlightenment.view;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayCurve;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;

/** What a view shows of its pixels beside their colours, over HTTP and against closed forms. */
@Timeout(60)
class LookTest {
    private static final String SCENE =
            """
            {
              "image": { "width": 24, "height": 16 },
              "camera": { "type": "perspective", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "up": [0, 1, 0],
                          "fieldOfView": 40 },
              "shading": { "model": "physical" },
              "materials": { "red": { "type": "matte", "color": "#bc0000" } },
              "lights": [ { "type": "sphere", "center": [2, 3, -2], "radius": 0.5, "color": "#ffffff", "power": 100 } ],
              "objects": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "red", "name": "ball" } ]
            }
            """;

    private static final int WIDTH = 24;
    private static final int SAMPLES = 4;

    /** Across and along, of the ray through the middle of the pixel in column 12 of 24 and row 8 of 16. */
    private static final double SLOPE = Math.tan(Math.toRadians(20)) / 16;

    private static final double LENGTH = Math.sqrt(1 + 2 * SLOPE * SLOPE);

    /** How far along the line of sight that ray meets the unit ball five units ahead: the smaller root of t²(1 + 2s²) − 10t + 24. */
    private static final double AHEAD = (5 - Math.sqrt(25 - 24 * LENGTH * LENGTH)) / (LENGTH * LENGTH);

    private static final String MIDDLE = "x=0.52&y=0.52";
    private static final String CORNER = "x=0.01&y=0.99";

    @TempDir
    private Path folder;

    private ServedView client;

    @BeforeEach
    void start() throws Exception {
        begin(SCENE);
    }

    private void begin(String scene) throws Exception {
        client = new ServedView(Files.writeString(folder.resolve("scene.json"), scene), SAMPLES);
        client.act("action=size&x=24&y=16");
        client.await("", s -> s.get("finished").asBoolean() && s.get("width").asInt() == WIDTH);
    }

    @AfterEach
    void end() throws Exception {
        client.close();
    }

    private JsonNode value(Layer layer, String place) throws Exception {
        return client.json("value.json", "layer=" + layer.word() + "&" + place);
    }

    private int[] rgb(Layer layer) throws Exception {
        return client.rgb("layer.png", "layer=" + layer.word());
    }

    private static int middle(int[] rgb) {
        return rgb[8 * WIDTH + 12] & 0xffffff;
    }

    @Test
    void theDepthIsTheDistanceFromTheEye() throws Exception {
        JsonNode layer = client.awaitLayer(Layer.DEPTH);
        double depth = value(Layer.DEPTH, MIDDLE).get("values").get(0).asDouble();
        assertEquals(AHEAD * LENGTH, depth, 1e-5);
        assertEquals(0, value(Layer.DEPTH, CORNER).get("values").size());
        assertEquals(2, layer.get("marks").size());
        assertTrue(layer.get("marks").get(0).asDouble() <= depth);
        assertEquals(
                0xffffff,
                Arrays.stream(rgb(Layer.DEPTH)).map(c -> c & 0xffffff).max().getAsInt(),
                "the nearest is white");
        assertEquals(0, rgb(Layer.DEPTH)[0] & 0xffffff);
    }

    @Test
    void theNormalOfAPlaneIsTheSameEverywhereOnIt() throws Exception {
        client.close();
        begin(SCENE.replace(
                "{ \"type\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 1,",
                "{ \"type\": \"triangle\", \"vertices\": [[-9, -9, 0], [9, -9, 0], [0, 9, 0]],"));
        client.awaitLayer(Layer.NORMAL);
        int[] rgb = rgb(Layer.NORMAL);
        // 0.5 + 0.5 n for n = (0, 0, −1), halves upwards.
        assertEquals(0x808000, middle(rgb));
        assertEquals(0x808000, rgb[0] & 0xffffff);
        JsonNode normal = value(Layer.NORMAL, CORNER).get("values");
        assertEquals(0, normal.get(0).asDouble(), 1e-9);
        assertEquals(-1, normal.get(2).asDouble());
        client.awaitLayer(Layer.DEPTH);
        assertEquals(5 * LENGTH, value(Layer.DEPTH, MIDDLE).get("values").get(0).asDouble(), 1e-5);
    }

    @Test
    void objectsAndMaterialsHaveColoursAndNames() throws Exception {
        JsonNode objects = client.awaitLayer(Layer.OBJECT);
        assertEquals(
                "ball, object 0 (sphere)",
                value(Layer.OBJECT, MIDDLE).get("name").asString());
        assertEquals("nothing", value(Layer.OBJECT, CORNER).get("name").asString());
        JsonNode entry = objects.get("legend").get(0);
        assertEquals("ball, object 0 (sphere)", entry.get("name").asString());
        assertEquals(
                String.format("#%06x", middle(rgb(Layer.OBJECT))),
                entry.get("color").asString());
        // The ball's outline is a circle of this radius in heights of the picture, tangents of the eye being seen.
        double radius = 1 / Math.sqrt(24) / (2 * Math.tan(Math.toRadians(20)));
        assertEquals(Math.PI * radius * radius / 1.5, entry.get("share").asDouble(), 0.02);
        JsonNode materials = client.awaitLayer(Layer.MATERIAL);
        assertEquals("red (matte)", materials.get("legend").get(0).get("name").asString());
        assertEquals("red (matte)", value(Layer.MATERIAL, MIDDLE).get("name").asString());
    }

    @Test
    void theAlbedoIsTheMaterialsColour() throws Exception {
        client.awaitLayer(Layer.ALBEDO);
        assertEquals(0xbc0000, middle(rgb(Layer.ALBEDO)));
        assertEquals(0, value(Layer.ALBEDO, MIDDLE).get("values").get(1).asDouble());
    }

    @Test
    void samplesAreThoseOfAllPasses() throws Exception {
        assertEquals(SAMPLES, value(Layer.SAMPLES, MIDDLE).get("values").get(0).asDouble());
        JsonNode pixel = client.json("pixel.json", MIDDLE);
        assertEquals(SAMPLES, pixel.get("samples").asDouble());
        assertTrue(pixel.get("error").get(0).asDouble() > 0);
        assertEquals(0, pixel.get("error").get(1).asDouble(), "red reflects no green");
        JsonNode nothing = client.json("pixel.json", CORNER);
        assertEquals(0, nothing.get("error").get(0).asDouble());
    }

    @Test
    void theErrorOfTheLayerIsTheLastOfTheCurve() throws Exception {
        JsonNode layer = client.awaitLayer(Layer.ERROR);
        assertEquals(0, value(Layer.ERROR, CORNER).get("values").get(0).asDouble());
        assertTrue(value(Layer.ERROR, MIDDLE).get("values").get(0).asDouble() > 0);
        JsonNode points = client.json("convergence.json", "").get("points");
        // Passes of 1, 1 and 2 samples, or of 1 on a slow machine; the error is known from the second on.
        int last = points.size() - 1;
        assertTrue(last == 1 || last == 2, points::toString);
        assertEquals(2, points.get(0).get("samples").asInt());
        assertEquals(SAMPLES, points.get(last).get("samples").asInt());
        assertTrue(points.get(0).get("seconds").asDouble() > 0);
        assertTrue(points.get(0).get("seconds").asDouble()
                < points.get(1).get("seconds").asDouble());
        assertEquals(layer.get("rmse").asDouble(), points.get(last).get("error").asDouble());
    }

    /** Errors are those of what is shown: after a change of the exposure the old ones are not comparable. */
    @Test
    void theCurveIsThatOfTheExposure() throws Exception {
        JsonNode all = client.json("convergence.json", "").get("points");
        double before = all.get(all.size() - 1).get("error").asDouble();
        client.act("action=exposure&x=-6");
        JsonNode points = client.json("convergence.json", "").get("points");
        assertEquals(1, points.size());
        assertEquals(SAMPLES, points.get(0).get("samples").asInt());
        assertTrue(points.get(0).get("error").asDouble() < before);
        assertTrue(points.get(0).get("error").asDouble() > 0);
    }

    @Test
    void aPictureThatIsKeptDoesNotChange() throws Exception {
        int[] before = client.rgb("picture.png", "");
        assertEquals(404, client.get("kept.png", "").code());
        client.act("action=keep");
        JsonNode state = client.json("state.json", "");
        assertEquals(1, state.get("kept").asInt());
        assertEquals(SAMPLES, state.get("keptSamples").asInt());
        JsonNode same = client.awaitLayer(Layer.DIFFERENCE);
        assertEquals(0, same.get("rmse").asDouble());
        client.act("action=exposure&x=2");
        assertArrayEquals(before, client.rgb("kept.png", ""));
        assertFalse(Arrays.equals(before, client.rgb("picture.png", "")));
        client.act("action=forget");
        assertEquals(404, client.get("kept.png", "").code());
        assertEquals(404, client.get("layer.png", "layer=difference").code());
    }

    /** Of a ball that reflects red only, one component in three differs, by what the display curve makes of two exposures. */
    @Test
    void aDifferenceIsThatOfWhatIsShown() throws Exception {
        double red = client.json("pixel.json", MIDDLE).get("value").get(0).asDouble();
        client.act("action=keep");
        client.act("action=exposure&x=-1");
        JsonNode layer = client.awaitLayer(Layer.DIFFERENCE);
        double off =
                DisplayCurve.SRGB.of(red) - DisplayCurve.SRGB.withExposure(-1).of(red);
        assertEquals(
                off / Math.sqrt(3),
                value(Layer.DIFFERENCE, MIDDLE).get("values").get(0).asDouble(),
                1e-5);
        assertEquals(0, value(Layer.DIFFERENCE, CORNER).get("values").get(0).asDouble());
        assertTrue(layer.get("rmse").asDouble() > 0);
        assertTrue(layer.get("noise").asDouble() > 0);
    }

    @Test
    void picturesOfTwoSizesAreNotCompared() throws Exception {
        client.act("action=keep");
        client.act("action=size&x=48&y=32");
        JsonNode state = client.await(
                "", s -> s.get("finished").asBoolean() && s.get("width").asInt() == 48);
        assertFalse(ServedView.has(state, Layer.DIFFERENCE));
        assertEquals(404, client.get("layer.json", "layer=difference").code());
    }

    @Test
    void layersFollowTheCamera() throws Exception {
        client.awaitLayer(Layer.DEPTH);
        int[] before = rgb(Layer.DEPTH);
        client.act("action=dolly&x=2");
        client.awaitFinished();
        double depth = 0;
        Deadline deadline = new Deadline();
        // Now and then, as a page does: what is there is that of before until it is rendered.
        while (Math.abs(depth - 9) > 0.1) {
            deadline.check(() -> "of the view before");
            client.awaitLayer(Layer.DEPTH);
            depth = value(Layer.DEPTH, MIDDLE).get("values").get(0).asDouble();
        }
        assertFalse(Arrays.equals(before, rgb(Layer.DEPTH)));
    }

    /** Somebody else looks at normals: both are there, and stay. */
    @Test
    void twoPagesMayLookAtTwoLayers() throws Exception {
        client.awaitLayer(Layer.DEPTH);
        client.awaitLayer(Layer.NORMAL);
        JsonNode state = client.json("state.json", "layer=depth");
        assertTrue(ServedView.has(state, Layer.DEPTH) && ServedView.has(state, Layer.NORMAL));
        assertEquals(
                WIDTH, client.json("layer.json", "layer=depth").get("width").asInt());
        // Nothing is rendered any more: the next news is none.
        long picture = state.get("picture").asLong();
        assertEquals(
                picture,
                client.json(
                                "state.json",
                                "layer=depth&after=" + state.get("version").asLong())
                        .get("picture")
                        .asLong());
    }

    @Test
    void everyLayerIsAnotherPicture() throws Exception {
        client.act("action=keep");
        client.act("action=exposure&x=1");
        Set<Integer> pictures = new HashSet<>();
        for (Layer layer : Layer.values()) {
            if (layer != Layer.PICTURE) {
                client.awaitLayer(layer);
                int[] rgb = rgb(layer);
                assertEquals(WIDTH * 16, rgb.length);
                pictures.add(Arrays.hashCode(rgb));
            }
        }
        // One object of one material: these two are alike.
        assertEquals(Layer.values().length - 2, pictures.size());
    }

    @Test
    void thePictureWithoutGrainIsNearerToThatOfManySamples() throws Exception {
        client.awaitLayer(Layer.DENOISED);
        assertEquals(3, value(Layer.DENOISED, MIDDLE).get("values").size());
        assertEquals(0, value(Layer.DENOISED, CORNER).get("values").get(2).asDouble());
        view(Path.of("scenes/cornell-box.json"), 256);
        int[] many = client.rgb("picture.png", "");
        view(Path.of("scenes/cornell-box.json"), 8);
        client.awaitLayer(Layer.DENOISED);
        double noisy = squares(client.rgb("picture.png", ""), many);
        double denoised = squares(rgb(Layer.DENOISED), many);
        assertTrue(denoised < noisy / 2, denoised + " of " + noisy);
    }

    private void view(Path scene, int samples) throws Exception {
        client.close();
        client = new ServedView(scene, samples);
        client.act("action=size&x=64&y=64");
        client.await("", s -> s.get("finished").asBoolean() && s.get("width").asInt() == 64);
    }

    private static double squares(int[] a, int[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            double off = (a[i] >> 16 & 0xff) - (b[i] >> 16 & 0xff);
            sum += off * off;
        }
        return sum;
    }

    @Test
    void classicShadingHasNoAlbedo() throws Exception {
        client.close();
        begin(SCENE.replace("\"shading\": { \"model\": \"physical\" },", "").replace(", \"power\": 100", ""));
        assertEquals(404, client.get("layer.png", "layer=albedo").code());
        assertEquals(404, client.get("layer.png", "layer=denoised").code());
        assertNotEquals(0, client.awaitLayer(Layer.NORMAL).get("width").asInt());
    }

    @Test
    void strangersAndWrongNamesAreRefused() throws Exception {
        for (String path : new String[] {"layer.png", "layer.json", "value.json", "kept.png", "convergence.json"}) {
            assertEquals(403, client.send("GET", path, "layer=depth").code());
            assertEquals(405, client.send("POST", path, "layer=depth").code());
        }
        assertEquals(400, client.get("layer.png", "layer=secrets").code());
        assertEquals(400, client.get("layer.json", "").code());
        assertEquals(400, client.get("state.json", "layer=secrets").code());
        assertEquals(400, client.get("value.json", "layer=samples&x=2&y=0").code());
        for (String path : new String[] {"look.css", "layers.js", "compare.js", "convergence.js"}) {
            assertEquals(200, client.send("GET", path, "").code());
        }
    }
}
