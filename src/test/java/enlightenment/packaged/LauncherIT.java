package enlightenment.packaged;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The launcher of the zip, run by sh as people run it: from anywhere, by any path, with whatever lies in the cache. */
@DisabledOnOs(OS.WINDOWS)
class LauncherIT {
    /** Shows the launcher's last word instead of starting Java: what Java would be started with, a line each. */
    private static final String SHOWING_JAVA =
            """
            #!/bin/sh
            if [ "$1" = -XshowSettings:properties ]; then
                echo "    java.version = VERSION" >&2
                exit 0
            fi
            printf '%s\\n' "$@"
            """;

    @TempDir
    static Path common;

    private static Path launcher;

    /** What {@code setup} said and made; tests that need its archive get a copy. */
    private static Packages.Run setup;

    @TempDir
    Path folder;

    private Path cache;

    @BeforeAll
    static void unpackAndSetUp() throws IOException, InterruptedException {
        launcher = UnpackedZip.into(Files.createDirectories(common.resolve("with blanks")))
                .resolve("bin/enlightenment");
        setup = launch(common, common.resolve("cache"), launcher, Map.of(), "setup");
    }

    @BeforeEach
    void nameCache() {
        cache = folder.resolve("cache of mine");
    }

    /** As if {@code setup} had run with the cache of this test. */
    private Path setUp() throws IOException {
        assertEquals(0, setup.code(), setup::toString);
        Path made = archive(common.resolve("cache"));
        assertTrue(setup.out().startsWith(made + ": "), setup::toString);
        Path mine = Files.createDirectories(cache.resolve("enlightenment"));
        // Beside it lies its size, without which the launcher does not use it.
        try (Stream<Path> files = Files.list(made.getParent())) {
            for (Path file : files.toList()) {
                Files.copy(file, mine.resolve(file.getFileName()));
            }
        }
        return mine.resolve(made.getFileName());
    }

    private Packages.Run launch(Path command, Map<String, String> more, Object... arguments)
            throws IOException, InterruptedException {
        return launch(folder, cache, command, more, arguments);
    }

    private static Packages.Run launch(
            Path folder, Path cache, Path command, Map<String, String> more, Object... arguments)
            throws IOException, InterruptedException {
        Map<String, String> environment =
                new HashMap<>(Map.of("JAVA_HOME", System.getProperty("java.home"), "XDG_CACHE_HOME", cache.toString()));
        environment.putAll(more);
        return Packages.run(
                folder,
                environment,
                Stream.concat(Stream.of(command), Stream.of(arguments)).toArray());
    }

    /** A Java that is none; its lines are the arguments that it was started with. */
    private Map<String, String> showing(String version) throws IOException {
        Path home = folder.resolve("java " + version);
        Path java = Files.createDirectories(home.resolve("bin")).resolve("java");
        Files.writeString(java, SHOWING_JAVA.replace("VERSION", version));
        assertTrue(java.toFile().setExecutable(true));
        return Map.of("JAVA_HOME", home.toString());
    }

    @Test
    void itWorksFromAnyFolderThroughLinksAndWithBlanksInPaths() throws Exception {
        Path links = Files.createDirectories(folder.resolve("bin"));
        Path first = Files.createSymbolicLink(links.resolve("first"), launcher);
        Path relative = Files.createSymbolicLink(links.resolve("second"), Path.of("first"));
        for (Path command : List.of(launcher, first, relative, Path.of("bin/second"))) {
            Packages.Run run = launch(command, Map.of(), "--version");
            assertEquals(0, run.code(), run::toString);
            assertTrue(run.out().startsWith("enlightenment " + Packages.VERSION + " (Java "), run::toString);
            assertEquals("", run.err());
        }
    }

