package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Color;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.scene.SceneException.Problem;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is wrong about media, dyes, dispersion and surroundings is told in one line, with its place and what could stand there. */
class BadMatterTest {
    @TempDir
    Path folder;

    private Problem problem(String shading, String parts) {
        String scene =
                "{'image': {'width': 4, 'height': 2}, 'camera': {'type': 'isometric', 'lookAt': [0, 0, 0], 'height': 5},"
                        + " 'shading': {" + shading + "}, " + parts + ", 'objects': []}";
        Problem problem = Documents.problem(scene.replace('\'', '"'), folder);
        assertTrue(problem.line() > 0 && problem.column() > 0, problem.toString());
        assertEquals(1, problem.toString().lines().count());
        return problem;
    }

    private static void assertTells(Problem problem, String pointer, String words) {
        assertEquals(pointer, problem.pointer(), problem.toString());
        assertTrue(problem.message().contains(words.replace('\'', '"')), problem.message());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '"',
            value = {
                "background | {'foo': 1} |  | a sky, {'type': 'sky', 'elevation': degrees}, not an object with 'foo'",
                "background | {'elevation': 30} | | a picture, {'texture': '...'}, or a sky",
                "background | {'file': 'sky.hdr'} | | a picture, {'texture': '...'}",
                "background | {'textur': 'sky'} | | did you mean 'texture'?",
                "background | {} | | not an empty object",
                "background | [1, 2] | | or a sky",
                "background | 3 | | or a sky",
                "background | 'sky' | | or a sky",
                "background | {'linear': [1, 1, 1], 'radiance': 2} | /radiance | a linear colour has 'linear'",
                "background | {'linear': [-1, 0, 0]} | /linear/0 | at least 0",
                "background | {'linear': [1e101, 0, 0]} | | must be at most 1e100",
                "background | {'type': 'hosek', 'elevation': 30} | /type | expected one of 'picture', 'sky'",
                "background | {'type': 'sky'} | /elevation | missing",
                "background | {'type': 'sky', 'elevation': -5} | /elevation | must lie in 0.0..90.0",
                "background | {'type': 'sky', 'elevation': 5, 'turbidity': 30} | /turbidity | must lie in 2.0..10.0",
                "background | {'type': 'sky', 'elevation': 5, 'groundAlbedo': 1.5} | /groundAlbedo | more than it receives",
                "background | {'type': 'sky', 'elevation': 5, 'radiance': -3} | /radiance | at least 0",
                "background | {'type': 'sky', 'elevation': 5, 'texture': 'room'} | /texture | a sky background has",
                "background | {'texture': 'room'} | /texture | names no textures",
                "medium | {} | /color | either 'color' and 'meanFreePath' or",
                "medium | {'color': '#888'} | /meanFreePath | missing",
                "medium | {'scatteringCoefficient': 1} | /absorptionCoefficient | missing",
                "medium | {'color': '#888', 'meanFreePath': 1, 'absorptionCoefficient': 1} | /absorptionCoefficient | either these or",
                "medium | {'color': '#888', 'meanFreePath': 0} | /meanFreePath | greater than 0",
                "medium | {'color': '#888', 'meanFreePath': '1 mm'} | /meanFreePath | must be a number",
                "medium | {'color': '#888', 'meanFreePath': 1, 'anisotropy': 1} | /anisotropy | both excluded",
                "medium | {'color': '#888', 'meanFreePath': 1, 'indexOfRefraction': 1.3} | /indexOfRefraction | a medium has",
                "medium | {'color': {'linear': [1.2, 1, 1]}, 'meanFreePath': 1} | /color | more than it receives",
                "medium | {'scatteringCoefficient': -1, 'absorptionCoefficient': 0} | /scatteringCoefficient | at least 0",
                "medium | {'scatteringCoefficient': 1e400, 'absorptionCoefficient': 0} | /scatteringCoefficient | a double can hold",
                "medium | 3 | | an object",
            })
    void ofBackgroundsAndMedia(String key, String value, String pointer, String words) {
        Problem problem = problem("'model': 'physical', '" + key + "': " + value, "'lights': []");
        assertTells(problem, "/shading/" + key + (pointer == null ? "" : pointer), words);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '"',
            value = {
                "'scattering', 'color': '#888', 'meanFreePath': 1, 'radiance': 3 | /radiance | do not glow",
                "'scattering', 'color': '#888', 'meanFreePath': 1, 'absorption': 3 | /absorption | absorptionCoefficient",
                "'fluorescent', 'color': '#888', 'absorption': [320, 490], 'emission': [505, 630], 'yield': 1.2 | /yield | 0.0..1.0",
                "'fluorescent', 'color': '#888', 'absorption': [520, 590], 'emission': [405, 500], 'yield': 1 | /emission | shorter",
                "'fluorescent', 'color': '#888', 'absorption': [0.32, 0.49], 'emission': [505, 630], 'yield': 1 | /absorption | nm",
                "'fluorescent', 'color': '#888', 'absorption': 320, 'emission': [505, 630], 'yield': 1 | /absorption | nanometres",
                "'glass', 'color': '#fff', 'indexOfRefraction': 1.5, 'dispersion': 0 | /dispersion | greater than 0",
                "'glass', 'color': '#fff', 'indexOfRefraction': 1.5, 'dispersion': 0.001 | /dispersion | is too small",
                "'glass', 'color': '#fff', 'indexOfRefraction': 1.5, 'ultraviolet': 3 | /ultraviolet | does not glow",
                "'matte', 'color': '#fff', 'dispersion': 40 | /dispersion | unknown key",
                "'mask', 'of': 'later', 'map': 1}, 'later': {'type': 'matte', 'color': '#fff' | /of | 'later' before this one",
                "'mask', 'of': {'type': 'glass', 'color': '#fff', 'indexOfRefraction': 1.5}, 'map': 1 | /of | an opaque material",
                "'mask', 'of': {'type': 'matte', 'color': '#fff', 'radiance': 1}, 'map': 1 | /of | does not glow",
                "'mask', 'of': {'type': 'matte', 'color': '#fff'}, 'map': -0.5 | /map | must lie in 0.0..1.0, not -0.5",
                "'mask', 'of': {'type': 'matte', 'color': '#fff'}, 'map': 1, 'receivesShadows': true | /receivesShadows | classic",
                "'bump', 'of': {'type': 'matte', 'color': '#fff'}, 'map': {'texture': 'no'}, 'height': 1 | /map/texture | names no",
            })
    void ofMaterials(String keys, String pointer, String words) {
        Problem problem = problem("'model': 'physical'", "'materials': {'m': {'type': " + keys + "}}");
        assertTells(problem, "/materials/m" + pointer, words);
    }

