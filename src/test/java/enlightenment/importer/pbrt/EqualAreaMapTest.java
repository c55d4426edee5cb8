package enlightenment.importer.pbrt;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Color;
import enlightenment.image.Image;
import enlightenment.importer.support.Affine;
import enlightenment.math.Vec3;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

class EqualAreaMapTest {
    @Test
    void placesAndDirectionsAreInverse() {
        for (int i = 0; i < 400; i++) {
            double u = (i % 20 + 0.37) / 20;
            double v = (i / 20 + 0.61) / 20;
            Vec3 d = EqualAreaMap.direction(u, v);
            assertEquals(1, d.length(), 1e-12);
            double[] back = EqualAreaMap.place(d);
            assertEquals(u, back[0], 1e-9);
            assertEquals(v, back[1], 1e-9);
        }
    }

    @Test
    void axesLieWhereTheFormatHasThem() {
        assertTrue(EqualAreaMap.direction(0.5, 0.5).minus(Vec3.Z).maxAbs() < 1e-12);
        assertTrue(EqualAreaMap.direction(1, 0.5).minus(Vec3.X).maxAbs() < 1e-12);
        assertTrue(EqualAreaMap.direction(0.5, 1).minus(Vec3.Y).maxAbs() < 1e-12);
        assertEquals(-1, EqualAreaMap.direction(0, 0).z(), 1e-12);
    }

    /** Equal areas are equal solid angles: means over the square are means over the sphere, of z² 1/3, of max(z, 0) 1/4. */
    @Test
    void areasAreSolidAngles() {
        int n = 200;
        double squares = 0;
        double upper = 0;
        for (int i = 0; i < n * n; i++) {
            double z =
                    EqualAreaMap.direction((i % n + 0.5) / n, (i / n + 0.5) / n).z();
            squares += z * z;
            upper += Math.max(0, z);
        }
        assertEquals(1.0 / 3, squares / (n * n), 1e-3);
        assertEquals(1.0 / 4, upper / (n * n), 1e-3);
    }

    private static EqualAreaMap ofDirections(int n) {
        float[] rgb = new float[3 * n * n];
        for (int i = 0; i < n * n; i++) {
            Vec3 d = EqualAreaMap.direction((i % n + 0.5) / n, (i / n + 0.5) / n);
            rgb[3 * i] = (float) (d.x() + 1);
            rgb[3 * i + 1] = (float) (d.y() + 1);
            rgb[3 * i + 2] = (float) (d.z() + 1);
        }
        return new EqualAreaMap(new Image(n, n, rgb, Color.Encoding.LINEAR), false);
    }

    private static void assertDirection(double x, double y, double z, Image image, double u, double v) {
        int px = (int) (u * image.width());
        int py = (int) (v * image.height());
        assertEquals(x + 1, image.component(px, py, 0), 0.05);
        assertEquals(y + 1, image.component(px, py, 1), 0.05);
        assertEquals(z + 1, image.component(px, py, 2), 0.05);
    }

    @Test
    void thePictureByLongitudeHasUpAtItsUpperEdge() {
        Image image = ofDirections(128).byLongitude(Affine.IDENTITY);
        assertDirection(0, 1, 0, image, 0.5, 0);
        assertDirection(0, 0, 1, image, 0.5, 0.5);
        assertDirection(1, 0, 0, image, 0.75, 0.5);
    }

    /** Turned so that the map's z becomes the scene's y: the map's z is seen at the upper edge. */
    @Test
    void thePictureIsTurnedWithItsLight() {
        Image image = ofDirections(128).byLongitude(Affine.rotate(Vec3.X, -90));
        assertDirection(0, 0, 1, image, 0.5, 0);
        assertDirection(1, 0, 0, image, 0.75, 0.5);
    }

    @Test
    void aWhiteSkyGivesTheIlluminancePi() {
        float[] white = new float[3 * 64 * 64];
        Arrays.fill(white, 1);
        EqualAreaMap map = new EqualAreaMap(new Image(64, 64, white, Color.Encoding.LINEAR), false);
        assertEquals(StrictMath.PI, map.illuminance(), 1e-2);
    }
}
