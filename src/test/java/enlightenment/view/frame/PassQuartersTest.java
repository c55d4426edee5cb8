package enlightenment.view.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.image.Image;
import java.util.List;
import org.junit.jupiter.api.Test;

class PassQuartersTest {
    private final PassQuarters quarters = new PassQuarters();

    private void add(double value, int samples) {
        float v = (float) value;
        quarters.add(new Image(1, 1, new float[] {v, v, v}), samples);
    }

    private List<Double> means() {
        return quarters.means().stream()
                .map(image -> (double) image.component(0, 0, 1))
                .toList();
    }

    @Test
    void aSinglePassTellsNoNoise() {
        add(1, 8);
        assertEquals(List.of(), means());
    }

    @Test
    void twoAndThreePassesMakeHalves() {
        add(1, 1);
        add(2, 1);
        assertEquals(List.of(1.0, 1.0, 2.0, 2.0), means());
        add(3, 2);
        assertEquals(List.of(1.0, 2.0, 3.0, 3.0), means());
    }

    /** The fifth and sixth pass go to the shares of one sample each. */
    @Test
    void aPassGoesToTheShareWithTheFewestSamples() {
        int[] samples = {1, 1, 2, 4, 3, 1};
        for (int k = 0; k < samples.length; k++) {
            add(k, samples[k]);
        }
        assertEquals(List.of(3.0, 3.0, 2.0, 3.0), means(), "(0 · 1 + 4 · 3) / 4, (1 · 1 + 5 · 1) / 2");
    }
}
