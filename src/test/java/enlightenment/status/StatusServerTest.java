package enlightenment.status;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.listen.ServerLog;
import enlightenment.listen.SmallHttp;
import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.HttpURLConnection;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;

@Timeout(600)
class StatusServerTest {
    /** As long as anything may take. */
    private static final int PATIENCE_MILLIS = 300_000;

    private final AtomicLong clock = new AtomicLong();
    private final Render render = new Render();
    private final List<Thread> threads = new CopyOnWriteArrayList<>();
    private StatusServer server;

    /** A render as far as a test says. */
    private static final class Render implements StatusSource {
        private volatile Image image = black(4, 3);
        private volatile State state = State.RENDERING;
        private volatile long picture = 3;
        private volatile Runnable asked = () -> {};

        @Override
        public Status status() {
            State now = state;
            asked.run();
            Map<String, Object> statistics = new LinkedHashMap<>();
            statistics.put("text", "\"quoted\"");
            statistics.put("whole", 1L << 40);
            statistics.put("known", OptionalDouble.of(2.5));
            statistics.put("unknown", Double.NaN);
            statistics.put("list", List.of(true, Map.of("deep", 7)));
            List<Status.Note> notes = List.of(new Status.Note(0.5, "</script>"));
            return new Status("a <b>", now, 9, 20, "tiles", 4.5, OptionalDouble.empty(), picture, statistics, notes);
        }

        @Override
        public Optional<Image> image() {
            return Optional.ofNullable(image);
        }

        @Override
        public State state() {
            return state;
        }
    }

    private static Image black(int width, int height) {
        return new Image(width, height, new float[3 * width * height]);
    }

    @BeforeEach
    void start() throws Exception {
        server = StatusServer.start(render, 0, this::thread, new ServerLog(line -> {}, clock::get), clock::get);
    }

    @AfterEach
    void end() throws Exception {
        server.close();
    }

    private Thread thread(Runnable work) {
        Thread thread = new Thread(work);
        threads.add(thread);
        return thread;
    }

    /** Waits until whatever was answered has been done with: the first thread takes connections, each of the others has served one. */
    private void awaitServed() throws Exception {
        for (Thread serving : threads.subList(1, threads.size())) {
            serving.join();
        }
    }

    private HttpURLConnection open(String path) throws Exception {
        URI uri = URI.create("http://127.0.0.1:" + server.port() + path);
        HttpURLConnection connection = (HttpURLConnection) uri.toURL().openConnection();
        connection.setReadTimeout(PATIENCE_MILLIS);
        return connection;
    }

    private byte[] get(String path) throws Exception {
        try (InputStream in = open(path).getInputStream()) {
            return in.readAllBytes();
        }
    }

    private String text(String path) throws Exception {
        return new String(get(path), StandardCharsets.UTF_8);
    }

    @Test
    void theJsonTellsWhatTheStatusTells() throws Exception {
        assertEquals(
                new ObjectMapper()
                        .readTree(
                                """
                                { "title": "a <b>", "state": "rendering", "finished": false, "done": 9, "total": 20, "unit": "tiles",
                                  "elapsedSeconds": 4.5, "remainingSeconds": null, "picture": 3, "text": "\\"quoted\\"",
                                  "whole": 1099511627776, "known": 2.5, "unknown": null, "list": [true, {"deep": 7}],
                                  "log": [{"seconds": 0.5, "text": "</script>"}] }
                                """),
                new ObjectMapper().readTree(text("/status.json")));
        render.state = State.FINISHED;
        JsonNode json = new ObjectMapper().readTree(text("/status.json"));
        assertTrue(json.get("finished").asBoolean());
        assertEquals("finished", json.get("state").asString());
    }

    @Test
    void healthIsOneWord() throws Exception {
        for (State state : State.values()) {
            render.state = state;
            assertEquals(state.word() + "\n", text("/health"));
        }
    }

    private static int width(byte[] png) throws Exception {
        return ImageIO.read(new ByteArrayInputStream(png)).getWidth();
    }

    @Test
    void thePictureSoFarIsMadeAtMostOnceASecondButTheLastAtOnce() throws Exception {
        byte[] first = get("/picture.png");
        assertEquals(4, width(first));
        render.image = black(6, 5);
        clock.addAndGet(StatusServer.PICTURE_PERIOD_NANOS - 1);
        assertArrayEquals(first, get("/picture.png"));
        clock.addAndGet(1_000 * StatusServer.PICTURE_PERIOD_NANOS);
        assertEquals(6, width(get("/picture.png")));
        assertEquals("image/png", open("/picture.png").getContentType());
        render.image = black(7, 5);
        render.state = State.FINISHED;
        assertEquals(7, width(get("/picture.png")));
    }

    @Test
    void whereThereIsNoPictureYetThereIsNone() throws Exception {
        render.image = null;
        assertEquals(404, open("/picture.png").getResponseCode());
    }

    @Test
    void theEndWaitsForPagesThatHaveNotSeenItAndForNobodyElse() throws Exception {
        assertTrue(server.awaitWatchers(PATIENCE_MILLIS));
        get("/status.json?page=gone");
        clock.addAndGet(Watchers.SILENCE_NANOS + 1);
        get("/status.json");
        get("/status.json?page=one");
        get("/status.json?page=two");
        get("/picture.png?page=two");
        render.state = State.FINISHED;
        get("/picture.png?page=one&state=finished");
        get("/status.json?page=three");
        Thread end = new Thread(() -> server.awaitWatchers(PATIENCE_MILLIS));
        end.start();
        while (end.getState() != Thread.State.TIMED_WAITING) {
            Thread.sleep(1);
        }
        get("/picture.png?page=two&state=finished");
        end.join();
    }

