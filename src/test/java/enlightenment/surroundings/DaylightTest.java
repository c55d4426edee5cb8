package enlightenment.surroundings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DaylightTest {
    /** Worked out from the published formulas by a few lines of Python: zenith in kcd/m², light of the sky on the ground in klx. */
    @ParameterizedTest
    @CsvSource({
        "2, 10, 2.4556, 19.0",
        "2, 35, 3.7886, 24.8",
        "2, 60, 5.8875, 24.4",
        "3, 35, 5.8048, 25.9",
        "3, 60, 10.411, 31.5",
        "6, 35, 11.217, 38.9",
        "6, 60, 22.068, 56.1"
    })
    void theSkyIsThatOfTheFormulas(double turbidity, double elevation, double zenith, double falls) {
        Daylight daylight = new Daylight(elevation, turbidity);
        assertEquals(zenith, daylight.zenithLuminance() / 1000, 1e-3 * zenith);
        assertEquals(
                daylight.zenithLuminance(),
                daylight.luminance(1, Math.sin(Math.toRadians(elevation))),
                1e-9 * daylight.zenithLuminance());
        double sum = 0;
        int n = 90;
        double height = Math.toRadians(elevation);
        double[] rgb = new double[3];
        for (int i = 0; i < n; i++) {
            double theta = (i + 0.5) / n * Math.PI / 2;
            for (int j = 0; j < 2 * n; j++) {
                double phi = (j + 0.5) / n * Math.PI;
                double gamma = Math.cos(theta) * Math.sin(height) + Math.sin(theta) * Math.cos(height) * Math.cos(phi);
                daylight.sky(Math.cos(theta), gamma, rgb);
                double y = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
                sum += y * Math.cos(theta) * Math.sin(theta) * Math.PI / 2 / n * Math.PI / n;
            }
        }
        assertEquals(falls, sum * Daylight.UNIT / 1000, 0.02 * falls);
    }

    /**
     * The solar illuminance constant is 128 to 134 klx by various authors, and sunlight outside the atmosphere has x = 0.323, y = 0.333;
     * the published table of the sun's spectrum is a little bluer.
     */
    @Test
    void outsideOfTheAtmosphereTheSunIsAsBrightAsIsKnown() {
        double[] xyz = new double[3];
        SunSpectrum.disk(3, 0, xyz);
        double radius = Math.toRadians(Daylight.SUN_RADIUS);
        double illuminance = xyz[1] * Math.PI * Math.sin(radius) * Math.sin(radius);
        assertTrue(illuminance > 126_000 && illuminance < 136_000, "lx: " + illuminance);
        double sum = xyz[0] + xyz[1] + xyz[2];
        assertEquals(0.323, xyz[0] / sum, 0.008);
        assertEquals(0.333, xyz[1] / sum, 0.008);
    }

    /** F. Kasten's table: 1 straight up, 2 at 30°, 5.6 at 10°, 36 to 38 at the horizon. */
    @Test
    void theAirMassIsThatOfTheTables() {
        assertEquals(1, SunSpectrum.airMass(90), 0.001);
        assertEquals(1.995, SunSpectrum.airMass(30), 0.01);
        assertEquals(5.6, SunSpectrum.airMass(10), 0.05);
        assertTrue(SunSpectrum.airMass(0) > 35 && SunSpectrum.airMass(0) < 39);
    }

    /** Clear days give 60 to 110 klx of direct light at 60°; hazy ones less, and low suns are red. */
    @Test
    void theSunGrowsFainterAndRedderThroughMoreAir() {
        double solid = 2 * Math.PI * (1 - Math.cos(Math.toRadians(Daylight.SUN_RADIUS)));
        double last = Double.POSITIVE_INFINITY;
        double lastRatio = Double.POSITIVE_INFINITY;
        for (double elevation : new double[] {60, 30, 10, 3, 0}) {
            Rgb sun = new Daylight(elevation, 3).sun();
            double y = 0.2126 * sun.r() + 0.7152 * sun.g() + 0.0722 * sun.b();
            assertTrue(y < last);
            assertTrue(sun.b() / sun.r() < lastRatio);
            last = y;
            lastRatio = sun.b() / sun.r();
            if (elevation == 60) {
                double direct = y * solid * Daylight.UNIT / 1000;
                assertTrue(direct > 60 && direct < 110, "klx: " + direct);
            }
        }
        assertTrue(new Daylight(60, 6).sun().g() < new Daylight(60, 3).sun().g());
    }

    @Test
    void noDirectionOfAnySkyIsNegativeOrNotANumber() {
        double[] rgb = new double[3];
        for (double turbidity = 2; turbidity <= 10; turbidity += 0.5) {
            for (double elevation = 0; elevation <= 90; elevation += 7.5) {
                Daylight daylight = new Daylight(elevation, turbidity);
                double height = Math.toRadians(elevation);
                for (int i = 0; i < 20; i++) {
                    double theta = (i + 0.5) / 20 * Math.PI / 2;
                    for (int j = 0; j < 20; j++) {
                        double phi = (j + 0.5) / 20 * Math.PI;
                        daylight.sky(
                                Math.cos(theta),
                                Math.cos(theta) * Math.sin(height) + Math.sin(theta) * Math.cos(height) * Math.cos(phi),
                                rgb);
                        double most = Math.max(rgb[0], Math.max(rgb[1], rgb[2]));
                        assertTrue(most > 0 && most < 100 && rgb[0] >= 0 && rgb[1] >= 0 && rgb[2] >= 0);
                    }
                }
            }
        }
    }
}
