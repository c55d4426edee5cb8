package enlightenment.render.aov;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.render.RenderResult;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;

class AuxiliaryPictureTest {
    private static final float INFINITE = Float.POSITIVE_INFINITY;

    private static Image grey(int width, float... values) {
        float[] rgb = new float[3 * values.length];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = values[i / 3];
        }
        return new Image(width, values.length / width, rgb);
    }

    @Test
    void nearIsBrightAndNothingIsBlack() {
        AuxiliaryPicture picture = AuxiliaryPicture.of(RenderResult.Auxiliary.DEPTH, grey(4, 2, 4, 3, INFINITE));
        assertEquals(1, picture.image().component(0, 0, 0));
        assertEquals(0.1f, picture.image().component(1, 0, 1));
        assertEquals(0.55f, picture.image().component(2, 0, 2), 1e-6f);
        assertEquals(0, picture.image().component(3, 0, 0));
        assertTrue(picture.explanation().contains("white 2.0 .. dark grey (0.1) 4.0"), picture.explanation());
        assertTrue(AuxiliaryPicture.of(RenderResult.Auxiliary.DEPTH, grey(1, INFINITE))
                .explanation()
                .contains("nothing is seen"));
        assertEquals(
                1,
                AuxiliaryPicture.of(RenderResult.Auxiliary.DEPTH, grey(2, 5, 5))
                        .image()
                        .component(1, 0, 0));
    }

    @Test
    void aNormalIsAColorAndNoneIsBlack() {
        Image normals = new Image(2, 1, new float[] {0, -1, 0, 0, 0, 0});
        Image picture =
                AuxiliaryPicture.of(RenderResult.Auxiliary.NORMAL, normals).image();
        assertEquals(0.5f, picture.component(0, 0, 0));
        assertEquals(0, picture.component(0, 0, 1));
        assertEquals(0, picture.component(1, 0, 0));
    }

    @Test
    void aHundredObjectsHaveAHundredColors() {
        float[] ids = new float[101];
        for (int i = 0; i < ids.length; i++) {
            ids[i] = i - 1;
        }
        Image picture = AuxiliaryPicture.of(RenderResult.Auxiliary.OBJECT, grey(101, ids))
                .image();
        Set<List<Integer>> colors = new HashSet<>();
        for (int x = 0; x < ids.length; x++) {
            int column = x;
            colors.add(List.of(0, 1, 2).stream()
                    .map(c -> Math.round(255 * picture.component(column, 0, c)))
                    .toList());
        }
        assertEquals(101, colors.size());
        // Neighbours in the list are far from each other.
        for (int x = 2; x < ids.length; x++) {
            double d = 0;
            for (int c = 0; c < 3; c++) {
                d += Math.abs(picture.component(x, 0, c) - picture.component(x - 1, 0, c));
            }
            assertTrue(d > 0.3, "objects " + (x - 2) + " and " + (x - 1));
        }
    }

    @Test
    void theScaleOfErrorsEndsAtARoundNumber() {
        AuxiliaryPicture picture =
                AuxiliaryPicture.of(RenderResult.Auxiliary.ERROR, grey(2, 0.013f, 0.013f, 0.5f, INFINITE));
        assertTrue(picture.explanation().contains("0..0.02; largest 0.5"), picture.explanation());
        // Above the scale is its end: magma's pale yellow.
        assertEquals(252 / 255f, picture.image().component(0, 1, 0));
        assertEquals(252 / 255f, picture.image().component(1, 1, 0));
        assertTrue(AuxiliaryPicture.of(RenderResult.Auxiliary.ERROR, grey(1, 0))
                .explanation()
                .contains("0..0.000001"));
    }

    @Test
    void theScaleOfSamplesGoesUpInDoublings() {
        AuxiliaryPicture picture = AuxiliaryPicture.of(RenderResult.Auxiliary.SAMPLES, grey(4, 1, 16, 4, 0));
        assertTrue(picture.explanation().contains("1..16; most 16"), picture.explanation());
        assertEquals(0, picture.image().component(0, 0, 0));
        assertEquals(252 / 255f, picture.image().component(1, 0, 0));
        // The middle of magma.
        assertEquals(183 / 255f, picture.image().component(2, 0, 0), 2 / 255f);
        assertTrue(AuxiliaryPicture.of(RenderResult.Auxiliary.SAMPLES, grey(1, 33))
                .explanation()
                .contains("1..64; most 33"));
    }

    @Test
    void positionsAreShownAsPlacesInTheBoxOfAllThatIsSeen() {
        Image numbers = new Image(3, 1, new float[] {-1, 5, 0, 3, 5, 8, 0, 0, 0});
        AuxiliaryPicture picture = AuxiliaryPicture.of(RenderResult.Auxiliary.POSITION, numbers);
        assertArrayEquals(
                new float[] {0, 0, 0, 1, 0, 1, 0, 0, 0}, picture.image().toArray());
        assertTrue(picture.explanation().contains("from (-1.0, 5.0, 0.0) to (3.0, 5.0, 8.0)"));
    }

    @Test
    void theWordsAreTheNamesInSmallLetters() {
        assertEquals(
                List.of("error", "samples", "depth", "normal", "position", "object", "albedo", "direct", "indirect"),
                RenderResult.Auxiliary.words());
        assertEquals(Optional.of(RenderResult.Auxiliary.DEPTH), RenderResult.Auxiliary.of("depth"));
        assertEquals(Optional.empty(), RenderResult.Auxiliary.of("DEPTH"));
    }

    @Test
    void withoutScaleThePictureIsAsLargeAsTheNumbers() {
        float[] values = new float[64];
        Arrays.fill(values, 0.013f);
        Image numbers = grey(64, values);
        AuxiliaryPicture scaled = AuxiliaryPicture.of(RenderResult.Auxiliary.ERROR, numbers);
        AuxiliaryPicture plain = AuxiliaryPicture.withoutScale(RenderResult.Auxiliary.ERROR, numbers);
        assertTrue(scaled.image().height() > 1);
        assertEquals(1, plain.image().height());
        assertEquals(scaled.image().component(5, 0, 0), plain.image().component(5, 0, 0));
        assertEquals(List.of("0", "0.005", "0.01", "0.015", "0.02"), plain.marks());
        assertEquals(
                List.of("1", "2", "4"),
                AuxiliaryPicture.withoutScale(RenderResult.Auxiliary.SAMPLES, grey(2, 1, 3))
                        .marks());
        assertEquals(
                List.of("2.0", "4.0"),
                AuxiliaryPicture.withoutScale(RenderResult.Auxiliary.DEPTH, grey(2, 4, 2))
                        .marks());
        assertEquals(
                List.of(),
                AuxiliaryPicture.withoutScale(RenderResult.Auxiliary.OBJECT, grey(2, 4, 2))
                        .marks());
    }
}
