package enlightenment.view;

import java.io.IOException;
import java.net.HttpURLConnection;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.function.Predicate;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;

/** A page's side of a view, over HTTP on loopback. */
public final class ViewClient {
    private final String address;
    private final String key;

    /** @param address as the view says it, with its key */
    public ViewClient(String address) {
        this.address = address.split("#")[0];
        key = address.split("#")[1];
    }

    /** What came back. */
    public record Answer(int code, byte[] body) {
        public String text() {
            return new String(body, StandardCharsets.UTF_8);
        }
    }

    /** Asks for something, with the key. */
    public Answer get(String path, String query) throws IOException {
        return send("GET", path + "?key=" + key + "&" + query);
    }

    /** Asks for an action, with the key. */
    public Answer act(String query) throws IOException {
        return send("POST", "do?key=" + key + "&" + query);
    }

    /** Sends a request as it stands. */
    public Answer send(String method, String target) throws IOException {
        HttpURLConnection connection =
                (HttpURLConnection) URI.create(address + target).toURL().openConnection();
        connection.setRequestMethod(method);
        int code = connection.getResponseCode();
        try (var in = code < 400 ? connection.getInputStream() : connection.getErrorStream()) {
            return new Answer(code, in.readAllBytes());
        }
    }

    /** Waits, by the long poll of pages, until what a path says is as expected. */
    public JsonNode await(String path, Predicate<JsonNode> expected) throws IOException {
        Deadline deadline = new Deadline();
        for (long after = 0; ; ) {
            JsonNode news =
                    new ObjectMapper().readTree(get(path, "after=" + after).body());
            if (expected.test(news)) {
                return news;
            }
            deadline.check(news::toString);
            after = news.get("version").asLong();
        }
    }

    /** Waits until the final render is in a state. */
    public JsonNode awaitRender(String state) throws IOException {
        return await("render.json", s -> s.get("state").asString().equals(state));
    }
}
