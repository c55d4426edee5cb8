package enlightenment.physical;

import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.render.Welch;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** However many samples a pixel has, and whatever its method, a picture has the same mean: nothing is divided by the wrong number. */
class SampleCountTest {
    private static final int[] SIDES = {1, 2, 4, 8};

    /** Samples per pixel and number of pictures together, at least. */
    private static final int SAMPLES = 64;

    /** Of the most samples half as many pictures do: beside the others' noise theirs is small all the same. */
    private static int pictures(int side) {
        return Math.max(side == 8 ? 4 : 8, SAMPLES / (side * side));
    }

    static Stream<Arguments> pictures() {
        return Stream.of(InvarianceScenes.byRadiance(), InvarianceScenes.byPower())
                .flatMap(scene -> InvarianceScenes.methods().stream()
                        .map(method -> Arguments.of(
                                RenderSettings.of(scene).withMethod(method).withSize(16, 8), scene)));
    }

    /** Welch's test of each number of samples against the others, at 1 % for all of a picture together by Šidák's formula. */
    @ParameterizedTest
    @MethodSource("pictures")
    void theMeanOfThePictureDoesNotDependOnIt(RenderSettings settings, Scene scene) {
        List<List<double[]>> means = new ArrayList<>();
        for (int side : SIDES) {
            List<Image> pictures = Rendered.seeds(scene, settings.withAntialias(side), 1000 * side, pictures(side));
            List<double[]> bands = new ArrayList<>();
            for (int band = 0; band < 3; band++) {
                bands.add(Rendered.means(pictures, 0, 0, settings.width(), settings.height(), band));
            }
            means.add(bands);
        }
        double level = Welch.sidak(0.01, 3 * 3);
        for (int i = 0; i < SIDES.length; i++) {
            for (int k = 0; k < 3 * i; k++) {
                double[] a = means.get(i).get(k % 3);
                double[] b = means.get(k / 3).get(k % 3);
                String what =
                        SIDES[i] + "² samples: " + Statistics.of(a) + "; " + SIDES[k / 3] + "²: " + Statistics.of(b);
                assertTrue(Welch.of(a, b).probability() >= level, what);
            }
        }
    }
}
