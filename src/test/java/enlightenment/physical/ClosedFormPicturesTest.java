package enlightenment.physical;

import enlightenment.scene.RenderSettings;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Where the radiance of every pixel is known, the picture shows it. */
class ClosedFormPicturesTest {
    static Stream<ClosedForms.Known> known() {
        return Stream.concat(ClosedForms.all().stream(), ClosedForms.hard().stream());
    }

    @ParameterizedTest
    @MethodSource("known")
    void thePictureShowsTheRadianceThatIsKnown(ClosedForms.Known known) {
        known.assertShown(RenderSettings.of(known.scene()).withAntialias(4));
    }
}
