package enlightenment.view;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.listen.ServerLog;
import java.io.ByteArrayInputStream;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Predicate;
import javax.imageio.ImageIO;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;

/** A view of a scene file, and a page's side of it. */
final class ServedView implements Closeable {
    final LiveView view;
    private final ViewClient client;

    ServedView(Path file, int samples) throws IOException {
        view = LiveView.start(
                new FileSource(file),
                FileSource.FILES,
                new LiveView.Options("scene", 0, 2, samples),
                new ServerLog(line -> {}, System::nanoTime));
        client = new ViewClient(view.address());
    }

    ViewClient.Answer get(String path, String query) throws IOException {
        return client.get(path, query);
    }

    /** Sends a request without the key. */
    ViewClient.Answer send(String method, String path, String query) throws IOException {
        return client.send(method, path + "?" + query);
    }

    void act(String query) throws IOException {
        ViewClient.Answer answer = client.act(query);
        assertEquals(200, answer.code(), answer.text());
    }

    JsonNode json(String path, String query) throws IOException {
        ViewClient.Answer answer = get(path, query);
        assertEquals(200, answer.code(), answer.text());
        return new ObjectMapper().readTree(answer.body());
    }

    /** The colours of a picture, row by row. */
    int[] rgb(String path, String query) throws IOException {
        ViewClient.Answer answer = get(path, query);
        assertEquals(200, answer.code(), answer.text());
        var image = ImageIO.read(new ByteArrayInputStream(answer.body()));
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }

    /** Waits, by the long poll of pages, until a state is as expected. */
    JsonNode await(String query, Predicate<JsonNode> expected) throws IOException {
        Deadline deadline = new Deadline();
        JsonNode state = json("state.json", "after=0&" + query);
        while (!expected.test(state)) {
            deadline.check(state::toString);
            state = json("state.json", "after=" + state.get("version").asLong() + "&" + query);
        }
        return state;
    }

    JsonNode awaitFinished() throws IOException {
        return await("", s -> s.get("finished").asBoolean());
    }

    /** Waits until a layer is there at full resolution. */
    JsonNode awaitLayer(Layer layer) throws IOException, InterruptedException {
        await("layer=" + layer.word(), s -> has(s, layer));
        Deadline deadline = new Deadline();
        JsonNode found = json("layer.json", "layer=" + layer.word());
        while (found.get("width").asInt() < json("state.json", "").get("width").asInt()) {
            deadline.check(found::toString);
            Thread.sleep(5);
            found = json("layer.json", "layer=" + layer.word());
        }
        return found;
    }

    static boolean has(JsonNode state, Layer layer) {
        for (JsonNode one : state.get("layers")) {
            if (one.asString().equals(layer.word())) {
                return true;
            }
        }
        return false;
    }

    @Override
    public void close() throws IOException {
        view.close();
    }
}
