package enlightenment.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayCurve;
import enlightenment.image.Image;
import enlightenment.image.ImageError;
import enlightenment.measure.analysis.SyntheticImages;
import enlightenment.measure.analysis.SyntheticRuns;
import enlightenment.measure.trade.Reference;
import enlightenment.measure.trade.TradeRun;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ReferenceMakerTest {
    private static final Image TRUTH = SyntheticImages.gradient(60, 50);

    /** What a mean square over 9000 components scatters by, as a share of itself: √(2/9000) = 0.015, times five. */
    private static final double SCATTER = 0.075;

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 5})
    void theMeanKnowsItsOwnErrorFromTheDifferencesOfItsParts(int count) {
        Random random = new Random(count);
        List<Image> parts = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            // Parts of unequal quality: nothing is assumed about them.
            parts.add(SyntheticImages.meanOfSamples(TRUTH, 1, 0.02 * (i + 1), random));
        }
        Reference reference = ReferenceMaker.meanOf(parts, List.of());
        double truth = ImageError.between(reference.image(), TRUTH).meanSquaredError();
        assertEquals(truth, reference.variance(), 2 * SCATTER * truth);
    }

    /** Light is averaged; what differs beyond the white of the screen is no difference. */
    @Test
    void ofLightTheMeanIsLightAndTheErrorIsThatOfWhatIsShown() {
        DisplayCurve curve = DisplayCurve.of(1, DisplayCurve.Tone.CLIP);
        Image a = new Image(1, 1, new float[] {0.1f, 8, 0}, curve);
        Image b = new Image(1, 1, new float[] {0.2f, 2, 0}, curve);
        Reference reference = ReferenceMaker.meanOf(List.of(a, b), List.of());
        assertEquals(0.15f, reference.image().component(0, 0, 0), 1e-7f);
        assertEquals(5, reference.image().component(0, 0, 1));
        assertEquals(curve, reference.image().curve());
        double d = curve.of(0.1) - curve.of(0.2);
        assertEquals(d * d / 12, reference.variance(), 1e-6);
    }

    @Test
    void theErrorOfAGivenPictureIsWhatTwoRendersAgreeOn() {
        Random random = new Random(7);
        Image given = SyntheticImages.meanOfSamples(TRUTH, 1, 0.03, random);
        Image a = SyntheticImages.meanOfSamples(TRUTH, 4, 0.05, random);
        Image b = SyntheticImages.meanOfSamples(TRUTH, 4, 0.08, random);
        assertEquals(0.03, ReferenceMaker.given(given, a, b).error(), 0.03 * SCATTER);
        // Against the truth itself nothing is left but chance, which is not told as no error at all.
        assertTrue(ReferenceMaker.given(TRUTH, a, b).error() > 0);
        assertTrue(ReferenceMaker.given(TRUTH, a, b).error() < 0.007);
    }

    @Test
    void theReferencesErrorIsTakenOffTheRuns() {
        Random random = new Random(9);
        Image reference = SyntheticImages.meanOfSamples(TRUTH, 1, 0.03, random);
        Image render = SyntheticImages.meanOfSamples(TRUTH, 1, 0.04, random);
        double difference = ImageError.between(render, reference).meanSquaredError();
        // 3-4-5: without the correction the error would seem to be 0.05.
        assertEquals(0.05, Math.sqrt(difference), 0.05 * SCATTER);
        TradeRun run = SyntheticRuns.run("raytrace", 1, 1, difference, 1);
        assertEquals(0.04, run.error(0.03 * 0.03), 0.04 * SCATTER);
        assertTrue(run.isJudged(0.03 * 0.03));
        // An error as large as the reference's is known, a smaller one is not.
        assertTrue(run.isJudged(0.49 * difference));
        assertTrue(!run.isJudged(0.51 * difference));
    }
}
