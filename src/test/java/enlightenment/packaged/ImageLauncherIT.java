package enlightenment.packaged;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The launcher where a Java lies beside it, as in an image of the application. */
@DisabledOnOs(OS.WINDOWS)
class ImageLauncherIT {
    private static final String SHOWING_JAVA =
            """
            #!/bin/sh
            printf '%s\\n' "$0" "$@"
            """;

    @TempDir
    Path folder;

    private Path home;

    @BeforeEach
    void unpack() throws IOException {
        home = UnpackedZip.into(folder.toRealPath());
    }

    /** A Java that is none, of some version; its lines are its own path and the arguments that it was started with. */
    private void bringJava(String version) throws IOException {
        Path java = Files.createDirectories(home.resolve("runtime/bin")).resolve("java");
        Files.writeString(java, SHOWING_JAVA);
        assertTrue(java.toFile().setExecutable(true));
        Files.writeString(home.resolve("runtime/release"), "JAVA_VERSION=\"" + version + "\"\n");
    }

    private void bringArchive(String name, int length, int told) throws IOException {
        Files.writeString(home.resolve("lib").resolve(name), "x".repeat(length));
        Files.writeString(home.resolve("lib").resolve(name + ".size"), told + "\n");
    }

    private List<String> launched(String command) throws IOException, InterruptedException {
        Map<String, String> environment = Map.of(
                "JAVA_HOME",
                folder.resolve("of another").toString(),
                "XDG_CACHE_HOME",
                folder.resolve("cache").toString());
        Packages.Run run = Packages.run(folder, environment, home.resolve("bin/enlightenment"), command);
        assertEquals(0, run.code(), run::toString);
        return run.out().lines().toList();
    }

    @Test
    void itsOwnJavaIsStartedWhateverTheEnvironmentSays() throws Exception {
        bringJava("21.0.2");
        assertEquals(
                home.resolve("runtime/bin/java").toString(), launched("help").get(0));
    }

    @Test
    void itStartsFromTheArchiveThatItBrings() throws Exception {
        bringJava("21.0.2");
        bringArchive("enlightenment.jsa", 5, 5);
        List<String> lines = launched("render");
        Path archive = home.resolve("lib/enlightenment.jsa");
        assertTrue(lines.contains("-XX:SharedArchiveFile=" + archive), lines::toString);
        assertFalse(lines.contains("-XX:+AutoCreateSharedArchive"), lines::toString);
        assertTrue(lines.contains("-Denlightenment.archive=" + archive), lines::toString);
        assertFalse(Files.exists(folder.resolve("cache")));
    }

    @Test
    void fromJava25OnTheArchiveIsACache() throws Exception {
        bringJava("25.0.1");
        bringArchive("enlightenment.aot", 5, 5);
        List<String> lines = launched("validate");
        assertTrue(lines.contains("-XX:AOTCache=" + home.resolve("lib/enlightenment.aot")), lines::toString);
    }

    @Test
    void anArchiveOfAnotherLengthIsNotUsed() throws Exception {
        bringJava("25.0.1");
        bringArchive("enlightenment.aot", 4, 5);
        List<String> lines = launched("validate");
        assertFalse(lines.stream().anyMatch(line -> line.startsWith("-XX:AOTCache")), lines::toString);
    }
}
