package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.input.Failures;
import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import enlightenment.cli.terminal.Version;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CommandsTest {
    @TempDir
    Path folder;

    @Test
    void validScenesAreCalledValid() throws IOException {
        Path scene = CliRun.scene(folder, "\"width\": 8, \"height\": 8");
        assertEquals(new CliRun(0, scene + ": valid\n" + scene + ": valid\n", ""), CliRun.of("validate", scene, scene));
    }

    @Test
    void oneBadSceneDoesNotKeepTheOthersFromBeingChecked() throws IOException {
        Path scene = CliRun.scene(folder, "\"width\": 8, \"height\": 8");
        Path bad = CliRun.badScene(folder);
        Path missing = folder.resolve("missing.json");
        CliRun run = CliRun.of("validate", bad, missing, scene);
        assertEquals(2, run.code());
        assertEquals(scene + ": valid\n", run.out());
        assertTrue(run.err().contains("/objects/0/radius"), run.err());
        assertTrue(run.errLines().stream().anyMatch(l -> l.startsWith(missing + ": ")), run.err());
    }

    @Test
    void inspectCountsAndForetells() throws IOException {
        Path scene = CliRun.scene(folder, "\"width\": 8, \"height\": 6");
        CliRun run = CliRun.of("inspect", scene, "--size", "1024x1024", "--threads", "2");
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().matches("(?s)name: +Two balls\nsize: +8x6\ncamera: +perspective\n.*"), run.out());
        assertTrue(run.out().matches("(?s).*\nobjects: +2 \\(2 sphere\\)\n.*"), run.out());
        assertTrue(run.out().matches("(?s).*\nlights: +1 \\(1 sphere\\)\n.*"), run.out());
        assertTrue(run.out().matches("(?s).*\nnamed materials: +1 \\(1 matte\\)\n.*"), run.out());
        assertTrue(run.out().matches("(?s).*\nmodelled: +direct light of 1 light\n +shadows\n.*"), run.out());
        assertTrue(run.out().matches("(?s).*\nnot needed: +mirrors; refraction; [^\n]+\nprimitives: .*"), run.out());
        // A mebi of pixels of 52 bytes each (film 36, image 12, estimated variance 4); two primitives do not show.
        assertTrue(run.out().matches("(?s).*\nexpected memory: +52.0 MiB\n"), run.out());
        assertTrue(run.out().contains("size=1024x1024 antialias=4 shadowSamples=10 seed=0 threads=2"), run.out());
    }

    @Test
    void inspectListsWhatTheSceneDoesNotNeedInOneLine() throws IOException {
        CliRun run = CliRun.of("inspect", CliRun.scene(folder, "\"width\": 8, \"height\": 6"));
        List<String> lines = run.outLines();
        int at = lines.indexOf(lines.stream()
                .filter(l -> l.startsWith("not needed:"))
                .findFirst()
                .orElseThrow());
        assertTrue(lines.get(at).contains("mirrors; refraction; image textures"), lines.get(at));
        assertTrue(lines.get(at + 1).startsWith("primitives:"), lines.get(at + 1));
    }

    @Test
    void inspectTellsOfABadSceneAsRenderDoes() throws IOException {
        CliRun run = CliRun.of("inspect", CliRun.badScene(folder));
        assertEquals(2, run.code());
        assertEquals("", run.out());
        assertTrue(run.err().contains("/objects/0/radius"), run.err());
    }

    @Test
    void schemaIsPrinted() {
        CliRun run = CliRun.of("schema");
        assertEquals(0, run.code());
        assertTrue(run.out().startsWith("{") && run.out().endsWith("}\n"), run.out());
        assertTrue(run.out().contains("https://json-schema.org/draft/2020-12/schema"), run.out());
    }

    @Test
    void convertWritesASceneThatIsValid() throws IOException {
        Path nff = Files.writeString(
                folder.resolve("in.nff"),
                """
                v
                from 0 0 -5
                at 0 0 0
                up 0 1 0
                angle 45
                hither 0.01
                resolution 16 16
                l 2 3 -2
                f 1 1 1 1 0 0 0 0
                s 0 0 0 1
                """);
        Path json = folder.resolve("out.json");
        CliRun run = CliRun.of("convert", nff, json);
        assertEquals(0, run.code(), run.err());
        assertEquals("", run.out());
        for (String note : run.errLines()) {
            assertTrue(note.startsWith(nff + ": "), note);
        }
        assertTrue(Files.size(json) > 0);
    }

    @Test
    void convertRefusesWhatItCannotUse() throws IOException {
        Path out = folder.resolve("out.json");
        Path missing = folder.resolve("missing.nff");
        assertEquals(
                new CliRun(2, "", "enlightenment: " + missing + ": there is no such file\n"),
                CliRun.of("convert", missing, out));
        Path nonsense = Files.writeString(folder.resolve("in.nff"), "nonsense\n");
        assertEquals(2, CliRun.of("convert", nonsense, out).code());
        Path txt = folder.resolve("out.txt");
        assertEquals(
                new CliRun(2, "", "enlightenment: OUT.json must name a file that ends in .json, not \"" + txt + "\"\n"),
                CliRun.of("convert", nonsense, txt));
        Path own = Files.writeString(folder.resolve("own.json"), "v");
        assertEquals(2, CliRun.of("convert", own, own).code());
        assertEquals("v", Files.readString(own));
        assertEquals(
                1, CliRun.of("convert", nonsense, folder.resolve("no/out.json")).code());
        assertFalse(Files.exists(out));
    }

    @Test
    void versionNamesEnlightenmentAndJava() {
        String line = "enlightenment " + Version.number() + " (Java " + Runtime.version() + ")\n";
        assertEquals(new CliRun(0, line, ""), CliRun.of("--version"));
        assertEquals(new CliRun(0, line, ""), CliRun.of("-V"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"render", "validate", "inspect", "schema", "convert", "compare"})
    void helpIsTheSameOnBothWays(String command) {
        CliRun help = CliRun.of("help", command);
        assertEquals(0, help.code());
        assertTrue(help.out().startsWith("Usage: enlightenment " + command + " "), help.out());
        assertEquals(help, CliRun.of(command, "--help"));
    }

    @Test
    void helpListsAllCommands() {
        CliRun run = CliRun.of("help");
        assertEquals(0, run.code());
        for (String c :
                new String[] {"render", "validate", "inspect", "schema", "convert", "compare", "completion", "help"}) {
            assertTrue(run.out().contains("\n  " + c + " "), c);
        }
        assertEquals(run, CliRun.of("--help"));
    }

    @Test
    void completionIsAScriptThatKnowsTheOptions() {
        CliRun run = CliRun.of("completion");
        assertEquals(0, run.code());
        assertTrue(run.out().startsWith("#!/usr/bin/env bash"), run.out());
        assertTrue(run.out().contains("--shadow-samples"));
    }

    @Test
    void wrongUsageGetsOneMessageAndAHint() {
        wrong("unknown command \"rendr\"; did you mean \"render\"?", "", "rendr");
        wrong("unknown option: '--foo'", "", "--foo");
        wrong("missing required options and parameters: '--output=FILE', 'SCENE'", " render", "render");
        wrong("missing required option: '--output=FILE'", " render", "render", "a.json");
        wrong("unknown option: '--foo'", " render", "render", "a.json", "-o", "b.png", "--foo");
        wrong("missing required parameter: 'SCENE'", " validate", "validate");
        wrong("missing: -o FILE, or OUT.json after the file to read", " convert", "convert", "a.nff");
        wrong("unknown command \"info\"; did you mean \"inspect\"?", "", "info");
        wrong("missing required parameters: 'A', 'B'", " compare", "compare");
        wrong("missing required parameter: 'B'", " compare", "compare", "a.png");
        wrong("unmatched argument at index 0: 'x'", " schema", "schema", "x");
    }

    private static void wrong(String message, String topic, Object... args) {
        String err = "enlightenment: " + message + "\nenlightenment: see 'enlightenment help" + topic + "'\n";
        assertEquals(new CliRun(2, "", err), CliRun.of(args));
    }

    @Test
    void outputThatCannotBeWrittenIsAFailure() {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        OutputStream full = new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("full");
            }
        };
        int code = Main.run(new String[] {"schema"}, new PrintStream(full), new PrintStream(err, true));
        assertEquals(1, code);
        assertEquals("enlightenment: cannot write to standard output\n", err.toString(StandardCharsets.UTF_8));
    }

    @Test
    void whateverHappensBecomesOneMessage() {
        assertEquals("enlightenment: out of memory; java -Xmx sets how much there is\n", told(new OutOfMemoryError()));
        assertEquals(
                "enlightenment: internal error: java.lang.IllegalStateException: odd"
                        + " (java -Denlightenment.trace=true shows where)\n",
                told(new IllegalStateException("odd")));
        assertEquals("enlightenment: a/b: permission denied\n", told(new AccessDeniedException("a/b")));
        assertEquals("enlightenment: a/b: there is no such file\n", told(new NoSuchFileException("a/b")));
        assertEquals("enlightenment: a/b: it exists already\n", told(new FileAlreadyExistsException("a/b")));
        assertEquals("enlightenment: a/b: odd\n", told(new FileSystemException("a/b", null, "odd")));
        assertEquals("enlightenment: odd\n", told(new IOException("odd")));
        assertEquals("enlightenment: IOException\n", told(new IOException()));
    }

    private static String told(Throwable t) {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        PrintStream print = new PrintStream(err, true);
        assertEquals(1, new Failures(new Terminal(print, print, new ShutdownSignal())).report(t));
        return err.toString(StandardCharsets.UTF_8);
    }
}
