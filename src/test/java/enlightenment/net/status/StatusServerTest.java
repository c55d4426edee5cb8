package enlightenment.net.status;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.PngOptions;
import enlightenment.net.listen.ServerLog;
import enlightenment.net.schedule.Snapshot;
import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.HttpURLConnection;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;

@Timeout(60)
class StatusServerTest {
    private final AtomicLong clock = new AtomicLong();
    private final Render render = new Render();
    private StatusServer server;

    /** A render as far as a test says. */
    private static final class Render implements StatusServer.Source {
        private volatile Image image = black(4, 3);
        private volatile boolean isFinished;

        @Override
        public Snapshot snapshot() {
            Snapshot.Worker one = new Snapshot.Worker(
                    7, "one \"quoted\"", 3, 1.5, 5, 1, 2_000, OptionalDouble.of(2.5), 4, 0.25, false);
            Snapshot.Worker two =
                    new Snapshot.Worker(8, "two", 1, 0.5, 0, 0, 0, OptionalDouble.empty(), 2, 0.125, true);
            return new Snapshot(
                    isFinished,
                    20,
                    9,
                    6,
                    5,
                    1,
                    2,
                    3,
                    4.5,
                    OptionalDouble.empty(),
                    List.of(one, two),
                    Set.of("b", "a"),
                    List.of(new Snapshot.Note(0.5, "one joined")));
        }

        @Override
        public Image image() {
            return image;
        }

        @Override
        public boolean isFinished() {
            return isFinished;
        }
    }

    private static Image black(int width, int height) {
        return new Image(width, height, new float[3 * width * height]);
    }

    @BeforeEach
    void start() throws Exception {
        server = StatusServer.start(render, 0, Thread::new, new ServerLog(line -> {}, clock::get), clock::get);
    }

    @AfterEach
    void end() throws Exception {
        server.close();
    }

    private HttpURLConnection open(String path) throws Exception {
        URI uri = URI.create("http://127.0.0.1:" + server.port() + path);
        HttpURLConnection connection = (HttpURLConnection) uri.toURL().openConnection();
        connection.setReadTimeout(20_000);
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
    void theJsonTellsWhatTheSnapshotTells() throws Exception {
        JsonNode json = new ObjectMapper().readTree(text("/status.json"));
        assertFalse(json.get("finished").asBoolean());
        int[] counts = {20, 9, 6, 5, 1, 2, 3};
        String[] keys = {"tiles", "done", "leased", "free", "auditsOpen", "confirmed", "duplicates"};
        for (int i = 0; i < keys.length; i++) {
            assertEquals(counts[i], json.get(keys[i]).asInt(), keys[i]);
        }
        assertEquals(4.5, json.get("elapsedSeconds").asDouble());
        assertTrue(json.get("remainingSeconds").isNull());
        assertEquals(new ObjectMapper().readTree("[\"a\",\"b\"]"), json.get("expelled"));
        assertEquals(new ObjectMapper().readTree("[{\"seconds\":0.5,\"text\":\"one joined\"}]"), json.get("log"));
        assertEquals(2, json.get("workers").size());
        assertEquals(
                new ObjectMapper()
                        .readTree(
                                """
                                { "name": "one \\"quoted\\"", "threads": 3, "connectedSeconds": 1.5, "tiles": 5, "audits": 1,
                                  "bytes": 2000, "tilesPerSecond": 2.5, "owed": 4, "silentSeconds": 0.25, "stalled": false }
                                """),
                json.get("workers").get(0));
        assertTrue(json.get("workers").get(1).get("tilesPerSecond").isNull());
        render.isFinished = true;
        assertTrue(new ObjectMapper()
                .readTree(text("/status.json"))
                .get("finished")
                .asBoolean());
    }

    @Test
    void healthIsOneWord() throws Exception {
        assertEquals("rendering\n", text("/health"));
        render.isFinished = true;
        assertEquals("finished\n", text("/health"));
    }

    @Test
    void thePictureSoFarIsMadeAtMostOnceASecond() throws Exception {
        byte[] first = get("/picture.png");
        render.image = black(6, 5);
        clock.addAndGet(StatusServer.PICTURE_PERIOD_NANOS - 1);
        assertArrayEquals(first, get("/picture.png"));
        clock.addAndGet(1);
        ByteArrayOutputStream next = new ByteArrayOutputStream();
        ImageFiles.toPng(render.image, next, PngOptions.DEFAULT);
        assertArrayEquals(next.toByteArray(), get("/picture.png"));
        assertEquals("image/png", open("/picture.png").getContentType());
    }

    @Test
    void whoSendsHalfARequestIsHungUpOnInTime() throws Exception {
        try (Socket half = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
            half.setSoTimeout(20_000);
            half.getOutputStream().write("GET /heal".getBytes(StandardCharsets.US_ASCII));
            // Whoever comes later has been taken later: so the half is known by now.
            assertEquals("rendering\n", text("/health"));
            server.check(clock.get() + SmallHttp.REQUEST_TIMEOUT_NANOS);
            half.setSoTimeout(1);
            assertThrows(java.net.SocketTimeoutException.class, () -> half.getInputStream()
                    .read());
            server.check(clock.get() + SmallHttp.REQUEST_TIMEOUT_NANOS + 1);
            half.setSoTimeout(20_000);
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
    void thePageNeedsNothingFromElsewhere() throws Exception {
        String html = text("/");
        assertFalse(html.contains("http:") || html.contains("https:") || html.contains("//"), "an address");
        String policy = open("/").getHeaderField("Content-Security-Policy");
        assertTrue(policy.startsWith("default-src 'none'"), policy);
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
            socket.setSoTimeout(20_000);
            OutputStream out = socket.getOutputStream();
            out.write((request + "Connection: close\r\n\r\n").getBytes(StandardCharsets.US_ASCII));
            out.flush();
            InputStream in = socket.getInputStream();
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}
