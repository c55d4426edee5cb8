package enlightenment.view;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.ImageFormat;
import enlightenment.listen.ServerLog;
import enlightenment.render.Renderer;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;

/** Final renders of a view, and the frames of an animation, over HTTP on loopback. */
@Timeout(60)
class FinalRenderTest {
    /** A ball that moves, with its shutter open, and a camera that does not. */
    private static final String SCENE =
            """
            {
              "image": { "width": 24, "height": 16 },
              "camera": { "type": "perspective", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "fieldOfView": 40 },
              "shading": { "model": "physical" },
              "lights": [ { "type": "sphere", "center": [2, 3, -2], "radius": 0.5, "color": "#ffffff", "power": 100 } ],
              "objects": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1, "name": "ball",
                             "material": { "type": "matte", "color": "#ffffff" } } ],
              "animation": { "frames": 3, "framesPerSecond": 8, "shutter": 0.5, "instants": 2,
                             "tracks": [ { "target": "/objects/0/center/0", "keys": { "0": 0, "2": 2 } } ] }
            }
            """;

    @TempDir
    private Path folder;

    private Path file;
    private LiveView view;
    private ViewClient client;

    @BeforeEach
    void start() throws Exception {
        file = Files.writeString(folder.resolve("scene.json"), SCENE);
        view = LiveView.start(
                new FileSource(file),
                FileSource.FILES,
                new LiveView.Options("scene.json", 0, 2, 2),
                new ServerLog(line -> {}, System::nanoTime));
        client = new ViewClient(view.address());
        client.act("action=size&x=24&y=16");
    }

    @AfterEach
    void end() throws Exception {
        view.close();
    }

    private void done(String query) throws Exception {
        ViewClient.Answer answer = client.act(query);
        assertEquals(200, answer.code(), answer.text());
    }

    private void refused(int code, String message, String query) throws Exception {
        ViewClient.Answer answer = client.act(query);
        assertEquals(message + "\n", answer.text());
        assertEquals(code, answer.code());
    }

    private static byte[] expected(Scene scene, RenderSettings settings, ImageFormat format) throws Exception {
        return FileSource.bytes(Renderer.render(scene, settings), format);
    }

    @Test
    void filesAreThoseOfAnOrdinaryRender() throws Exception {
        assertEquals(404, client.get("render.png", "").code());
        done("action=render&width=30&height=20&samples=3");
        JsonNode status = client.awaitRender("done");
        assertEquals(30, status.get("width").asInt());
        assertEquals(1, status.get("done").asDouble());
        Scene scene = SceneReader.read(file);
        RenderSettings settings =
                RenderSettings.of(scene).withSize(30, 20).withBudget(RenderSettings.Budget.NONE.withSamples(3));
        for (ImageFormat format : BackgroundRender.FORMATS) {
            String name = "render." + format.extensions().get(0);
            assertArrayEquals(
                    expected(scene, settings, format), client.get(name, "").body());
        }
    }

    @Test
    void whatIsRenderedIsWhatIsSeen() throws Exception {
        done("action=frame&x=2");
        done("action=dolly&x=1.5");
        done("action=exposure&x=-2");
        done("action=render&samples=2");
        client.awaitRender("done");
        // The same in a file: the frame's number aside, the camera and the exposure stand in it.
        Path seen = Files.writeString(
                folder.resolve("seen.json"),
                SCENE.replace("[0, 0, -5]", "[0, 0, -7.5]")
                        .replace("\"shading\"", "\"display\": { \"exposure\": -2 }, \"shading\""));
        Scene scene = SceneReader.read(seen, 2);
        assertEquals(2, scene.instants().size());
        RenderSettings settings = RenderSettings.of(scene).withBudget(RenderSettings.Budget.NONE.withSamples(2));
        assertArrayEquals(
                expected(scene, settings, ImageFormat.PNG),
                client.get("render.png", "").body());
    }

    @Test
    void oneRendersAtATimeUntilItIsCancelled() throws Exception {
        done("action=render&width=2000&height=2000&samples=1000000");
        client.awaitRender("running");
        refused(409, "\"render\" is under way: it can be cancelled", "action=render");
        assertEquals(404, client.get("render.png", "").code());
        // The view answers meanwhile.
        done("action=dolly&x=2");
        client.await("state.json", s -> s.get("current").asBoolean());
        done("action=cancel");
        client.awaitRender("cancelled");
        done("action=render&samples=1");
        client.awaitRender("done");
        assertEquals(200, client.get("render.exr", "").code());
    }

