package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.scene.SceneException;
import enlightenment.scene.SceneException.Problem;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Whatever number stands in a scene, it is read, or refused as a problem of the scene with its place. */
class ExtremeNumbersTest {
    private static final List<String> EXTREMES =
            List.of("0", "-0.0", "-1", "1e101", "-1e101", "1.7976931348623157e308", "-1e308", "1e-320", "4.9e-324");

    /** What {@link Documents#EVERYTHING} has not since it is classic. */
    private static final List<String> PHYSICAL = List.of(
            physical("'background': {'linear': [1, 2, 3]}, 'maxBounces': 5"),
            physical("'background': [0.25, 0.5, 0.75], 'medium': {'color': {'linear': [0.5, 0.25, 0.75]},"
                    + " 'meanFreePath': [1, 2, 3], 'anisotropy': 0.5}"),
            physical("'background': {'type': 'sky', 'elevation': 30, 'azimuth': 40, 'turbidity': 4,"
                    + " 'groundAlbedo': [0.25, 0.5, 0.75], 'radiance': [1, 2, 3]},"
                    + " 'medium': {'scatteringCoefficient': [1, 2, 3], 'absorptionCoefficient': 2}"),
            physical("'background': {'texture': 'room', 'radiance': 2, 'rotation': 90}"));

    /** A number that is no part of a word or text. */
    private static final Pattern NUMBER = Pattern.compile("(?<=[\\[ ,:])-?[0-9]+(\\.[0-9]+)?(?=[\\], }\\n])");

    @TempDir
    Path folder;

    private static String physical(String shading) {
        return ("{'image': {'width': 4, 'height': 2}, 'camera': {'type': 'isometric', 'lookAt': [0, 0, 0], 'height': 5},"
                        + " 'textures': {'room': {'file': 'ice.png'}}, 'shading': {'model': 'physical', " + shading
                        + "}, 'objects': []}")
                .replace('\'', '"');
    }

    @Test
    void areReadOrRefusedWithTheirPlaces() {
        Documents.withImage(folder);
        List<String> documents = new ArrayList<>(PHYSICAL);
        documents.add(Documents.EVERYTHING);
        for (String document : documents) {
            int numbers = 0;
            Matcher number = NUMBER.matcher(document);
            while (number.find()) {
                numbers++;
                for (String extreme : EXTREMES) {
                    attempt(document.substring(0, number.start()) + extreme + document.substring(number.end()));
                }
            }
            assertTrue(numbers > 5, document);
        }
    }

    private void attempt(String document) {
        try {
            Documents.read(document, folder);
        } catch (SceneException e) {
            for (Problem p : e.problems()) {
                assertEquals("scene.json", p.file());
                assertTrue(p.line() > 0 && p.column() > 0 && p.pointer().startsWith("/"), p.toString());
                assertEquals(1, p.toString().lines().count());
            }
        }
    }
}
