package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.InputStream;
import java.io.OutputStream;
import java.net.HttpURLConnection;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class StatusServerTest {
    private Farm farm;

    @BeforeEach
    void server() throws Exception {
        farm = new Farm(Farm.options().statusPort(0)).begin();
    }

    @AfterEach
    void end() {
        farm.close();
    }

    private HttpURLConnection open(String path) throws Exception {
        URI uri = URI.create("http://127.0.0.1:" + farm.server.statusPort() + path);
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
    void theJsonTellsOfWorkersTilesAndWhatHappened() throws Exception {
        assertEquals("rendering\n", text("/health"));
        farm.join(Farm.slow(50));
        Farm.until(() -> farm.server.round().snapshot().done() > 2, "some tiles are done");
        String json = text("/status.json");
        assertTrue(json.contains("\"finished\":false"), json);
        assertTrue(json.contains("\"tiles\":" + farm.server.round().job().tiles()), json);
        assertTrue(json.contains("\"threads\":1"), json);
        assertTrue(json.contains("joined with 1 threads"), json);
        farm.join(Farm.worker(2));
        farm.result();
        Snapshot end = farm.server.round().snapshot();
        assertTrue(StatusJson.of(end).contains("\"finished\":true"));
        assertEquals(end.tiles(), end.done());
    }

    @Test
    void thePictureSoFarIsMadeAtMostOnceASecond() throws Exception {
        long start = System.nanoTime();
        byte[] black = get("/picture.png");
        farm.join(Farm.slow(60));
        Farm.until(() -> farm.server.round().snapshot().done() > 5, "some tiles are done");
        byte[] next = get("/picture.png");
        if (System.nanoTime() - start < 900_000_000L) {
            assertArrayEquals(black, next);
        }
        Farm.sleep(1_100);
        assertFalse(Arrays.equals(black, get("/picture.png")));
        assertEquals("image/png", open("/picture.png").getContentType());
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
            Socket half = new Socket(InetAddress.getLoopbackAddress(), farm.server.statusPort());
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
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), farm.server.statusPort())) {
            socket.setSoTimeout(20_000);
            OutputStream out = socket.getOutputStream();
            out.write((request + "Connection: close\r\n\r\n").getBytes(StandardCharsets.US_ASCII));
            out.flush();
            InputStream in = socket.getInputStream();
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}