    @Test
    void theMethodIsOneThatRendersTheScene() throws Exception {
        JsonNode offered = client.await("render.json", s -> true).get("scene").get("methods");
        assertTrue(offered.toString().contains("\"bidirectional\""), offered.toString());
        done("action=render&method=bidirectional&samples=2");
        client.awaitRender("done");
        Scene scene = SceneReader.read(file);
        RenderSettings settings = RenderSettings.of(scene)
                .withMethod(Method.named("bidirectional"))
                .withBudget(RenderSettings.Budget.NONE.withSamples(2));
        assertArrayEquals(
                expected(scene, settings, ImageFormat.PNG),
                client.get("render.png", "").body());
        assertEquals(409, client.act("action=render&method=magic").code());
    }

    @Test
    void anErrorThatIsAskedForIsThatOfThePngFile() throws Exception {
        done("action=render&error=0.05");
        String notes = client.awaitRender("done").get("notes").toString();
        assertFalse(notes.contains("more than asked"), notes);
        Scene scene = SceneReader.read(file);
        RenderSettings.Budget budget =
                RenderSettings.Budget.NONE.withError(0.05).withDepth(8);
        assertArrayEquals(
                expected(scene, RenderSettings.of(scene).withBudget(budget), ImageFormat.PNG),
                client.get("render.png", "").body());
    }

    @Test
    void ordersOutOfRangeAreRefused() throws Exception {
        refused(400, "width must be a number in 1.0..65536.0", "action=render&width=0");
        refused(400, "samples must be a number in 1.0..1.6777216E7", "action=render&samples=many");
        refused(400, "error must be a number in 1.0E-7..1.0", "action=render&error=2");
        refused(
                400,
                "a picture of 60000x60000 pixels is larger than the 33554432 that a view renders: the command render makes"
                        + " larger ones",
                "action=render&width=60000&height=60000");
        assertEquals("none", client.await("render.json", s -> true).get("state").asString());
    }

    @Test
    void strangersNeitherStartRendersNorGetTheirFiles() throws Exception {
        assertEquals(403, client.send("POST", "do?action=render").code());
        assertEquals(403, client.send("POST", "do?key=0&action=cancel").code());
        for (String path : new String[] {"render.json", "render.png", "render.exr"}) {
            assertEquals(403, client.send("GET", path).code());
        }
        assertEquals(405, client.get("do", "action=render").code());
        assertEquals("none", client.await("render.json", s -> true).get("state").asString());
    }

    @Test
    void framesAreShownAndKeepTheCamera() throws Exception {
        JsonNode before = client.await("state.json", s -> s.get("finished").asBoolean());
        assertEquals(3, before.get("frames").asInt());
        assertEquals(8, before.get("framesPerSecond").asDouble());
        assertTrue(before.get("frame").isNull());
        assertEquals("ball, object 0 (sphere)", objectInTheMiddle());
        done("action=field-of-view&x=20");
        done("action=frame&x=2");
        JsonNode after = client.await("state.json", s -> s.get("finished").asBoolean());
        assertEquals(2, after.get("frame").asInt());
        assertEquals(20, after.get("fieldOfView").asDouble());
        // The ball is two units to the side now.
        assertEquals("nothing", objectInTheMiddle());
        refused(409, "\"frame\" must be in 0..2", "action=frame&x=3");
    }

    private String objectInTheMiddle() throws Exception {
        return new ObjectMapper()
                .readTree(client.get("pixel.json", "x=0.5&y=0.5").body())
                .get("object")
                .asString();
    }

    @Test
    void aFrameStaysWhenTheFileChanges() throws Exception {
        done("action=frame&x=2");
        Files.writeString(file, SCENE.replace("\"fieldOfView\": 40", "\"fieldOfView\": 41"));
        JsonNode state = client.await("state.json", s -> s.get("fieldOfView").asDouble() == 41);
        assertEquals(2, state.get("frame").asInt());
        // Without it there is no frame to be shown.
        Files.writeString(file, SCENE.replace("\"frames\": 3", "\"frames\": 2"));
        state = client.await("state.json", s -> s.get("frames").asInt() == 2);
        assertTrue(state.get("frame").isNull());
    }

    @Test
    void whatDoesNotMoveHasNoFrames() throws Exception {
        Files.writeString(file, SCENE.replaceFirst("(?s),\\s*\"animation\".*", "}"));
        client.await("state.json", s -> s.get("frames").asInt() == 0);
        refused(409, "\"frame\" is not there: nothing is animated", "action=frame&x=0");
    }
}