    /** A page asks for the picture of 100 %, the render ends, and only then the request comes in. */
    @Test
    void aPictureThatWasAskedForBeforeTheEndIsNoSignThatTheEndWasSeen() throws Exception {
        get("/status.json?page=one");
        render.state = State.FINISHED;
        get("/picture.png?page=one&state=rendering");
        awaitServed();
        assertFalse(server.awaitWatchers(1));
        get("/picture.png?page=one&state=finished");
        awaitServed();
        assertTrue(server.awaitWatchers(1));
    }

    @Test
    void aPageThatIsToldThatItGoesOnWhileItEndsIsWaitedFor() throws Exception {
        AtomicReference<Boolean> haveAllSeenIt = new AtomicReference<>();
        render.asked = () -> {
            render.state = State.FINISHED;
            haveAllSeenIt.set(server.awaitWatchers(1));
        };
        assertTrue(text("/status.json?page=one").contains("\"rendering\""));
        assertEquals(false, haveAllSeenIt.get());
    }

    @Test
    void whereThereIsNoPictureTheEndWaitsOnlyUntilPagesHaveHeardOfIt() throws Exception {
        render.picture = 0;
        get("/status.json?page=one");
        render.state = State.STOPPED;
        assertFalse(server.awaitWatchers(1));
        get("/status.json?page=one");
        awaitServed();
        assertTrue(server.awaitWatchers(1));
    }

    @Test
    void theEndWaitsForNobodyForLong() throws Exception {
        for (int i = 0; i < 2 * Watchers.MOST; i++) {
            get("/status.json?page=" + i);
        }
        assertFalse(server.awaitWatchers(1));
    }

    @Test
    void whoSendsHalfARequestIsHungUpOnInTime() throws Exception {
        try (Socket half = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
            half.setSoTimeout(PATIENCE_MILLIS);
            half.getOutputStream().write("GET /heal".getBytes(StandardCharsets.US_ASCII));
            // Whoever comes later has been taken later: so the half is known by now.
            assertEquals("rendering\n", text("/health"));
            server.check(clock.get() + SmallHttp.REQUEST_TIMEOUT_NANOS);
            half.setSoTimeout(1);
            assertThrows(java.net.SocketTimeoutException.class, () -> half.getInputStream()
                    .read());
            server.check(clock.get() + SmallHttp.REQUEST_TIMEOUT_NANOS + 1);
            half.setSoTimeout(PATIENCE_MILLIS);
            assertTrue(isEnded(half));
        }
    }

    private static boolean isEnded(Socket socket) throws Exception {
        try {
            return socket.getInputStream().read() < 0;
        } catch (java.net.SocketException e) {
            return true;
        }
    }

    @Test
    void thePageNeedsNothingFromElsewhereAndNothingWithinItIsRun() throws Exception {
        for (String path : List.of("/", "/status.css", "/status.js", "/icon.svg")) {
            String text = text(path).replace("http://www.w3.org/2000/svg", "").replace("url(#", "");
            assertFalse(text.contains("http:") || text.contains("https:") || text.contains("url("), path);
        }
        HttpURLConnection page = open("/");
        String policy = page.getHeaderField("Content-Security-Policy");
        assertTrue(policy.startsWith("default-src 'none'"), policy);
        assertFalse(policy.contains("unsafe"), policy);
        assertEquals("same-origin", page.getHeaderField("Cross-Origin-Resource-Policy"));
        assertFalse(text("/").matches("(?s).*(<script>|<style>|style=|onload=|onerror=).*"));
        assertEquals(404, open("/etc/passwd").getResponseCode());
    }

    @Test
    void itOnlyReadsAndOnlyForThisMachine() throws Exception {
        assertTrue(raw("POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0\r\n")
                .startsWith("HTTP/1.1 405"));
        assertTrue(raw("GET / HTTP/1.1\r\nHost: evil.example\r\n").startsWith("HTTP/1.1 403"));
        assertTrue(raw("GET /health HTTP/1.1\r\nHost: [::1]:80\r\n").startsWith("HTTP/1.1 200"));
    }

    @Test
    void halfSentAndTrickledRequestsAndGarbageKeepNobodyFromAnAnswer() throws Exception {
        List<Socket> halves = new ArrayList<>();
        for (int i = 0; i < 4 * SmallHttp.PLACES; i++) {
            Socket half = new Socket(InetAddress.getLoopbackAddress(), server.port());
            halves.add(half);
            if (i % 3 > 0) {
                half.getOutputStream()
                        .write((i % 3 == 1 ? "GET /heal" : "\r\n\r\n\0").getBytes(StandardCharsets.US_ASCII));
            }
            if (i % SmallHttp.PLACES == 0) {
                assertEquals("rendering\n", text("/health"));
            }
        }
        assertEquals("rendering\n", text("/health"));
        assertTrue(text("/status.json").startsWith("{"));
        assertEquals("rendering\n", text("/health"));
        for (Socket half : halves) {
            half.close();
        }
    }

    @Test
    void whatIsNoRequestForAPageIsRefused() throws Exception {
        assertTrue(raw("nonsense\r\n").startsWith("HTTP/1.1 400"));
        assertTrue(raw("GET /health HTTP/1.1\r\n").startsWith("HTTP/1.1 403"));
        assertTrue(raw("GET /health HTTP/1.1\r\nHost: localhost\r\nHost: evil.example\r\n")
                .startsWith("HTTP/1.1 403"));
    }

    private String raw(String request) throws Exception {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
            socket.setSoTimeout(PATIENCE_MILLIS);
            OutputStream out = socket.getOutputStream();
            out.write((request + "Connection: close\r\n\r\n").getBytes(StandardCharsets.US_ASCII));
            out.flush();
            InputStream in = socket.getInputStream();
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}
