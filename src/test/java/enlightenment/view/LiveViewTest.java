package enlightenment.view;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.listen.ServerLog;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.SceneReader;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;

/** A view over HTTP on loopback, as a browser sees it. Nothing depends on how long anything takes. */
@Timeout(60)
class LiveViewTest {
    private static final String SCENE =
            """
            // Two balls.
            {
              "image": { "width": 24, "height": 16 },
              "camera": { "type": "perspective", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "up": [0, 1, 0],
                          "fieldOfView": 40 /* wide */ },
              "shading": { "model": "physical" },
              "materials": { "white": { "type": "matte", "color": "#ffffff" } },
              "lights": [ { "type": "sphere", "center": [2, 3, -2], "radius": 0.5, "color": "#ffffff", "power": 100 } ],
              "objects": [
                { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "white", "name": "ball" },
                { "type": "sphere", "center": [0, -101, 0], "radius": 100, "material": "white" }
              ]
            }
            """;

    private static final int SAMPLES = 4;

    /** The slope, across and along, of the ray through the middle of a pixel that touches the middle of a picture of 16 rows. */
    private static final double SLOPE = Math.tan(Math.toRadians(20)) / 16;

    /** How far along the line of sight that ray meets the unit ball five units ahead: the smaller root of t²(1 + 2s²) − 10t + 24. */
    private static final double DISTANCE = (5 - Math.sqrt(25 - 24 * (1 + 2 * SLOPE * SLOPE))) / (1 + 2 * SLOPE * SLOPE);

    @TempDir
    private Path folder;

    private Path file;
    private LiveView view;
    private String address;
    private String key;

    @BeforeEach
    void start() throws Exception {
        file = Files.writeString(folder.resolve("scene.json"), SCENE);
        begin(SAMPLES, true);
    }

    private void begin(int samples, boolean isNative) throws Exception {
        LiveView.Options options = new LiveView.Options("scene.json", 0, 2, samples);
        view = LiveView.start(
                new FileSource(file, isNative), FileSource.FILES, options, new ServerLog(line -> {}, System::nanoTime));
        String[] parts = view.address().split("#");
        address = parts[0];
        key = parts[1];
        done("action=size&x=24&y=16");
    }

    private void restart(int samples) throws Exception {
        view.close();
        begin(samples, true);
    }

    @AfterEach
    void end() throws Exception {
        view.close();
    }

    /** What came back, until the server closed the connection. */
    private record Answer(int statusCode, String head, byte[] body) {
        static Answer of(byte[] all) {
            String text = new String(all, StandardCharsets.ISO_8859_1);
            int end = text.indexOf("\r\n\r\n");
            int code = Integer.parseInt(text.substring(9, 12));
            return new Answer(code, text.substring(0, end + 2), Arrays.copyOfRange(all, end + 4, all.length));
        }

        String header(String name) {
            return head.lines()
                    .filter(line -> line.startsWith(name + ": "))
                    .findFirst()
                    .orElseThrow()
                    .substring(name.length() + 2);
        }
    }

    private Answer send(String method, String target) throws Exception {
        return send(method, target, "127.0.0.1");
    }

    private Answer send(String method, String target, String host) throws Exception {
        String request = method + " /" + target + " HTTP/1.1\r\nHost: " + host + "\r\nContent-Length: 0\r\n\r\n";
        try (Socket socket =
                new Socket(InetAddress.getLoopbackAddress(), URI.create(address).getPort())) {
            socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
            return Answer.of(socket.getInputStream().readAllBytes());
        }
    }

    private String withKey(String path, String query) {
        return path + "?key=" + key + "&" + query;
    }

    private Answer act(String query) throws Exception {
        return send("POST", withKey("do", query));
    }

    private void done(String query) throws Exception {
        Answer answer = act(query);
        assertEquals(200, answer.statusCode(), text(answer));
    }

    private void refused(int code, String message, String query) throws Exception {
        Answer answer = act(query);
        assertEquals(message + "\n", text(answer));
        assertEquals(code, answer.statusCode());
    }

