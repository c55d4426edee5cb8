package enlightenment.cli.film;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.cli.CliRun;
import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FilmNotesTest {
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();
    private final PrintStream print = new PrintStream(err, true);
    private final FilmNotes notes = new FilmNotes(new Terminal(print, print, new ShutdownSignal()));

    private List<String> said() {
        return err.toString(StandardCharsets.UTF_8).lines().toList();
    }

    @Test
    void eachNoteIsToldOnceAndInTheEndOfWhichFrames() {
        notes.say(3, "odd");
        notes.say(4, "even");
        notes.say(4, "odd");
        notes.say(5, "dark", "dark, 0.1");
        notes.say(7, "odd");
        notes.say(6, "dark", "dark, 0.2");
        List<String> first = List.of(
                "enlightenment: frame 3: odd", "enlightenment: frame 4: even", "enlightenment: frame 5: dark, 0.1");
        assertEquals(first, said());
        notes.finish(5);
        assertEquals(
                List.of("enlightenment: 3 frames, 3..4, 7: odd", "enlightenment: 2 frames, 5..6: dark"),
                said().subList(3, 5));
    }

    @Test
    void whatConcernsAllFramesSaysSo() {
        notes.say(0, "odd");
        notes.say(1, "odd");
        notes.finish(2);
        assertEquals(List.of("enlightenment: frame 0: odd", "enlightenment: all 2 frames: odd"), said());
    }

    @Test
    void aDarkFilmIsHintedAtOnce(@TempDir Path folder) throws IOException {
        Path scene = Files.writeString(
                folder.resolve("dark.json"),
                """
                { "image": { "width": 8, "height": 6 },
                  "camera": { "type": "perspective", "eye": [0, 0, 0], "lookAt": [0, 0, 1], "fieldOfView": 40 },
                  "shading": { "model": "physical" },
                  "lights": [ { "type": "point", "position": [0, 3, 0], "color": "#ffffff", "intensity": 0.001 } ],
                  "objects": [ { "type": "sphere", "center": [0, 0, 5], "radius": 1,
                                 "material": { "type": "matte", "color": "#ffffff" } } ],
                  "animation": { "frames": 3, "framesPerSecond": 25, "tracks": [ { "target": "/objects/0/radius", "keys": { "0": 1, "2": 1.5 } } ] } }
                """);
        CliRun run = CliRun.of("animate", scene, "-o", folder.resolve("f-%02d.png"), "--antialias", "1");
        List<String> hints = run.errLines().stream()
                .filter(line -> line.contains("the picture is nearly black"))
                .toList();
        assertEquals(2, hints.size(), run.err());
        assertEquals(
                "enlightenment: all 3 frames: hint: the picture is nearly black: --exposure auto shows more of it",
                hints.get(1));
    }
}
