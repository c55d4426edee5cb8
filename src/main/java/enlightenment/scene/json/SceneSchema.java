package enlightenment.scene.json;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** The JSON Schema of the scene format, for editors and other programs. */
public final class SceneSchema {
    private SceneSchema() {}

    /** The schema's text (JSON Schema 2020-12). */
    public static String text() {
        try (InputStream in = SceneSchema.class.getResourceAsStream("scene.schema.json")) {
            if (in == null) {
                throw new IllegalStateException("the schema is missing from the program");
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