    private static String text(Answer answer) {
        return new String(answer.body(), StandardCharsets.UTF_8);
    }

    private JsonNode state(long after) throws Exception {
        Answer answer = send("GET", withKey("state.json", "after=" + after));
        assertEquals(200, answer.statusCode());
        return new ObjectMapper().readTree(answer.body());
    }

    /** Waits, by the long poll of pages, until a state is as expected. */
    private JsonNode await(Predicate<JsonNode> expected) throws Exception {
        Deadline deadline = new Deadline();
        JsonNode state = state(0);
        while (!expected.test(state)) {
            deadline.check(state::toString);
            state = state(state.get("version").asLong());
        }
        return state;
    }

    private JsonNode awaitFinished() throws Exception {
        return await(s -> s.get("finished").asBoolean());
    }

    private byte[] picture() throws Exception {
        Answer answer = send("GET", withKey("picture.png", ""));
        assertEquals(200, answer.statusCode());
        return answer.body();
    }

    /** Editors may save twice within what a file system's clock tells apart. */
    private void write(String text) throws IOException {
        FileTime before = Files.getLastModifiedTime(file);
        Files.writeString(file, text);
        Files.setLastModifiedTime(file, FileTime.fromMillis(before.toMillis() + 2_000));
    }

    @Test
    void aPictureArrivesAndIsTheMeanOfItsPasses() throws Exception {
        done("action=size&x=48&y=100");
        JsonNode state =
                await(s -> s.get("finished").asBoolean() && s.get("width").asInt() == 48);
        assertEquals(32, state.get("height").asInt());
        assertEquals(SAMPLES, state.get("samples").asInt());
        var shown = ImageIO.read(new ByteArrayInputStream(picture()));
        assertEquals(48, shown.getWidth());
        assertEquals(32, shown.getHeight());
        // The ball in the middle is brighter than the black around it.
        assertTrue((shown.getRGB(24, 12) & 0xff) > 50);
        assertEquals(0, shown.getRGB(2, 2) & 0xffffff);
    }

    /** With a single pass, the view shows the bytes of a render of the same scene, size and samples. */
    @Test
    void aPassIsAnOrdinaryRender() throws Exception {
        restart(1);
        awaitFinished();
        Scene scene = SceneReader.read(file);
        RenderSettings usual = RenderSettings.of(scene);
        Image expected = Renderer.render(
                scene, usual.withSize(24, 16).withBudget(usual.budget().withSamples(1)));
        var shown = ImageIO.read(new ByteArrayInputStream(picture()));
        int[] argb = shown.getRGB(0, 0, 24, 16, null, 0, 24);
        assertArrayEquals(expected.toArgb(), argb);
    }

    @Test
    void aMotionStartsAnew() throws Exception {
        // Of more samples a slow machine makes other passes, whose random numbers differ.
        restart(2);
        JsonNode before = awaitFinished();
        byte[] first = picture();
        done("action=orbit&x=40&y=10");
        JsonNode after = await(s -> s.get("finished").asBoolean()
                && s.get("picture").asLong() > before.get("picture").asLong());
        assertTrue(after.get("moved").asBoolean());
        assertFalse(Arrays.equals(first, picture()));
        done("action=reset");
        awaitFinished();
        assertFalse(state(0).get("moved").asBoolean());
        assertArrayEquals(first, picture());
    }

    /** There is no end of passes in sight: what is under way is given up. */
    @Test
    void aMotionEndsThePassesUnderWay() throws Exception {
        restart(1 << 20);
        done("action=size&x=240&y=160");
        await(s -> s.get("samples").asInt() > 2);
        done("action=orbit&x=40&y=10");
        JsonNode after = await(s -> s.get("current").asBoolean());
        assertTrue(after.get("moved").asBoolean());
        assertFalse(after.get("finished").asBoolean());
    }

