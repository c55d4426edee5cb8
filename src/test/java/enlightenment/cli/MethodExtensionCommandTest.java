package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.toy.AmbientOcclusion;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.lang.reflect.Method;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A method that only the tests have is known to the command line, and refused for a shading that it does not render. */
class MethodExtensionCommandTest {
    @TempDir
    Path folder;

    private Path classic;
    private Path physical;

    @BeforeEach
    void scenes() throws IOException {
        classic = write("classic.json", "\"render\": {}");
        physical = write(
                "physical.json",
                "\"shading\": { \"model\": \"physical\" }, \"render\": { \"method\": \"" + AmbientOcclusion.WORD
                        + "\" }");
    }

    private Path write(String name, String parts) throws IOException {
        return Files.writeString(
                folder.resolve(name),
                "{ \"image\": { \"width\": 8, \"height\": 4 }, \"objects\": [], " + parts
                        + ", \"camera\": { \"type\": \"perspective\", \"eye\": [0, 0, -5], \"lookAt\": [0, 0, 0],"
                        + " \"fieldOfView\": 40 } }");
    }

    @Test
    void inspectTellsTheMethodAndItsSettings() {
        CliRun run = CliRun.of("inspect", classic, "--method", "toy", "--toy-rays", "5", "--toy-shape=square");
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().contains("toy: a toy that only the tests have"), run.out());
        assertTrue(run.out().contains("toyRays=5: rays of the toy per hit"), run.out());
        assertTrue(run.out().contains("method=toy size=8x4 antialias=4 toyRays=5 toyShape=square seed=0"), run.out());
        assertFalse(run.out().contains("shadowSamples"), run.out());
        CliRun ours = CliRun.of("inspect", classic);
        assertTrue(ours.out().contains("shadowSamples=10: light samples per hit and light"), ours.out());
        assertFalse(ours.out().contains("toy"), ours.out());
    }

    @Test
    void itsOptionsAreCheckedAndToldAsOurs() {
        CliRun run = CliRun.of("inspect", classic, "--toy-rays", "65");
        assertEquals(2, run.code());
        assertTrue(run.err().contains("--toy-rays must be a whole number in 1..64, not \"65\""), run.err());
        run = CliRun.of("inspect", classic, "--toy-shape", "flat");
        assertTrue(run.err().contains("--toy-shape must be one of round, square, not \"flat\""), run.err());
        run = CliRun.of("render", "--help");
        assertTrue(run.out().contains("--toy-rays=N"), run.out());
        assertTrue(
                run.out()
                        .replaceAll("\\s+", " ")
                        .contains(String.join(
                                ", ", enlightenment.scene.Method.words(enlightenment.scene.Method.selectable()))),
                run.out());
        assertTrue(CliRun.of("completion").out().contains("toy-shape"));
        run = CliRun.of("inspect", classic, "--method", "toys");
        assertTrue(
                run.err()
                        .contains("--method must be one of "
                                + String.join(
                                        ", ",
                                        enlightenment.scene.Method.words(enlightenment.scene.Method.selectable()))),
                run.err());
    }

    @ParameterizedTest
    @ValueSource(strings = {"render", "inspect", "validate", "part", "server", "trade"})
    void aShadingThatTheMethodCannotRenderIsRefusedByName(String command) throws IOException {
        // The scene is one line.
        String place = ":1:" + (Files.readString(physical).indexOf("\"physical\"") + 1);
        Path out = folder.resolve("out");
        CliRun run =
                switch (command) {
                    case "render" -> CliRun.of("render", physical, "-o", out + ".png");
                    case "part" -> CliRun.of("render", physical, "-o", out + ".film", "--part", "1/2");
                    case "server" -> CliRun.of("server", physical, "-o", out + ".png", "--port", "0");
                    case "trade" ->
                        CliRun.of("trade", physical, "-o", out, "--budget", "1", "--methods", AmbientOcclusion.WORD);
                    default -> CliRun.of(command, physical);
                };
        assertEquals(2, run.code(), run.err());
        String all = run.out() + run.err();
        assertTrue(
                all.contains(physical + place + ": /shading/model: the method " + AmbientOcclusion.WORD
                        + " cannot render physical shading, only"
                        + " classic; what can: "),
                all);
        assertFalse(Files.exists(out), "no folder of a trade that cannot be");
    }

    /** Loads the program's classes anew, and tells which it has loaded. */
    private static final class Fresh extends URLClassLoader {
        Fresh() {
            super(
                    new URL[] {Main.class.getProtectionDomain().getCodeSource().getLocation()},
                    Main.class.getClassLoader());
        }

        @Override
        protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
            synchronized (getClassLoadingLock(name)) {
                Class<?> loaded = findLoadedClass(name);
                boolean own = loaded == null && name.startsWith("enlightenment.");
                return own ? findClass(name) : loaded != null ? loaded : super.loadClass(name, resolve);
            }
        }

        boolean looked() {
            return findLoadedClass("enlightenment.scene.Extensions") != null;
        }

        int run(Object... words) throws Exception {
            Method main = loadClass("enlightenment.cli.Main", true)
                    .getDeclaredMethod("run", String[].class, PrintStream.class, PrintStream.class);
            main.setAccessible(true);
            String[] args = Stream.of(words).map(Object::toString).toArray(String[]::new);
            PrintStream nowhere = new PrintStream(OutputStream.nullOutputStream());
            return (int) main.invoke(null, args, nowhere, nowhere);
        }
    }

    @Test
    void whoNeedsNoneOfTheMethodsFromOutsideDoesNotPayForTheSearch() throws Exception {
        Path out = folder.resolve("a.png");
        try (Fresh fresh = new Fresh()) {
            assertEquals(0, fresh.run("validate", classic));
            assertEquals(0, fresh.run("render", classic, "-o", out, "--method", "raytrace", "--shadow-samples", "2"));
            assertEquals(
                    0, fresh.run("render", classic, "-o", out, "--method=cluster", "--proposal=zeta", "--samples=3"));
            assertFalse(fresh.looked());
            assertEquals(2, fresh.run("inspect", classic, "--method", "no-such-method"));
            assertTrue(fresh.looked());
        }
    }

    @Test
    void aMethodThatCanRenderAShadingIsNotRefused() {
        CliRun run = CliRun.of("inspect", physical, "--method", "toy");
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().contains("method=toy"), run.out());
    }
}
