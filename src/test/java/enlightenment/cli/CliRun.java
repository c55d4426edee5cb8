package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/**
 * One run of the command line within this process.
 *
 * @param code its exit code
 * @param out what it wrote to standard output
 * @param err what it wrote to standard error
 */
public record CliRun(int code, String out, String err) {
    public static CliRun of(Object... args) {
        return of(new ShutdownSignal(), args);
    }

    public static CliRun of(ShutdownSignal stop, Object... args) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        int code = Main.run(quiet(texts(args)), new Terminal(print(out), print(err), stop));
        return new CliRun(code, out.toString(StandardCharsets.UTF_8), err.toString(StandardCharsets.UTF_8));
    }

    /** Runs what makes a picture, its fourth word the file, and gives its bytes. */
    public static byte[] picture(Object... args) throws IOException {
        CliRun run = of(args);
        assertEquals(0, run.code, run.err);
        return Files.readAllBytes((Path) args[3]);
    }

    public static String[] texts(Object... words) {
        return Stream.of(words).map(Object::toString).toArray(String[]::new);
    }

    /** On a busy machine a render takes long enough to tell of its progress: no test wants that unless it says so. */
    static String[] quiet(String... args) {
        boolean tells = args.length > 1
                && Set.of("render", "animate", "server", "trade").contains(args[0]);
        if (!tells || List.of(args).contains("--progress")) {
            return args;
        }
        String[] more = Arrays.copyOf(args, args.length + 2);
        more[args.length] = "--progress";
        more[args.length + 1] = "none";
        return more;
    }

    private static PrintStream print(ByteArrayOutputStream bytes) {
        return new PrintStream(bytes, true, StandardCharsets.UTF_8);
    }

    public List<String> errLines() {
        return err.lines().toList();
    }

    public List<String> outLines() {
        return out.lines().toList();
    }

    /** Writes a small scene: a ball above a floor. */
    public static Path scene(Path folder, String size) throws IOException {
        return Files.writeString(folder.resolve("scene.json"), sceneText(size));
    }

    /** A scene of two problems. */
    public static Path badScene(Path folder) throws IOException {
        String text = sceneText("\"width\": 8, \"height\": 8")
                .replace("\"radius\": 1,", "\"radius\": -1,")
                .replace("\"radius\": 0.5", "\"radios\": 0.5");
        return Files.writeString(folder.resolve("bad.json"), text);
    }

    private static String sceneText(String size) {
        return """
                {
                  "name": "Two balls",
                  "image": { SIZE },
                  "camera": { "type": "perspective", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "up": [0, 1, 0],
                              "fieldOfView": 40 },
                  "materials": { "white": { "type": "matte", "color": "#ffffff" } },
                  "lights": [ { "type": "sphere", "center": [2, 3, -2], "radius": 0.5, "color": "#ffffff" } ],
                  "objects": [
                    { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "white" },
                    { "type": "sphere", "center": [0, -101, 0], "radius": 100, "material": "white" }
                  ]
                }
                """
                .replace("SIZE", size);
    }
}
