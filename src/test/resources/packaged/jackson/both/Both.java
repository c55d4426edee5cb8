package both;

import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import tools.jackson.core.json.JsonFactory;

/** Uses the library and, for purposes of its own, the library that that one uses. */
public final class Both {
    private Both() {}

    public static void main(String[] args) throws Exception {
        String text;
        try (var parser = new JsonFactory().createParser(tools.jackson.core.ObjectReadContext.empty(), "\"both\"")) {
            parser.nextToken();
            text = parser.getString();
        }
        Scene scene = SceneReader.read(java.nio.file.Path.of(args[0]));
        System.out.println(text + " " + !scene.objects().isEmpty());
    }
}
