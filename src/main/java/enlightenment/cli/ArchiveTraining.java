package enlightenment.cli;

import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import enlightenment.file.WholeFile;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.Shading;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Path;

/**
 * Runs typical commands on a small scene and says nothing: {@link SetupCommand} archives the classes that this loads. It is a
 * program of its own because Java archives what one process has loaded when it ends.
 */
public final class ArchiveTraining {
    private static final String SCENE =
            """
            {
              "image": { "width": 8, "height": 8 },
              "camera": { "type": "perspective", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "up": [0, 1, 0], "fieldOfView": 40 },
              "textures": { "checks": { "type": "checker", "colors": ["#ffffff", "#808080"], "scale": 4 } },
              "materials": {
                "white": { "type": "matte", "color": { "texture": "checks" } },
                "mirror": { "type": "mirror", "color": "#ffffff" },
                "glass": { "type": "glass", "color": "#ffffff", "indexOfRefraction": 1.5 }
              },
              "lights": [ { "type": "sphere", "center": [2, 3, -2], "radius": 0.5, "color": "#ffffff" } ],
              "objects": [
                { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "mirror" },
                { "type": "sphere", "center": [-1, 0, -2], "radius": 0.3, "material": "glass" },
                { "type": "sphere", "center": [0, -101, 0], "radius": 100, "material": "white" }
              ]
            }
            """;

    private ArchiveTraining() {}

    /**
     * Runs the commands.
     *
     * @param args a folder for their files
     */
    public static void main(String[] args) throws IOException {
        Path folder = Path.of(args[0]);
        String scene = folder.resolve("training.json").toString();
        String first = folder.resolve("a.png").toString();
        String second = folder.resolve("b.png").toString();
        WholeFile.write(Path.of(scene), SCENE);
        int worst = 0;
        String physical = folder.resolve("physical.json").toString();
        WholeFile.write(Path.of(physical), SCENE.replaceFirst("\\{", "{ \"shading\": { \"model\": \"physical\" },"));
        for (Method method : BuiltInMethod.rendering(Shading.Model.PHYSICAL)) {
            worst = Math.max(worst, render(physical, second, method));
        }
        for (Method method : BuiltInMethod.rendering(Shading.Model.CLASSIC)) {
            worst = Math.max(worst, render(scene, second, method));
        }
        for (String[] command : new String[][] {
            {"render", scene, "-o", first, "--stats", "--progress", "plain"},
            {"compare", first, second},
            {"validate", scene},
            {"inspect", scene},
            {"schema"},
            {"help"},
            {"--version"}
        }) {
            worst = Math.max(worst, run(command));
        }
        System.exit(worst);
    }

    private static int render(String scene, String picture, Method method) {
        return run("render", scene, "-o", picture, "--method", method.word(), "--samples", "4", "--progress", "none");
    }

    private static int run(String... command) {
        PrintStream nowhere = new PrintStream(OutputStream.nullOutputStream());
        return Main.run(command, new Terminal(InputStream.nullInputStream(), nowhere, nowhere, new ShutdownSignal()));
    }
}
