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
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * docs/distributed-protocol.md is enough to write a client from: {@code client.py} was. Its tiles are cut from a picture that was
 * rendered before, and the server makes the same picture of them.
 */
@Timeout(300)
class ForeignClientTest {
    @TempDir
    Path folder;

    private static boolean hasPython() {
        try {
            Process process =
                    new ProcessBuilder("python3", "-c", "import sys; sys.exit(sys.version_info < (3, 7))").start();
            return process.waitFor(60, TimeUnit.SECONDS) && process.exitValue() == 0;
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

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theTilesOfAClientInAnotherLanguageMakeThePicture(boolean isCropped) throws Exception {
        assumeTrue(hasPython(), "no python3 on the path");
        RenderSettings settings = isCropped
                ? Farm.SETTINGS.withMethod(Method.CLUSTER).withCrop(new RenderSettings.Crop(9, 3, 50, 30))
                : Farm.SETTINGS;
        Image alone = Renderer.render(Farm.SCENE, settings);
        Path picture = folder.resolve("picture.pfm");
        ImageFiles.writePfm(alone, picture);
        Path token = Files.writeString(folder.resolve("token"), " 0123456789abcdef\n");
        ServerOptions.Builder options = Farm.options().awaitWorkers(1, 10_000);
        options = isCropped ? options : options.tokenFile(token);
        try (Farm farm = new Farm(Farm.SCENE, settings, options).begin()) {
            Process client = client(farm.server.port(), isCropped ? "-" : token.toString(), picture);
            Farm.until(() -> farm.server.round().snapshot().finished() || !client.isAlive(), "it has ended");
            assertTrue(client.waitFor(60, TimeUnit.SECONDS));
            String said = Files.readString(folder.resolve("said"));
            assertEquals(0, client.exitValue(), said);
            RenderResult result = farm.result();
            assertTrue(result.complete());
            assertArrayEquals(Farm.png(alone), Farm.png(result.image()));
            assertTrue(said.contains(farm.server.round().job().tiles() + " tiles made: the picture is done"), said);
            assertTrue(farm.logHas("python (127.0.0.1) joined"), farm.log.toString());
        }
    }
}
