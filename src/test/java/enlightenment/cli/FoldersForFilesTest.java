package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import enlightenment.cli.terminal.ExitCode;
import enlightenment.file.NamedPipe;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Folders, and devices without an end, where files are expected. */
@Timeout(600)
class FoldersForFilesTest {
    private static final Path ZERO = Path.of("/dev/zero");

    @TempDir
    Path folder;

    private Path wrong;
    private Path scene;
    private Path out;

    @BeforeEach
    void files() throws IOException {
        wrong = Files.createDirectory(folder.resolve("wrong"));
        scene = CliRun.scene(folder, "\"width\": 8, \"height\": 8");
        out = folder.resolve("o.png");
    }

    private static void assertTold(int code, String message, Object... args) {
        CliRun run = CliRun.of(args);
        assertEquals(List.of("enlightenment: " + message), run.errLines());
        assertEquals(code, run.code());
    }

    private void assertFolderTold(Object... args) {
        assertTold(ExitCode.FAILED, wrong + ": it is a folder", args);
    }

    private Object[] server(Object... more) {
        List<Object> all = new ArrayList<>(List.of("server", scene, "-o", out));
        all.addAll(List.of(more));
        return all.toArray();
    }

    private static Object[] worker(Object... more) {
        List<Object> all = new ArrayList<>(List.of("worker", "127.0.0.1:1", "--reconnect", 0));
        all.addAll(List.of(more));
        return all.toArray();
    }

    private Path resource(String name) throws IOException {
        Path file = folder.resolve(name);
        Files.copy(FoldersForFilesTest.class.getResourceAsStream("/net/" + name), file);
        return file;
    }

    @Test
    void anEmptyNameIsNoFolderButAnEmptyName() {
        assertTold(ExitCode.WRONG_INPUT, "SCENE must not be empty", "render", "", "-o", out);
        assertTold(ExitCode.WRONG_INPUT, "SCENE must not be empty", "validate", scene, "");
        assertTold(ExitCode.WRONG_INPUT, "B must not be empty", "compare", out, "");
        assertTold(ExitCode.WRONG_INPUT, "--report must not be empty", "render", scene, "-o", out, "--report", "");
    }

    @Test
    void whatIsNoPathIsToldAsSuch() {
        assertTold(ExitCode.WRONG_INPUT, "SCENE is not a path: \"a?b.json\"", "validate", "a\0b.json");
        assertTold(ExitCode.WRONG_INPUT, "--output is not a path: \"a?b.png\"", "render", scene, "-o", "a\0b.png");
    }

    @Test
    void aFolderIsToldByItsNameWhereverAFileIsExpected() throws IOException {
        Path certificate = resource("server-cert.pem");
        Path key = resource("server-key.pem");
        assertFolderTold("merge", wrong, "-o", out);
        assertFolderTold(server("--token-file", wrong));
        assertFolderTold(worker("--token-file", wrong));
        assertFolderTold(worker("--tls-ca", wrong));
        assertFolderTold(server("--tls", wrong));
        assertFolderTold(server("--tls-cert", wrong, "--tls-key", key));
        assertFolderTold(server("--tls-cert", certificate, "--tls-key", wrong));
        assertFolderTold("store-info", folder.resolve("s.sqlite"), "--store-password-file", wrong);
        assertTold(ExitCode.WRONG_INPUT, wrong + ": it is a folder", "convert", wrong, folder.resolve("x.json"));
    }

    @Test
    void aDeviceWithoutAnEndIsNotReadWithoutEnd() throws IOException {
        assumeTrue(Files.exists(ZERO));
        String device = "/dev/zero: it is a device, and what it gives may have no end";
        assertTold(ExitCode.FAILED, "/dev/zero: is longer than any token", worker("--token-file", ZERO));
        assertTold(ExitCode.FAILED, "/dev/zero: is longer than any token", server("--token-file", ZERO));
        assertTold(ExitCode.FAILED, device, worker("--tls-ca", ZERO));
        assertTold(ExitCode.WRONG_INPUT, device, "convert", ZERO, folder.resolve("x.json"));
        CliRun.picture("render", scene, "-o", out);
        assertTold(
                ExitCode.WRONG_INPUT,
                "cannot read /dev/zero: it is a device, and what it gives may have no end",
                "compare",
                out,
                ZERO);
    }

    @Test
    void pipesAreReadAsFilesAre() throws Exception {
        CliRun.picture("render", scene, "-o", out);
        Path pipe = folder.resolve("pipe.png");
        NamedPipe.writing(pipe, Files.readAllBytes(out));
        CliRun run = CliRun.of("compare", pipe, out, "--max-rmse", 0);
        assertEquals(0, run.code(), run.err());
    }
}
