package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import enlightenment.primitive.TorusVectors.Vector;
import java.io.IOException;
import java.math.BigDecimal;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The torus against the exact distances of the shared test vectors (numerics N07, N10). */
class TorusVectorsTest {
    /** Below this many roundings of the distance, hit or miss is not decided by double arithmetic. */
    private static final double DECIDABLE = 1024;

    @Test
    void everyDecidableVectorIsHitOrMissedAsExactArithmeticSays() throws IOException {
        List<Vector> vectors = TorusVectors.read();
        assertEquals(144, vectors.size());
        int decided = 0;
        for (Vector v : vectors) {
            if (v.margin >= DECIDABLE) {
                decided++;
                boolean hit = v.torus().intersect(Ray.of(v.origin, v.direction), new Hit());
                assertEquals(v.hit, hit, v.scenario + " from " + v.origin);
            }
        }
        assertTrue(decided > vectors.size() / 2, decided + " decided");
    }

    @Test
    void everyHitIsAtTheExactDistanceAndOnTheSurface() throws IOException {
        int hits = 0;
        for (Vector v : TorusVectors.read()) {
            Hit hit = new Hit();
            TorusPrimitive torus = v.torus();
            Ray ray = Ray.of(v.origin, v.direction);
            if (!v.hit || !torus.intersect(ray, hit)) {
                continue;
            }
            hits++;
            BigDecimal error = new BigDecimal(hit.t).subtract(v.t).abs();
            assertTrue(error.compareTo(new BigDecimal(v.tolerance)) <= 0, v.scenario + ": t is off by " + error);
            assertEquals(hit.t, torus.nearest(ray, Double.MAX_VALUE), v.scenario);
            double ulps = ulpsFromSurface(v, hit.point());
            assertTrue(ulps <= 8, v.scenario + ": " + ulps + " ulp from the surface");
            assertEquals(1, hit.normal().length(), 1e-15);
        }
        assertTrue(hits > 100, "only " + hits);
    }

    private static double ulpsFromSurface(Vector v, Vec3 p) {
        // A ray that starts at the point: its parameter 0 is the point itself.
        TorusTruth truth = new TorusTruth(v.center, v.axis, v.major, v.minor, p, v.axis);
        double unit = Math.ulp(Math.max(Math.max(p.maxAbs(), v.center.maxAbs()), v.major + v.minor));
        return Math.abs(truth.distanceAt(BigDecimal.ZERO)) / unit;
    }
}