    @Test
    void ofMapsThatShowNothing() throws IOException {
        Documents.withImage(folder);
        ImageFiles.writePfm(new Image(1, 1, new float[3], Color.Encoding.LINEAR), folder.resolve("sky.pfm"));
        String textures =
                "'textures': {'colors': {'file': 'ice.png'}, 'plain': {'type': 'color', 'color': '#888'}, 'floats': {'file':"
                        + " 'sky.pfm', 'encoding': 'linear'}}, 'materials': {'m': {'of': {'type': 'matte', 'color': '#fff'}, 'type': ";
        String model = "'model': 'physical'";
        assertTells(
                problem(model, textures + "'normalMap', 'map': {'texture': 'colors'}}}"),
                "/materials/m/map",
                "must be a texture with 'encoding': 'linear'");
        assertTells(
                problem(model, textures + "'bump', 'height': 1, 'map': {'texture': 'plain'}}}"),
                "/materials/m/map",
                "no other has slopes");
        assertTells(
                problem(model, textures + "'mask', 'map': {'texture': 'floats'}}}"),
                "/materials/m/map/texture",
                "is a file of floats");
    }

    @Test
    void ofWhatClassicShadingDoesNotHave() {
        String sky = "'background': {'type': 'sky', 'elevation': 30}";
        assertTells(problem(sky, "'lights': []"), "/shading/background", "belong to physical shading");
        String fog = "'medium': {'color': '#888', 'meanFreePath': 1}";
        assertTells(problem(fog, "'lights': []"), "/shading/medium", "belongs to physical shading");
    }
}
