package enlightenment.cli.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.SceneFixture;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The line that says which file was written. */
class WrittenFileLineTest extends SceneFixture {
    WrittenFileLineTest() {
        super(8, 6);
    }

    @ParameterizedTest
    @ValueSource(strings = {"auto", "plain"})
    void whereNoTerminalIsTheFileIsNamedToo(String progress) {
        CliRun run = render("--progress", progress);
        assertEquals(0, run.code());
        assertEquals("", run.out());
        assertTrue(run.errLines().contains("enlightenment: wrote " + picture), run.err());
    }

    @Test
    void aPartIsNamed() {
        Path part = folder.resolve("1.film");
        CliRun run = CliRun.of("render", scene, "-o", part, "--part", "1/2", "--progress", "plain");
        assertTrue(run.errLines().contains("enlightenment: wrote " + part), run.err());
    }

    @Test
    void withoutProgressNothingIsSaid() {
        assertEquals(new CliRun(0, "", ""), render("--progress", "none"));
    }

    @Test
    void standardOutputIsNoFileToBeNamed() {
        assertEquals(
                "", CliRun.of("render", scene, "-o", "-", "--progress", "plain").err());
    }

    @Test
    void whatIsNotWrittenIsNotNamed() {
        picture = folder.resolve("missing").resolve("p.png");
        CliRun run = render("--progress", "plain");
        assertEquals(1, run.code());
        assertTrue(!run.err().contains("wrote"), run.err());
    }
}
