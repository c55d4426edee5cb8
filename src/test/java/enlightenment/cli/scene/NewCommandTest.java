package enlightenment.cli.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import enlightenment.cli.CliRun;
import enlightenment.scene.json.SceneReader;
import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.core.json.JsonReadFeature;
import tools.jackson.databind.json.JsonMapper;

/** {@code new}: its files are scenes that render, and it writes over nothing. */
class NewCommandTest {
    private static final JsonMapper JSON =
            JsonMapper.builder().enable(JsonReadFeature.ALLOW_JAVA_COMMENTS).build();

    @TempDir
    Path folder;

    private Path made(String kind) {
        Path file = folder.resolve(kind + ".json");
        CliRun run = CliRun.of("new", file, "--kind", kind);
        assertEquals(0, run.code(), run.err());
        assertEquals("", run.err());
        return file;
    }

    private static void refused(String message, Object... args) {
        assertEquals(new CliRun(2, "", "enlightenment: " + message + "\n"), CliRun.of(args));
    }

    private List<String> files() throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.map(f -> f.getFileName().toString()).sorted().toList();
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"studio", "room", "product", "outdoor"})
    void everyKindIsAValidSceneWithoutHints(String kind) {
        Path file = made(kind);
        CliRun valid = CliRun.of("validate", file);
        assertEquals(
                new CliRun(0, file + (kind.equals("product") ? ": valid in all 48 frames" : ": valid") + "\n", ""),
                valid);
        CliRun inspected = CliRun.of("inspect", file);
        assertEquals(0, inspected.code(), inspected.err());
        assertFalse((inspected.out() + inspected.err()).contains("hint"), inspected.out() + inspected.err());
    }

    @ParameterizedTest
    @ValueSource(strings = {"studio", "room", "product", "outdoor"})
    void theSchemaAcceptsEveryKind(String kind) throws IOException {
        var schema = SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
                .getSchema(JSON.readTree(SceneReader.schema()));
        assertEquals(List.of(), schema.validate(JSON.readTree(Files.readString(made(kind)))));
    }

    @ParameterizedTest
    @ValueSource(strings = {"studio", "room", "product", "outdoor"})
    void everyKindIsExplainedAndHasNoMarksLeft(String kind) throws IOException {
        String text = Files.readString(made(kind));
        assertTrue(text.lines().filter(l -> l.strip().startsWith("// ")).count() > 15, text);
        assertFalse(text.contains("@"), text);
        assertTrue(text.contains("// What to change next"), text);
        assertTrue(text.lines().allMatch(l -> l.length() <= 150), text);
    }

    @Test
    void everyKindRendersAPictureOfItsOwn() throws IOException {
        Set<List<Byte>> pictures = new HashSet<>();
        for (StarterKind kind : StarterKind.values()) {
            Path file = made(kind.toString());
            Path picture = folder.resolve("p.png");
            CliRun run = CliRun.of("render", file, "-o", picture, "--size", "16x9", "--samples", "4");
            assertEquals(0, run.code(), run.err());
            assertFalse(run.err().contains("nearly"), run.err());
            byte[] bytes = Files.readAllBytes(picture);
            assertTrue(pictures.add(Stream.iterate(0, i -> i < bytes.length, i -> i + 1)
                    .map(i -> bytes[i])
                    .toList()));
        }
    }

    @Test
    void theProductTurns() throws IOException {
        Path file = made("product");
        byte[] first = CliRun.picture(
                "render", file, "-o", folder.resolve("a.png"), "--size", "32x18", "--samples", "4", "--frame", "0");
        byte[] half = CliRun.picture(
                "render", file, "-o", folder.resolve("b.png"), "--size", "32x18", "--samples", "4", "--frame", "24");
        byte[] asWritten =
                CliRun.picture("render", file, "-o", folder.resolve("c.png"), "--size", "32x18", "--samples", "4");
        assertFalse(Arrays.equals(first, half));
    }

    @Test
    void withoutAKindItIsAStudio() throws IOException {
        Path file = folder.resolve("first.json");
        CliRun run = CliRun.of("new", file);
        assertEquals(0, run.code(), run.err());
        assertEquals(Files.readString(made("studio")).replace("\"studio\"", "\"first\""), Files.readString(file));
    }

    @Test
    void theLastLineIsTheCommandThatRendersIt() {
        Path name = folder.resolve("my scene");
        CliRun run = CliRun.of("new", name);
        assertEquals(
                List.of(
                        "wrote " + name + ".json",
                        "next: enlightenment render '" + name + ".json' -o '" + name + ".png'"),
                run.outLines());
    }

    @Test
    void aFileThatIsThereIsLeftAlone() throws IOException {
        Path file = Files.writeString(folder.resolve("mine.json"), "mine");
        for (Path name : List.of(file, folder.resolve("mine"))) {
            CliRun run = CliRun.of("new", name);
            assertEquals(2, run.code());
            assertEquals(1, run.errLines().size(), run.err());
            assertTrue(run.err().contains("is there already"), run.err());
        }
        assertEquals("mine", Files.readString(file));
    }

    @Test
    void aLinkThatLeadsNowhereIsLeftAlone() throws IOException {
        Path link = folder.resolve("link.json");
        Files.createSymbolicLink(link, folder.resolve("none.json"));
        assertEquals(2, CliRun.of("new", link).code());
        assertEquals(List.of("link.json"), files());
    }

    @Test
    void anUnknownKindIsToldWithAllKinds() throws IOException {
        refused(
                "--kind must be one of studio, room, product, outdoor, not \"rom\"",
                "new",
                folder.resolve("a.json"),
                "--kind",
                "rom");
        assertEquals(List.of(), files());
    }

    @Test
    void otherExtensionsAreRefused() throws IOException {
        for (String name : List.of("a.xml", "a.", "-")) {
            CliRun run = CliRun.of("new", name.equals("-") ? name : folder.resolve(name));
            assertEquals(2, run.code(), run.err());
            assertTrue(run.err().startsWith("enlightenment: NAME must name a file that ends in .json"), run.err());
        }
        assertEquals(List.of(), files());
    }

    @Test
    void aModelThatCannotBeReadLeavesNoScene() throws IOException {
        Path missing = folder.resolve("none.ply");
        refused(missing + ": there is no such file", "new", folder.resolve("a.json"), "--model", missing);
        Path text = Files.writeString(folder.resolve("text.ply"), "hello");
        CliRun run = CliRun.of("new", folder.resolve("a.json"), "--model", text);
        assertEquals(2, run.code());
        assertTrue(run.err().startsWith("enlightenment: " + text + ": "), run.err());
        assertEquals(1, run.errLines().size(), run.err());
        assertEquals(List.of("text.ply"), files());
    }

    @Test
    void oddNamesAreShownHarmlesslyAndReadBack() throws IOException {
        for (String odd : List.of("x\n\u001b[2Jenlightenment: all is well", "a \"quoted\\\" 'name'")) {
            Path file = folder.resolve(odd + ".json");
            CliRun run = CliRun.of("new", file);
            assertEquals(0, run.code(), run.err());
            assertEquals(Plain.lines(run.out()), run.out());
            assertEquals(2, run.outLines().size(), run.out());
            assertEquals(Plain.line(odd, 200), SceneReader.read(file).name());
            CliRun again = CliRun.of("new", file);
            assertEquals(1, again.errLines().size(), again.err());
            assertEquals(Plain.lines(again.err()), again.err());
        }
    }
}
