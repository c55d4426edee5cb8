package enlightenment.world.material;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.color.Rgb;
import enlightenment.material.Texture;
import java.util.List;
import org.junit.jupiter.api.Test;

class CheckerLookupTest {
    private static double at(double scale, double u, double v) {
        Texture checker = new Texture.Checker(List.of(Rgb.gray(0.25), Rgb.gray(0.75)), scale);
        double[] rgb = new double[3];
        new TextureLookup(checker, null, true).color(u, v, false, rgb);
        return rgb[0];
    }

    @Test
    void squaresGoOnBeyondTheUnitSquare() {
        for (int i = -7; i < 8; i++) {
            for (int j = -7; j < 8; j++) {
                double expected = ((i + j) & 1) == 0 ? 0.25 : 0.75;
                assertEquals(expected, at(2, (i + 0.5) / 2, (j + 0.5) / 2));
            }
        }
    }

    @Test
    void theFarEdgeBelongsToTheLastSquare() {
        assertEquals(at(3, 0.9, 0.1), at(3, 1, 0.1));
        assertEquals(at(3, 0.1, 0.9), at(3, 0.1, 1));
    }
}
