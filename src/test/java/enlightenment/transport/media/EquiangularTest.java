package enlightenment.transport.media;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class EquiangularTest {
    private static Ray ray(double along, double beside) {
        Ray ray = new Ray();
        ray.set(-along, beside, 0, 2, 0, 0, 0);
        return ray;
    }

    /** The share of the angle that a part of the segment is seen at is the probability of that part. */
    @ParameterizedTest
    @CsvSource({
        "1, 0.5, 3",
        "-1, 0.5, 3",
        "5, 0.5, 3",
        "0, 1, 1e-9",
        "1e6, 1, 2e6",
        "-1e6, 1, 1e3",
        "1, 1e-9, 3",
        "0.5, 2, Infinity",
        "-3, 0.1, Infinity",
        "1e3, 1e-3, Infinity"
    })
    void equalAnglesHaveEqualProbabilities(double along, double beside, double length) {
        Equiangular points = new Equiangular(Vec3.ZERO);
        double whole = angle(along, beside, length);
        double before = 0;
        for (double u = 0.01; u < 1; u += 0.01) {
            assertTrue(points.sample(ray(along, beside), length, u));
            assertTrue(points.distance >= before && points.distance <= length, points.distance + " after " + before);
            before = points.distance;
            assertEquals(u, angle(along, beside, points.distance) / whole, 1e-6, "at " + u);
            double x = points.distance - along;
            assertEquals(1, points.density * whole * (x * x + beside * beside) / beside, 1e-6, "at " + u);
        }
    }

    /** Of a segment that starts at (-along, beside), from the origin. */
    private static double angle(double along, double beside, double length) {
        return length == Double.POSITIVE_INFINITY
                ? Math.atan2(beside, -along)
                : Math.atan2(beside * length, beside * beside - along * (length - along));
    }

    @ParameterizedTest
    @CsvSource({"1, 0, 3", "1, 0, Infinity", "1, 1, 0"})
    void thereIsNoneWhereThereIsNoAngle(double along, double beside, double length) {
        assertFalse(new Equiangular(Vec3.ZERO).sample(ray(along, beside), length, 0.5));
    }
}
