package enlightenment.material;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.colorimetry.BandSensitivities;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class MetalTest {
    /** Half of the last digit. */
    private static final double ROUNDING = 0.0005 + 1e-9;

    @ParameterizedTest
    @EnumSource(Glossy.Metal.class)
    void theConstantsOfABandAreTheMeansOfTheMeasuredOnesOverItsSensitivity(Glossy.Metal metal) throws IOException {
        List<double[]> rows = measured(metal);
        check(mean(rows, 1), metal.conductor().eta());
        check(mean(rows, 2), metal.conductor().k());
    }

    private static void check(double[] expected, Rgb actual) {
        assertEquals(expected[0], actual.r(), ROUNDING);
        assertEquals(expected[1], actual.g(), ROUNDING);
        assertEquals(expected[2], actual.b(), ROUNDING);
    }

    /** Wavelength, η and k. */
    private static List<double[]> measured(Glossy.Metal metal) throws IOException {
        List<double[]> rows = new ArrayList<>();
        try (InputStream in = MetalTest.class.getResourceAsStream("metals.csv")) {
            String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
            text.lines()
                    .map(l -> l.split(","))
                    .filter(c -> c[0].equals(metal.symbol()))
                    .forEach(c -> rows.add(
                            new double[] {Double.parseDouble(c[1]), Double.parseDouble(c[2]), Double.parseDouble(c[3])
                            }));
        }
        assertTrue(rows.size() >= 12);
        return rows;
    }

    private static double[] mean(List<double[]> rows, int column) {
        double[] sums = new double[3];
        int k = 0;
        for (double nm = BandSensitivities.SHORTEST + 0.5; nm < BandSensitivities.LONGEST; nm++) {
            while (rows.get(k + 1)[0] < nm) {
                k++;
            }
            double[] a = rows.get(k);
            double[] b = rows.get(k + 1);
            double value = a[column] + (nm - a[0]) / (b[0] - a[0]) * (b[column] - a[column]);
            for (int band = 0; band < 3; band++) {
                sums[band] += BandSensitivities.DAYLIGHT.sensitivity(nm, band) * value;
            }
        }
        return sums;
    }

    @Test
    void everyMetalIsFoundByItsNameItsSymbolAndItsConstants() {
        for (Glossy.Metal metal : Glossy.Metal.values()) {
            assertEquals(Optional.of(metal), Glossy.Metal.of(metal.word()));
            assertEquals(Optional.of(metal), Glossy.Metal.of(metal.symbol()));
            assertEquals(Optional.of(metal), Glossy.Metal.of(metal.conductor()));
        }
        assertEquals(2 * Glossy.Metal.values().length, new HashSet<>(Glossy.Metal.words()).size());
        assertTrue(
                Glossy.Metal.words().stream().allMatch(w -> Glossy.Metal.of(w).isPresent()));
        assertEquals(Optional.empty(), Glossy.Metal.of("Gold"));
        assertEquals(Optional.empty(), Glossy.Metal.of(new Glossy.Conductor(Rgb.WHITE, Rgb.WHITE)));
    }
}