    @Test
    void itIsFoundOnThePathAndThenCalledByItsName() throws Exception {
        Map<String, String> environment = new HashMap<>(showing("17.0.1"));
        environment.put("PATH", launcher.getParent() + ":" + System.getenv("PATH"));
        Packages.Run run = Packages.run(folder, environment, "sh", "-c", "enlightenment help");
        assertTrue(run.out().lines().anyMatch("-Denlightenment.launcher=enlightenment"::equals), run::toString);
        Packages.Run elsewhere = launch(launcher, showing("17.0.1"), "help");
        assertTrue(
                elsewhere.out().lines().anyMatch(("-Denlightenment.launcher=" + launcher)::equals),
                elsewhere::toString);
    }

    @Test
    void argumentsArriveAsTheyWereGiven() throws Exception {
        List<String> given = List.of("render", "a b.json", "*", "", "$HOME", "\"quoted\"", "-o", "c'd.png");
        Packages.Run run = launch(launcher, showing("17.0.1"), given.toArray());
        List<String> lines = run.out().lines().toList();
        assertEquals(given, lines.subList(lines.indexOf("enlightenment.cli.Main") + 1, lines.size()));
        assertFalse(lines.contains("-XX:TieredStopAtLevel=1"));
        assertTrue(lines.contains("-XX:TieredOldPercentage=10000000"), run::toString);
        assertFalse(lines.contains("-XX:+IgnoreUnrecognizedVMOptions"), run::toString);
    }

    @Test
    void aJavaThatIsNewerThanTheLauncherMayLackOptions() throws Exception {
        Packages.Run run = launch(launcher, showing("99"), "render", "x");
        assertTrue(run.out().lines().anyMatch("-XX:+IgnoreUnrecognizedVMOptions"::equals), run::toString);
    }

    @Test
    void rendersHaveACollectorOfTheLaunchersUnlessTheUserChoosesOne() throws Exception {
        String collector = "-XX:+UseParallelGC";
        assertTrue(
                launch(launcher, showing("17.0.1"), "render", "x").out().lines().anyMatch(collector::equals));
        assertFalse(launch(launcher, showing("17.0.1"), "validate", "x")
                .out()
                .lines()
                .anyMatch(collector::equals));
        for (String name : List.of("JAVA_OPTS", "ENLIGHTENMENT_OPTS", "JDK_JAVA_OPTIONS")) {
            Map<String, String> environment = new HashMap<>(showing("17.0.1"));
            environment.put(name, "-Xmx1g -XX:+UseSerialGC");
            Packages.Run run = launch(launcher, environment, "render", "x");
            assertFalse(run.out().lines().anyMatch(collector::equals), run::toString);
        }
    }

    @Test
    void optionsForJavaComeFromTwoVariables() throws Exception {
        Map<String, String> environment = new HashMap<>(showing("17.0.1"));
        environment.put("JAVA_OPTS", "-Xmx1g  -Da=*");
        environment.put("ENLIGHTENMENT_OPTS", "-Xmx2g");
        List<String> lines =
                launch(launcher, environment, "validate", "x").out().lines().toList();
        int at = lines.indexOf("-Xmx1g");
        assertEquals(List.of("-Xmx1g", "-Da=*", "-Xmx2g", "-cp"), lines.subList(at, at + 4));
        assertTrue(lines.contains("-XX:TieredStopAtLevel=1"));
    }

    @Test
    void withoutAJavaThatWillDoItSaysSo() throws Exception {
        Packages.Run old = launch(launcher, showing("11.0.2"), "help");
        assertEquals(1, old.code());
        assertTrue(
                old.err().matches("enlightenment: .*/java is Java 11\\.0\\.2, but .* needs 17 or newer\n"), old.err());
        Packages.Run older = launch(launcher, showing("1.8.0_392"), "help");
        assertTrue(older.err().contains("is Java 1.8.0_392, but"), older.err());
        Packages.Run wrong = launch(launcher, Map.of("JAVA_HOME", folder.toString()), "help");
        assertEquals("enlightenment: JAVA_HOME is " + folder + ", but there is no bin/java in it\n", wrong.err());
        Path tools = Files.createDirectories(folder.resolve("tools"));
        for (String tool : List.of("readlink", "cksum", "ls", "sed", "mkdir")) {
            Path place = Stream.of("/bin", "/usr/bin")
                    .map(bin -> Path.of(bin, tool))
                    .filter(Files::isExecutable)
                    .findFirst()
                    .orElseThrow();
            Path script = Files.writeString(tools.resolve(tool), "#!/bin/sh\nexec " + place + " \"$@\"\n");
            assertTrue(script.toFile().setExecutable(true));
        }
        Packages.Run none = launch(launcher, Map.of("JAVA_HOME", "", "PATH", tools.toString()), "help");
        assertEquals(1, none.code());
        assertTrue(none.err().startsWith("enlightenment: no Java found: install Java 17"), none.err());
    }