    @Test
    void onlySomePagesWaitAtATime() throws Exception {
        List<Socket> waiting = new ArrayList<>();
        try {
            for (int i = 0; i < ViewServer.MOST_VIEWERS; i++) {
                waiting.add(waitFor(awaitFinished()));
            }
            Answer refused;
            boolean wereAnswered;
            do {
                // This question may have been admitted in place of one of them, and there may have been news.
                refused = send("GET", withKey("state.json", "after=0"));
                Thread.sleep(10);
                wereAnswered = replaceAnswered(waiting);
            } while (wereAnswered || refused.statusCode() == 200);
            assertEquals(503, refused.statusCode());
            assertEquals("there are " + ViewServer.MOST_VIEWERS + " pages already\n", text(refused));
            // A change is news for all of them.
            done("action=dolly&x=2");
            for (Socket socket : waiting) {
                Answer answer = Answer.of(socket.getInputStream().readAllBytes());
                assertTrue(
                        new ObjectMapper().readTree(answer.body()).get("moved").asBoolean());
            }
        } finally {
            for (Socket socket : waiting) {
                socket.close();
            }
        }
    }

    /** Asks for the state after this one, and does not read the answer. */
    private Socket waitFor(JsonNode state) throws IOException {
        Socket socket =
                new Socket(InetAddress.getLoopbackAddress(), URI.create(address).getPort());
        String target = withKey("state.json", "after=" + state.get("version").asLong());
        String request = "GET /" + target + " HTTP/1.1\r\nHost: localhost\r\n\r\n";
        socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
        return socket;
    }

    /** Lets others wait in place of those that have been answered; returns whether there were any. */
    private boolean replaceAnswered(List<Socket> waiting) throws Exception {
        boolean wereAny = false;
        for (int i = 0; i < waiting.size(); i++) {
            if (waiting.get(i).getInputStream().available() > 0) {
                waiting.get(i).close();
                waiting.set(i, waitFor(state(0)));
                wereAny = true;
            }
        }
        return wereAny;
    }

    @Test
    void exposureNeedsNoRender() throws Exception {
        JsonNode before = awaitFinished();
        byte[] first = picture();
        done("action=exposure&x=-2");
        JsonNode after = state(0);
        assertTrue(after.get("finished").asBoolean());
        assertNotEquals(before.get("picture"), after.get("picture"));
        var dark = ImageIO.read(new ByteArrayInputStream(picture()));
        var bright = ImageIO.read(new ByteArrayInputStream(first));
        assertTrue((dark.getRGB(12, 6) & 0xff) < (bright.getRGB(12, 6) & 0xff));
    }

    @Test
    void aSavedChangeIsShownAndAMistakeIsToldWithItsPlace() throws Exception {
        awaitFinished();
        write(SCENE.replace("\"radius\": 1,", "\"radius\": -1,"));
        JsonNode broken = await(s -> !s.get("problems").isEmpty());
        String problem = broken.get("problems").get(0).asString();
        assertTrue(problem.startsWith(file + ":10:"), problem);
        assertTrue(problem.contains("/objects/0/radius"), problem);
        // The last good picture stays, and can still be moved.
        assertEquals("image/png", send("GET", withKey("picture.png", "")).header("Content-Type"));
        done("action=orbit&x=5&y=0");
        assertFalse(state(0).get("problems").isEmpty());
        write(SCENE.replace("\"fieldOfView\": 40", "\"fieldOfView\": 50"));
        JsonNode mended = await(s -> s.get("problems").isEmpty());
        assertEquals(50, mended.get("fieldOfView").asDouble());
        assertFalse(mended.get("moved").asBoolean());
    }

    @Test
    void aCameraThatWasChosenOutlivesOtherChangesOfTheFile() throws Exception {
        done("action=field-of-view&x=25");
        long before = state(0).get("version").asLong();
        write(SCENE.replace("\"radius\": 1,", "\"radius\": 0.5,"));
        JsonNode state = await(
                s -> s.get("version").asLong() > before && s.get("finished").asBoolean());
        assertEquals(25, state.get("fieldOfView").asDouble());
    }

