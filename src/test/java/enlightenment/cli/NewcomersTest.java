package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;

/** What somebody tries who knows other renderers, and has read nothing. */
class NewcomersTest {
    @TempDir
    Path folder;

    private static final String SCENE =
            """
            { "image": { "width": 8, "height": 8 },
              "camera": { "type": "perspective", "eye": [0, 0, -4], "lookAt": [0, 0, 0], "fieldOfView": 40 },
              "objects": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1,
                "material": { "type": "glass", "color": "#ffffff", "indexOfRefraction": 1.5 } } ] }
            """;

    @ParameterizedTest
    @CsvSource({
        "indexOfRefraction, ior, indexOfRefraction",
        "fieldOfView, fov, fieldOfView",
        "center, position, center",
        "eye, origin, eye",
    })
    void keysOfOtherRenderersAreTranslated(String key, String theirs, String ours) throws IOException {
        Path scene = Files.writeString(folder.resolve("s.json"), SCENE.replace(key, theirs));
        CliRun run = CliRun.of("validate", scene);
        assertEquals(2, run.code());
        assertTrue(run.err().contains("did you mean \"" + ours + "\"?"), run.err());
    }

    @ParameterizedTest
    @CsvSource({"dielectric, glass", "diffuse, matte", "metal, glossy"})
    void materialsOfOtherRenderersAreTranslated(String theirs, String ours) throws IOException {
        Path scene = Files.writeString(folder.resolve("s.json"), SCENE.replace("\"glass\"", '"' + theirs + '"'));
        CliRun run = CliRun.of("validate", scene);
        assertTrue(run.err().contains("did you mean \"" + ours + "\"?"), run.err());
    }

    @ParameterizedTest
    @CsvSource({"--spp, --samples", "--integrator, --method", "--resolution, --size", "--sample, --samples"})
    void optionsOfOtherRenderersAreTranslated(String theirs, String ours) {
        CliRun run = CliRun.of("render", "a.json", "-o", "b.png", theirs, "4");
        assertEquals(2, run.code());
        assertTrue(run.err().contains("did you mean \"" + ours + "\"?"), run.err());
    }

    @Test
    void noCommandAtAllShowsTheHelp() {
        CliRun run = CliRun.of();
        assertEquals(2, run.code());
        assertTrue(run.err().startsWith("Usage: enlightenment"), run.err());
        assertTrue(run.err().contains("render"), run.err());
    }

    @Test
    void convertTakesItsOutputAsOtherCommandsDo() throws IOException {
        Path nff = Files.writeString(
                folder.resolve("a.nff"),
                "b 0 0 0\nv\nfrom 0 -5 0\nat 0 0 0\nup 0 0 1\nangle 40\nhither 1\nresolution 8 8\n"
                        + "f 1 1 1 1 0 0 0 0\ns 0 0 0 1\n");
        CliRun byOption = CliRun.of("convert", nff, "-o", folder.resolve("a.json"));
        assertEquals(0, byOption.code(), byOption.err());
        assertEquals(0, CliRun.of("convert", nff, folder.resolve("b.json")).code());
        assertEquals(Files.readString(folder.resolve("b.json")), Files.readString(folder.resolve("a.json")));
        assertEquals(
                2,
                CliRun.of("convert", nff, folder.resolve("b.json"), "-o", folder.resolve("c.json"))
                        .code());
    }

    @Test
    void aPreviewWithoutANumberDoesNotEatTheScene() throws IOException {
        Path scene = Files.writeString(folder.resolve("s.json"), SCENE);
        CliRun run = CliRun.of("render", "-o", folder.resolve("p.png"), "--preview", scene);
        assertEquals(0, run.code(), run.err());
        assertTrue(Files.exists(folder.resolve("p.png")));
        assertEquals(
                2,
                CliRun.of("render", scene, "-o", folder.resolve("p.png"), "--preview", "-1")
                        .code());
    }

    @Test
    void completionCallsItselfByTheNameItIsCalledBy() {
        CliRun run = CliRun.of("completion", "--help");
        assertEquals(0, run.code());
        assertTrue(run.out().startsWith("Usage: enlightenment completion"), run.out());
        assertTrue(!run.out().contains("generate-completion"), run.out());
    }

    @Test
    void theHelpOfRenderShowsTheTenCommonOptionsFirst() {
        String help = CliRun.of("render", "--help").out();
        List<String> headings = List.of(
                "Common:", "Picture:", "Method:", "Output:", "Watching:", "Keeping:", "Many machines, other devices:");
        List<Integer> places = new ArrayList<>();
        headings.forEach(heading -> places.add(help.indexOf("\n" + heading)));
        assertTrue(places.get(0) > 0, help);
        assertEquals(places.stream().sorted().toList(), places, help);
        String common = help.substring(places.get(0), places.get(1));
        assertEquals(
                10, common.lines().filter(line -> line.matches(" {2,6}-.*")).count(), common);
    }

    /** Methods that only the tests have, as those from outside, bring options of their own. */
    private static boolean isOfTests(OptionSpec option) {
        return option.longestName().matches("--(toy|occlusion)-.*");
    }

    @Test
    void everyOptionOfRenderIsInOneGroup() {
        CommandLine line = Commands.tree(new Terminal(System.out, System.err, new ShutdownSignal()))
                .getSubcommands()
                .get("render");
        List<String> all = line.getCommandSpec().options().stream()
                .filter(option -> !option.hidden() && !isOfTests(option))
                .map(OptionSpec::longestName)
                .toList();
        assertEquals(new TreeSet<>(all), new TreeSet<>(OptionGroups.grouped()));
        assertEquals(
                new TreeSet<>(OptionGroups.grouped()).size(),
                OptionGroups.grouped().size());
    }
}
