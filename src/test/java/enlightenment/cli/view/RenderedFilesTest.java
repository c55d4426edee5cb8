package enlightenment.cli.view;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.cli.CliRun;
import enlightenment.cli.input.ForeignOptions;
import enlightenment.cli.input.FrameOption;
import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import enlightenment.listen.ServerLog;
import enlightenment.view.LiveView;
import enlightenment.view.ViewClient;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The files that a view gives are byte by byte those that the command {@code render} writes. */
@Timeout(600)
class RenderedFilesTest {
    private static final String SCENE =
            """
            {
              "name": "Ball",
              "image": { "width": 16, "height": 12 },
              "camera": { "type": "perspective", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "fieldOfView": 40 },
              "shading": { "model": "physical" },
              "display": { "exposure": 0 },
              "lights": [ { "type": "sphere", "center": [2, 3, -2], "radius": 0.5, "color": "#ffffff", "power": 100 } ],
              "objects": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1,
                             "material": { "type": "matte", "color": "#ffffff" } } ],
              "animation": { "frames": 3, "framesPerSecond": 8,
                             "tracks": [ { "target": "/objects/0/center/0", "keys": { "0": 0, "2": 1 } } ] }
            }
            """;

    @TempDir
    private Path folder;

    @Test
    void aViewGivesWhatTheCommandWrites() throws Exception {
        Path scene = Files.writeString(folder.resolve("scene.json"), SCENE);
        PrintStream silent = new PrintStream(OutputStream.nullOutputStream(), true, StandardCharsets.UTF_8);
        Terminal terminal = new Terminal(silent, silent, new ShutdownSignal());
        ViewedFile source = new ViewedFile(scene, new ForeignOptions(), new FrameOption(), terminal);
        LiveView.Options options = new LiveView.Options("scene.json", 0, 2, 1);
        ServerLog log = new ServerLog(line -> {}, System::nanoTime);
        try (LiveView view = LiveView.start(source, new RenderedFiles(), options, log)) {
            ViewClient client = new ViewClient(view.address());
            client.act("action=orbit&x=15&y=5");
            client.act("action=exposure&x=1.5");
            assertEquals(200, client.act("action=save").code());
            compare(scene, client, "samples=3&width=20&height=15", "--samples", "3", "--size", "20x15");
            assertEquals(200, client.act("action=frame&x=2").code());
            compare(scene, client, "method=bidirectional", "--method", "bidirectional", "--frame", "2");
            compare(scene, client, "method=auto&samples=2", "--method", "auto", "--samples", "2", "--frame", "2");
        }
    }

    private void compare(Path scene, ViewClient client, String order, String... options) throws Exception {
        assertEquals(200, client.act("action=render&" + order).code());
        client.awaitRender("done");
        for (String kind : new String[] {"png", "exr"}) {
            Path file = folder.resolve("picture." + kind);
            Object[] command = new Object[options.length + 4];
            command[0] = "render";
            command[1] = scene;
            command[2] = "-o";
            command[3] = file;
            System.arraycopy(options, 0, command, 4, options.length);
            CliRun run = CliRun.of(command);
            assertEquals(0, run.code(), run.err());
            assertArrayEquals(
                    Files.readAllBytes(file), client.get("render." + kind, "").body(), kind + " of " + order);
        }
    }
}