    @Test
    void setupMakesAnArchiveThatIsUsedAndBringsTheSamePicture() throws Exception {
        Path archive = setUp();
        Path log = folder.resolve("classes.log");
        assertRenders("with.png", Map.of("ENLIGHTENMENT_OPTS", "-Xlog:class+load:file=" + log.getFileName()));
        String classes = Files.readString(log);
        // An archive lies on top of Java's own, a cache has taken its place.
        assertTrue(
                classes.contains("shared objects file (top)")
                        || classes.contains("enlightenment.cli.Main source: shared objects file"),
                "the archive is used");
        Files.delete(archive);
        assertRenders("without.png", Map.of());
        assertEquals(-1, Files.mismatch(folder.resolve("with.png"), folder.resolve("without.png")));
    }

    @Test
    void anArchiveThatIsBrokenOrForeignIsNobodysBusiness() throws Exception {
        Path archive = setUp();
        byte[] whole = Files.readAllBytes(archive);
        byte[] damaged = whole.clone();
        for (int i = 0; i < 512; i++) {
            damaged[i] ^= 0x55;
        }
        for (byte[] content : List.of(
                new byte[0],
                "no archive".getBytes(StandardCharsets.UTF_8),
                damaged,
                Arrays.copyOf(whole, whole.length / 2))) {
            Files.write(archive, content);
            Packages.Run run = launch(launcher, Map.of(), "validate", Packages.SCENE.toAbsolutePath());
            assertEquals(Packages.SCENE.toAbsolutePath() + ": valid\n", run.out(), run::toString);
            assertEquals("", run.err());
        }
        // The last one, which has its head but not its tail.
        assertRenders("a.png", Map.of());
        Packages.Run again = launch(launcher, Map.of(), "setup");
        assertEquals(0, again.code(), again::toString);
        assertTrue(Files.size(archive) > whole.length / 2, "the archive is made again");
    }

    @Test
    void aCacheThatCannotBeWrittenPreventsNothing() throws Exception {
        Path file = Files.writeString(folder.resolve("file"), "");
        Map<String, String> environment = Map.of("XDG_CACHE_HOME", file.toString());
        Packages.Run run = launch(launcher, environment, "--version");
        assertEquals(0, run.code(), run::toString);
        assertEquals("", run.err());
        Packages.Run setup = launch(launcher, environment, "setup");
        assertEquals(1, setup.code(), setup::toString);
        assertEquals(1, setup.err().lines().count(), setup::toString);
    }

    @Test
    void onlyRenderLetsAJavaThatCanMakeTheArchiveByItself() throws Exception {
        List<String> render =
                launch(launcher, showing("21.0.2"), "render", "x").out().lines().toList();
        assertTrue(render.contains("-XX:+AutoCreateSharedArchive"), render::toString);
        assertTrue(render.stream().anyMatch(l -> l.startsWith("-XX:SharedArchiveFile=" + cache + "/enlightenment/")));
        List<String> help =
                launch(launcher, showing("21.0.2"), "help").out().lines().toList();
        assertFalse(help.contains("-XX:+AutoCreateSharedArchive"), help::toString);
        List<String> seventeen =
                launch(launcher, showing("17.0.1"), "render", "x").out().lines().toList();
        assertFalse(seventeen.contains("-XX:+AutoCreateSharedArchive"), seventeen::toString);
    }