    @Test
    void filesThatTheSceneNamesAreWatched() throws Exception {
        Path picture = folder.resolve("a.png");
        ImageFiles.writePng(new Image(1, 1, new float[] {1, 1, 1}), picture);
        write(SCENE.replace(
                        "\"materials\": { \"white\": { \"type\": \"matte\", \"color\": \"#ffffff\" }",
                        "\"textures\": { \"a\": { \"file\": \"a.png\" } },"
                                + "\"materials\": { \"white\": { \"type\": \"matte\", \"color\": { \"texture\": \"a\" } }")
                .replace("\"fieldOfView\": 40", "\"fieldOfView\": 41"));
        await(s -> s.get("fieldOfView").asDouble() == 41);
        Files.delete(picture);
        String problem =
                await(s -> !s.get("problems").isEmpty()).get("problems").get(0).asString();
        assertTrue(problem.contains("a.png"), problem);
        ImageFiles.writePng(new Image(1, 1, new float[] {0, 0, 0}), picture);
        // Black now, without a change of the scene file.
        await(s -> s.get("problems").isEmpty() && s.get("finished").asBoolean());
        int rgb = ImageIO.read(new ByteArrayInputStream(picture())).getRGB(12, 6);
        assertEquals(0, rgb & 0xffffff);
    }

    @Test
    void aFileThatWasMissingIsFoundWhenItComes() throws Exception {
        write(SCENE.replace("\"materials\"", "\"textures\": { \"a\": { \"file\": \"a.png\" } }, \"materials\""));
        await(s -> !s.get("problems").isEmpty());
        ImageFiles.writePng(new Image(1, 1, new float[] {1, 1, 1}), folder.resolve("a.png"));
        await(s -> s.get("problems").isEmpty());
    }

    @Test
    void savingWritesCameraAndExposureAndNothingElse() throws Exception {
        assertEquals(Optional.empty(), view.save());
        assertEquals(SCENE, Files.readString(file));
        done("action=field-of-view&x=25");
        done("action=dolly&x=2");
        done("action=exposure&x=1.5");
        done("action=save");
        String expected = SCENE.replace("[0, 0, -5]", "[0, 0, -10]")
                .replace("40 /* wide", "25 /* wide")
                .replaceFirst("\n  \\]\n\\}", "\n  ],\n  \"display\": { \"exposure\": 1.5 }\n}");
        assertEquals(expected, Files.readString(file));
        assertFalse(state(0).get("moved").asBoolean());
    }

    @Test
    void aFileThatHasChangedMeanwhileIsNotWrittenOver() throws Exception {
        done("action=dolly&x=2");
        write("{ half a scene");
        Answer answer = act("action=save");
        assertEquals(409, answer.statusCode());
        assertEquals("the file has changed since it was read: nothing was written\n", text(answer));
        assertEquals("{ half a scene", Files.readString(file));
    }

    @Test
    void filesOfOtherProgramsAreNotWritten() throws Exception {
        view.close();
        begin(SAMPLES, false);
        done("action=dolly&x=2");
        assertFalse(state(0).get("refusal").asString().isEmpty());
        assertEquals(409, act("action=save").statusCode());
        assertTrue(view.save().isPresent());
        assertEquals(SCENE, Files.readString(file));
    }

    @Test
    void aPixelTellsWhatIsThere() throws Exception {
        awaitFinished();
        JsonNode hit = new ObjectMapper()
                .readTree(send("GET", withKey("pixel.json", "x=0.5&y=0.5")).body());
        assertEquals("ball, object 0 (sphere)", hit.get("object").asString());
        assertEquals("white (matte)", hit.get("material").asString());
        assertEquals(
                DISTANCE * Math.sqrt(1 + 2 * SLOPE * SLOPE), hit.get("depth").asDouble(), 1e-5);
        assertEquals(DISTANCE - 5, hit.get("point").get(2).asDouble(), 1e-5);
        assertEquals(DISTANCE - 5, hit.get("normal").get(2).asDouble(), 1e-5);
        assertEquals("linear", hit.get("unit").asString());
        assertTrue(hit.get("value").get(0).asDouble() > 0);
        JsonNode miss = new ObjectMapper()
                .readTree(send("GET", withKey("pixel.json", "x=0.01&y=0.01")).body());
        assertEquals("nothing", miss.get("object").asString());
        assertEquals(null, miss.get("point"));
    }

