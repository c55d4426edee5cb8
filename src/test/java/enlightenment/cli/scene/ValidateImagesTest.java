package enlightenment.cli.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.color.Color;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Image files that begin as such and cannot be read. */
class ValidateImagesTest {
    @TempDir
    Path folder;

    @Test
    void whatElseIsWrongIsToldWithThem() throws IOException {
        Files.write(folder.resolve("half.png"), Arrays.copyOf(png(), 60));
        Path scene = Files.writeString(
                folder.resolve("late.json"),
                """
                { "image": { "width": 8, "height": 6 },
                  "camera": { "type": "perspective", "eye": [0, 0, 0], "lookAt": [0, 0, 1], "fieldOfView": 40 },
                  "render": { "method": "light" },
                  "textures": { "a": { "file": "half.png" } },
                  "objects": [ { "type": "sphere", "center": [0, 0, 5], "radius": 1,
                                 "material": { "type": "matte", "color": { "texture": "a" } } } ] }
                """);
        CliRun run = CliRun.of("validate", scene);
        assertEquals(2, run.code());
        assertEquals(2, run.errLines().size(), run.err());
        assertTrue(run.errLines().get(0).startsWith(scene + ":4:32: /textures/a/file: cannot read "), run.err());
        assertTrue(
                run.errLines().get(1).startsWith(scene + ":1:1: /shading/model: the method light cannot"), run.err());
    }

    private byte[] png() throws IOException {
        Path image = folder.resolve("image.png");
        ImageFiles.writePng(new Image(4, 4, new float[48], Color.Encoding.DISPLAY), image);
        return Files.readAllBytes(image);
    }

    /** A render ends at the first. */
    @Test
    void allImagesThatCannotBeReadAreToldWithTheirTextures() throws IOException {
        Path image = folder.resolve("whole.png");
        ImageFiles.writePng(new Image(4, 4, new float[48], Color.Encoding.DISPLAY), image);
        byte[] bytes = Files.readAllBytes(image);
        Files.write(folder.resolve("half.png"), Arrays.copyOf(bytes, bytes.length / 2));
        Files.write(folder.resolve("most.png"), Arrays.copyOf(bytes, bytes.length * 3 / 4));
        Path scene = CliRun.scene(folder, "\"width\": 16, \"height\": 12");
        String text = Files.readString(scene);
        String textures =
                "\"a\": { \"file\": \"half.png\" }, \"b\": { \"file\": \"whole.png\" }, \"c~/d\": { \"file\": \"most.png\" }";
        Files.writeString(scene, text.substring(0, text.lastIndexOf('}')) + ", \"textures\": {" + textures + "}}");
        CliRun run = CliRun.of("validate", scene);
        assertEquals(2, run.code());
        assertEquals(2, run.errLines().size(), run.err());
        assertTrue(
                run.errLines().get(0).matches("(?s)\\Q" + scene + "\\E:\\d+:\\d+: /textures/a/file: cannot read .*"),
                run.err());
        assertTrue(
                run.errLines()
                        .get(1)
                        .matches("(?s)\\Q" + scene + "\\E:\\d+:\\d+: /textures/c~0~1d/file: cannot read .*"),
                run.err());
    }
}
