package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Color;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is seen only when a scene is put together has file, line and place, as what is wrong with its text. */
class LatePlacesTest {
    /** Stands before the value that is to blame. */
    private static final String BLAME = "¤";

    private static final String BALL =
            "{ 'type': 'sphere', 'center': [0, 0, 0], 'radius': 1, 'material': { 'type': 'matte', 'color': '#888' } }";

    @TempDir
    Path folder;

    private static String marked(String parts) {
        return ("{ 'image': { 'width': 8, 'height': 8 },\n  'camera': { 'type': 'perspective', 'eye': [0, 0, -5],"
                        + " 'lookAt': [0, 0, 0], 'fieldOfView': 40 },\n" + parts.replace("BALL", BALL) + "\n}")
                .replace('\'', '"');
    }

    /** "line:column" of the value to blame. */
    private static String place(String marked) {
        String before = marked.substring(0, marked.indexOf(BLAME));
        return 1 + before.chars().filter(c -> c == '\n').count() + ":" + (before.length() - before.lastIndexOf('\n'));
    }

    @Test
    void ofWhatIsTooFarAway() throws IOException {
        String objects = "'shading': { 'model': 'physical' }, 'objects': [BALL,\n BALL,\n ¤{ 'type': 'sphere',"
                + " 'center': [0, 1e200, 0], 'radius': 1, 'material': { 'type': 'matte', 'color': '#888' } }, BALL]";
        assertTold(marked(objects), "/objects/2", "times as far");
    }

    @Test
    void ofLightsThatAreTooSmall() throws IOException {
        String lights = "'lights': [{ 'type': 'point', 'position': [0, 3, 0], 'color': '#fff',\n 'power': 1 },"
                + " { 'type': 'sphere', 'center': [0, 3, 0], 'color': '#fff', 'radius': 1e-60,\n 'power': ¤1e60 }]";
        assertTold(
                marked("'shading': { 'model': 'physical' }, 'objects': [BALL],\n" + lights),
                "/lights/1/power",
                "too much for a light of this size");
    }

    @Test
    void ofSkiesThatAreTooBright() throws IOException {
        String sky = "'background': { 'type': 'sky',\n 'elevation': 30, 'radiance': ¤[1, 1, 1e60] }";
        assertTold(
                marked("'shading': { 'model': 'physical', " + sky + " },\n 'objects': [BALL]"),
                "/shading/background/radiance",
                "beyond the range of floats");
    }

    private void assertTold(String marked, String pointer, String words) throws IOException {
        Path scene = Files.writeString(folder.resolve("scene.json"), marked.replace(BLAME, ""));
        List<List<Object>> commands = List.of(
                List.of("validate", scene),
                List.of("inspect", scene),
                List.of("render", scene, "--part", "1/2", "-o", folder.resolve("x.film"), "--progress", "none"),
                List.of("render", scene, "-o", folder.resolve("x.png"), "--progress", "none"));
        for (List<Object> command : commands) {
            CliRun run = CliRun.of(command.toArray());
            assertEquals(2, run.code(), run.err());
            assertEquals(1, run.errLines().size(), run.err());
            assertTrue(run.err().startsWith(scene + ":" + place(marked) + ": " + pointer + ": "), run.err());
            assertTrue(run.err().contains(words), run.err());
        }
    }

    @Test
    void ofTexturesThatAreDamaged() throws IOException {
        Path image = folder.resolve("whole.png");
        ImageFiles.writePng(new Image(4, 4, new float[48], Color.Encoding.DISPLAY), image);
        Files.write(folder.resolve("half.png"), Arrays.copyOf(Files.readAllBytes(image), 60));
        String textures =
                "'textures': { 'plain': { 'type': 'color', 'color': '#fff' },\n 'c~/d': { 'file': ¤'half.png' } },"
                        + " 'objects': [ { 'type': 'sphere', 'center': [0, 0, 0], 'radius': 1, 'material': { 'type': 'matte',"
                        + " 'color': { 'texture': 'c~/d' } } } ]";
        assertTold(marked(textures), "/textures/c~0~1d/file", "cannot read ");
        assertTold(marked("'shading': { 'model': 'physical' }," + textures), "/textures/c~0~1d/file", "cannot read ");
    }

    /** The frame's own numbers do not stand in the file, but what they replace does. */
    @Test
    void ofFrames() throws IOException {
        String marked = marked(
                "'shading': { 'model': 'physical' }, 'objects': [BALL,\n ¤{ 'type': 'sphere', 'center': [0, 2, 0],"
                        + " 'radius': 1, 'material': { 'type': 'matte', 'color': '#888' } }], 'animation': { 'frames': 2,"
                        + " 'framesPerSecond': 1, 'tracks': [{ 'target': '/objects/1/center/1', 'keys': { '0': 2, '1': 1e200 } }] }");
        Path scene = Files.writeString(folder.resolve("scene.json"), marked.replace(BLAME, ""));
        CliRun run = CliRun.of("render", scene, "--frame", 1, "-o", folder.resolve("x.png"), "--progress", "none");
        assertEquals(2, run.code(), run.err());
        assertTrue(run.err().startsWith(scene + ":" + place(marked) + ": /objects/1: "), run.err());
    }
}
