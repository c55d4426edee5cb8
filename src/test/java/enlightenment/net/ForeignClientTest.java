package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.job.Build;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * docs/notes/distributed-protocol.md is enough to write a client from: {@code client.py} was. Its units are made from a picture that was
 * rendered before, and the server makes the same picture of them.
 */
@Timeout(600)
class ForeignClientTest {
    @TempDir
    Path folder;

    private static boolean hasPython() {
        try {
            Process process =
                    new ProcessBuilder("python3", "-c", "import sys; sys.exit(sys.version_info < (3, 7))").start();
            return process.waitFor(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS) && process.exitValue() == 0;
        } catch (IOException | InterruptedException e) {
            return false;
        }
    }

    private Process client(int port, String token, Path picture) throws IOException {
        Path script = folder.resolve("client.py");
        Files.copy(ForeignClientTest.class.getResourceAsStream("/net/client.py"), script);
        ProcessBuilder builder = new ProcessBuilder(
                "python3", script.toString(), "127.0.0.1", Integer.toString(port), token, picture.toString());
        builder.environment().put("ENLIGHTENMENT_BUILD", Build.number());
        return builder.redirectErrorStream(true)
                .redirectOutput(folder.resolve("said").toFile())
                .start();
    }

    /** A client joins that makes all units of a picture, which is the same then. */
    private void check(Scene scene, RenderSettings settings, Image alone, ServerOptions.Builder options, String token)
            throws Exception {
        Path picture = folder.resolve("picture.pfm");
        ImageFiles.writePfm(alone, picture);
        try (Farm farm = new Farm(scene, settings, options.awaitWorkers(1, 10_000)).begin()) {
            Process client = client(farm.server.port(), token, picture);
            Farm.until(() -> farm.server.round().snapshot().finished() || !client.isAlive(), "it has ended");
            assertTrue(client.waitFor(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS));
            String said = Files.readString(folder.resolve("said"));
            assertEquals(0, client.exitValue(), said);
            RenderResult result = farm.result();
            assertTrue(result.complete());
            assertArrayEquals(alone.toArray(), result.image().toArray());
            assertArrayEquals(Farm.png(alone), Farm.png(result.image()));
            assertTrue(said.contains(farm.server.round().job().tiles() + " tiles made: the picture is done"), said);
            assertTrue(farm.logHas("python (127.0.0.1) joined"), farm.log.toString());
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theTilesOfAClientInAnotherLanguageMakeThePicture(boolean isCropped) throws Exception {
        assumeTrue(hasPython(), "no python3 on the path");
        RenderSettings settings = isCropped
                ? Farm.SETTINGS.withMethod(Method.CLUSTER).withCrop(new RenderSettings.Crop(9, 3, 50, 30))
                : Farm.SETTINGS;
        Path token = Files.writeString(folder.resolve("token"), " 0123456789abcdef\n");
        check(
                Farm.SCENE,
                settings,
                Renderer.render(Farm.SCENE, settings),
                isCropped ? Farm.options() : Farm.options().tokenFile(token),
                isCropped ? "-" : token.toString());
    }

    /** Where there are no tiles, a client needs the unit of the sums, which it cannot know without the scene. */
    @ParameterizedTest
    @EnumSource(value = UnitKindsTest.Kind.class, mode = EnumSource.Mode.EXCLUDE, names = "BATCHES")
    void soDoItsPassesBatchesAndTilesOfLinearLight(UnitKindsTest.Kind kind) throws Exception {
        assumeTrue(hasPython(), "no python3 on the path");
        check(kind.scene, kind.settings, kind.alone.image(), Farm.options(), "-");
    }
}
