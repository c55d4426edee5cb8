package enlightenment.physical;

import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Where the radiance of every pixel is known, the picture shows it. */
class ClosedFormPicturesTest {
    private static final int SEEDS = 12;

    static Stream<ClosedForms.Known> known() {
        return Stream.concat(ClosedForms.all().stream(), ClosedForms.hard().stream());
    }

    /** Six standard errors of twelve means: Student's distribution gives a right program a chance of 1e-4 to fail. */
    @ParameterizedTest
    @MethodSource("known")
    void thePictureShowsTheRadianceThatIsKnown(ClosedForms.Known known) {
        List<Image> pictures = Rendered.seeds(known.scene(), 4, 1, SEEDS);
        int side = known.scene().width();
        for (int band = 0; band < 3; band++) {
            Statistics s = Statistics.of(Rendered.means(pictures, 0, 0, side, side, band));
            double expected = known.radiance()[band];
            // A pixel is a float; rays are not exactly perpendicular; a table of albedos closes to about 1e-3.
            double tolerance = 6 * s.error() + 1e-6 * expected + (known.name().contains("metal") ? 2e-3 : 0);
            assertTrue(Math.abs(s.mean() - expected) <= tolerance, () -> s + " instead of " + expected);
        }
    }
}