    @Test
    void fromJava25OnTheLauncherUsesACacheOfTheRightLengthAndMakesASimplerArchiveWithoutOne() throws Exception {
        Map<String, String> java = showing("25.0.1");
        List<String> first = launch(launcher, java, "render", "x").out().lines().toList();
        assertTrue(first.contains("-XX:+AutoCreateSharedArchive"), first::toString);
        String place = first.stream()
                .filter(line -> line.startsWith("-Denlightenment.archive="))
                .findFirst()
                .orElseThrow();
        Path archive = Path.of(place.substring(place.indexOf('=') + 1));
        assertTrue(archive.toString().endsWith(".aot"), place);
        Files.writeString(archive, "12345");
        Path size = Files.writeString(Path.of(archive + ".size"), "5\n");
        for (String command : List.of("render", "validate")) {
            List<String> lines =
                    launch(launcher, java, command, "x").out().lines().toList();
            assertTrue(lines.contains("-XX:AOTCache=" + archive), lines::toString);
            assertTrue(lines.stream().noneMatch(line -> line.contains("SharedArchive")), lines::toString);
        }
        Map<String, String> own = new HashMap<>(java);
        own.put("JAVA_OPTS", "-Xshare:off");
        assertFalse(launch(launcher, own, "render", "x").out().contains("-XX:AOTCache"));
        Files.writeString(size, "6\n");
        assertFalse(launch(launcher, java, "render", "x").out().contains("-XX:AOTCache"));
    }

    @Test
    void aVariableForbidsRendersToMakeAnArchive() throws Exception {
        Map<String, String> environment = new HashMap<>(showing("21.0.2"));
        environment.put("ENLIGHTENMENT_NO_ARCHIVE", "1");
        List<String> lines =
                launch(launcher, environment, "render", "x").out().lines().toList();
        assertFalse(lines.contains("-XX:+AutoCreateSharedArchive"), lines::toString);
        assertFalse(Files.exists(cache), "no folder is made");
    }

    @Test
    void rendersOfFewSamplesUseTheQuickCompiler() throws Exception {
        assertTrue(isQuick("--size", "48x24", "--samples", "1"));
        assertTrue(isQuick("--samples=4", "--size=200x200"));
        assertTrue(isQuick("--size", "500x500", "--samples", "1"));
        assertFalse(isQuick("--size", "500x500", "--samples", "2"));
        assertFalse(isQuick("--size", "65536x65536", "--samples", "1"), "2^32 samples");
        assertFalse(isQuick("--size", "48x24"), "the scene file may ask for any number");
        assertFalse(isQuick("--samples", "1"));
        assertFalse(isQuick("--size", "48x24", "--samples", "1", "--error", "0.01"));
        assertFalse(isQuick("--size", "48", "--samples", "x"));
    }

    private boolean isQuick(String... options) throws Exception {
        Packages.Run run = launch(
                launcher,
                showing("17.0.1"),
                Stream.concat(Stream.of("render", "scene.json"), Stream.of(options))
                        .toArray());
        assertEquals(0, run.code(), run::toString);
        assertEquals("", run.err());
        return run.out().lines().anyMatch("-XX:TieredStopAtLevel=1"::equals);
    }

    private static Path archive(Path cache) throws IOException {
        try (Stream<Path> files = Files.list(cache.resolve("enlightenment"))) {
            List<Path> all =
                    files.filter(file -> !file.toString().endsWith(".size")).toList();
            assertEquals(1, all.size(), all::toString);
            return all.get(0);
        }
    }

    private void assertRenders(String picture, Map<String, String> environment) throws Exception {
        Packages.Run run = launch(
                launcher,
                environment,
                "render",
                Packages.SCENE.toAbsolutePath(),
                "--size",
                "16x8",
                "-o",
                picture,
                "--progress",
                "none");
        assertEquals(0, run.code(), run::toString);
        assertEquals("", run.out() + run.err());
    }
}
