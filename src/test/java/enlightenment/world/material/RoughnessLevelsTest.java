package enlightenment.world.material;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.material.Texture;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Levels of roughness have the texture's own roughness as their mean. */
class RoughnessLevelsTest {
    private static AmountLookup checker(double first, double second, double factor) {
        Texture texture = new Texture.Checker(List.of(new Rgb(0, first, 0), new Rgb(1, second, 0.5)), 2);
        return new AmountLookup(new TextureLookup(texture, null, true), Texture.Amount.Channel.GREEN, factor);
    }

    @Test
    void theTwoNumbersOfACheckerboardAreExact() {
        RoughnessLevels levels = RoughnessLevels.of(checker(0.7, 0.25, 0.5));
        assertArrayEquals(new double[] {0.125, 0.35}, levels.all(), 1e-15);
        assertEquals(0, levels.at(0.125, 0));
        assertEquals(1, levels.at(0.35, Math.nextDown(1.0)));
    }

    @Test
    void oneNumberIsOneLevel() {
        assertArrayEquals(
                new double[] {0.5}, RoughnessLevels.of(checker(0.5, 0.5, 1)).all());
    }

    @Test
    void theMeanOfBothNeighboursIsTheRoughness() {
        RoughnessLevels levels = new RoughnessLevels(10 / 63.0, 1 / 63.0, 41);
        double[] all = levels.all();
        int numbers = 10_000;
        for (double roughness : new double[] {10 / 63.0, 0.2, 0.333, 0.5, 50 / 63.0}) {
            double sum = 0;
            for (int k = 0; k < numbers; k++) {
                double level = all[levels.at(roughness, (k + 0.5) / numbers)];
                assertTrue(Math.abs(level - roughness) < 1 / 63.0 + 1e-12, level + " for " + roughness);
                sum += level;
            }
            assertEquals(roughness, sum / numbers, 1 / 63.0 / numbers);
        }
    }

    @Test
    void numbersBeyondTheLevelsAreOfTheOutermostOnes() {
        RoughnessLevels levels = new RoughnessLevels(0.25, 0.25, 3);
        assertEquals(0, levels.at(0.1, 0.5));
        assertEquals(2, levels.at(1, 0.5));
    }
}