    @Test
    void anOrbitMayTurnAroundWhatWasPicked() throws Exception {
        done("action=aim&x=0.5&y=0.5");
        String camera = text(send("GET", withKey("camera.json", "")));
        JsonNode json = new ObjectMapper().readTree(camera);
        assertEquals(DISTANCE - 5, json.get("lookAt").get(2).asDouble(), 1e-5);
        refused(400, "there is nothing at that place", "action=aim&x=0.01&y=0.01");
        refused(409, "\"lens\" is missing: this camera has nothing to focus", "action=focus&x=0.5&y=0.5");
    }

    @Test
    void strangersGetNoAnswer() throws Exception {
        String wrong = "?key=" + "0".repeat(key.length()) + "&action=dolly&x=2";
        for (String target : new String[] {"do?action=dolly&x=2", "do" + wrong}) {
            assertEquals(403, send("POST", target).statusCode());
        }
        for (String path : new String[] {"state.json", "picture.png", "pixel.json", "camera.json"}) {
            assertEquals(403, send("GET", path).statusCode());
            assertEquals(403, send("GET", path + wrong).statusCode());
        }
        // What needs no key says nothing of the scene.
        for (String path : new String[] {"", "view.css", "view.js", "pointer.js", "icon.svg"}) {
            String page = text(send("GET", path));
            assertFalse(page.contains(key) || page.contains("scene.json"), path);
        }
        assertFalse(state(0).get("moved").asBoolean());
    }

    @Test
    void readingDoesNotChangeAnything() throws Exception {
        assertEquals(405, send("GET", withKey("do", "action=dolly&x=2")).statusCode());
        assertEquals(405, send("POST", withKey("state.json", "")).statusCode());
        assertFalse(state(0).get("moved").asBoolean());
    }

    /** A page elsewhere whose name leads here (DNS rebinding) names itself in its requests. */
    @Test
    void otherNamesOfThisMachineAreRefused() throws Exception {
        for (String host : new String[] {"evil.example", "127.0.0.1.evil.example", ""}) {
            assertEquals(
                    403, send("POST", withKey("do", "action=dolly&x=2"), host).statusCode());
            assertEquals(403, send("GET", "", host).statusCode());
        }
        assertFalse(state(0).get("moved").asBoolean());
    }

    @Test
    void pagesLoadNothingFromElsewhere() throws Exception {
        Answer page = send("GET", "");
        String policy = page.header("Content-Security-Policy");
        assertTrue(policy.startsWith("default-src 'none'") && !policy.contains("unsafe"), policy);
        for (String path : new String[] {"", "view.css", "view.js", "pointer.js"}) {
            assertFalse(text(send("GET", path)).contains("//cdn"), path);
            assertFalse(text(send("GET", path)).matches("(?s).*(src|href)=\"(https?:)?//.*"), path);
        }
    }

    @Test
    void requestsThatSayNoNumbersAreRefused() throws Exception {
        refused(400, "x must be a number in -360.0..360.0", "action=orbit&y=1");
        refused(400, "x must be a number in -360.0..360.0", "action=orbit&x=NaN&y=1");
        refused(400, "x must be a number in 0.01..100.0", "action=dolly&x=0");
        refused(400, "there is no such action", "action=explode");
        assertEquals(404, send("GET", withKey("secrets", "")).statusCode());
        assertFalse(state(0).get("moved").asBoolean());
    }

    @Test
    void aSceneThatCannotBeReadStartsNoView() throws Exception {
        Files.writeString(file, "{}");
        LiveView.Options options = new LiveView.Options("", 0, 1, 1);
        ServerLog log = new ServerLog(line -> {}, System::nanoTime);
        assertThrows(SceneException.class, () -> LiveView.start(new FileSource(file), FileSource.FILES, options, log));
    }
}
