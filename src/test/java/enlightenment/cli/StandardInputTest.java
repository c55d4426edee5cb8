package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import enlightenment.process.JavaProcess;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A file that standard input reads is an input like any other: nothing is written over it, by whatever name. */
@Timeout(120)
class StandardInputTest {
    @TempDir
    Path folder;

    private record Run(int code, String err) {}

    private Run run(Path in, Object... args) throws IOException, InterruptedException {
        Path err = folder.resolve("err.txt");
        Process process = JavaProcess.of(Main.class, args)
                .redirectInput(in.toFile())
                .redirectError(err.toFile())
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .start();
        assertTrue(process.waitFor(100, TimeUnit.SECONDS));
        return new Run(process.exitValue(), Files.readString(err, StandardCharsets.UTF_8));
    }

    private Path scene() throws IOException {
        assumeTrue(Files.exists(Path.of("/proc/self/fd/0")), "a system that names descriptors");
        return Files.copy(Path.of("scenes/cone.json"), folder.resolve("c.json"));
    }

    private void refused(Path in, Path written, Object... args) throws IOException, InterruptedException {
        byte[] before = Files.readAllBytes(in);
        Run run = run(in, args);
        assertEquals(2, run.code, run.err);
        assertTrue(run.err.contains("would write over"), run.err);
        assertTrue(run.err.contains("\"" + written + "\", which standard input reads"), run.err);
        assertArrayEquals(before, Files.readAllBytes(in));
    }

    @ParameterizedTest
    @ValueSource(strings = {"--report", "--checkpoint"})
    void noOptionWritesOverTheSceneOnStandardInput(String option) throws Exception {
        Path scene = scene();
        refused(scene, scene, "render", "-", "-o", folder.resolve("n.png"), "--size", "8x8", option, scene);
    }

    @Test
    void aPictureThatIsALinkToTheSceneOnStandardInputIsRefused() throws Exception {
        Path link = Files.createSymbolicLink(folder.resolve("pl.png"), scene());
        refused(folder.resolve("c.json"), link, "render", "-", "-o", link, "--size", "8x8");
    }

    @Test
    void aHardLinkIsTheSameFile() throws Exception {
        Path link = Files.createLink(folder.resolve("h.png"), scene());
        refused(folder.resolve("c.json"), link, "render", "-", "-o", link, "--size", "8x8");
    }

    @Test
    void convertDoesNotWriteOverWhatItReads() throws Exception {
        scene();
        Path nff = folder.resolve("a.nff");
        Files.write(
                nff,
                List.of(
                        "b 0 0 0",
                        "v",
                        "from 0 -5 0",
                        "at 0 0 0",
                        "up 0 0 1",
                        "angle 40",
                        "hither 1",
                        "resolution 8 8",
                        "f 1 1 1 1 0 0 0 0",
                        "s 0 0 0 1"));
        Path link = Files.createSymbolicLink(folder.resolve("b.json"), nff);
        refused(nff, link, "convert", "-", link);
    }

    @Test
    void whatStandardInputReadsMayBeReadByOtherOptionsToo() throws Exception {
        Path scene = scene();
        Path picture = folder.resolve("n.png");
        Run run = run(scene, "render", "-", "-o", picture, "--size", "8x8");
        assertEquals(0, run.code, run.err);
        assertTrue(Files.size(picture) > 0);
    }

    @Test
    void closedStandardInputIsCalledClosed() throws Exception {
        scene();
        List<String> command = JavaProcess.of(Main.class, "render", "-", "-o", folder.resolve("n.png"))
                .command();
        StringBuilder quoted = new StringBuilder("exec ");
        command.forEach(word -> quoted.append('\'').append(word).append("' "));
        Path err = folder.resolve("err.txt");
        Process process = new ProcessBuilder("sh", "-c", quoted + "<&-")
                .redirectError(err.toFile())
                .start();
        assertTrue(process.waitFor(100, TimeUnit.SECONDS));
        assertEquals("enlightenment: cannot read standard input: it is closed\n", Files.readString(err));
        assertEquals(1, process.exitValue());
    }
}
