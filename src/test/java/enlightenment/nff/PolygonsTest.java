package enlightenment.nff;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Triangle;
import enlightenment.math.ExactPoint;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Areas are exact, in decimals. */
class PolygonsTest {
    /** A flat polygon: (u, v) lifted into the plane z = 2u + 3v + 1, so that doubled areas in xy stay whole. */
    private static List<ExactPoint> polygon(double... uv) {
        List<ExactPoint> points = new ArrayList<>();
        for (int i = 0; i < uv.length; i += 2) {
            points.add(ExactPoint.of(uv[i], uv[i + 1], 2 * uv[i] + 3 * uv[i + 1] + 1));
        }
        return points;
    }

    private static List<Shape> parts(List<ExactPoint> polygon) {
        return Polygons.parts(polygon).orElseThrow();
    }

    /** Twice the signed area in the xy plane. */
    private static BigDecimal twiceArea(List<ExactPoint> ring) {
        BigDecimal sum = BigDecimal.ZERO;
        for (int i = 0; i < ring.size(); i++) {
            ExactPoint p = ring.get(i);
            ExactPoint q = ring.get((i + 1) % ring.size());
            sum = sum.add(p.x().multiply(q.y())).subtract(p.y().multiply(q.x()));
        }
        return sum;
    }

    /** All parts have the polygon's orientation and together its area: so they cover it once. */
    private static void assertCovers(List<ExactPoint> polygon, List<Shape> parts) {
        BigDecimal whole = twiceArea(polygon);
        BigDecimal sum = BigDecimal.ZERO;
        for (Shape part : parts) {
            BigDecimal area = twiceArea(part.anchors());
            assertEquals(whole.signum(), area.signum(), () -> part + " is turned over");
            assertTrue(polygon.containsAll(part.anchors()), () -> part + " has a vertex that is not the polygon's");
            sum = sum.add(area);
        }
        assertEquals(0, whole.compareTo(sum), "area " + whole + " became " + sum);
    }

    @Test
    void aParallelogramIsOneRectangle() {
        List<ExactPoint> p = polygon(0, 0, 4, 1, 5, 4, 1, 3);
        assertEquals(List.of(new Rectangle(p.get(0), p.get(1), p.get(2), p.get(3))), parts(p));
    }

    @Test
    void aQuadrilateralThatMissesAParallelogramByOneDigitIsTwoTriangles() {
        List<ExactPoint> p = List.of(
                ExactPoint.of("0", "0", "0"),
                ExactPoint.of("1", "0", "0"),
                ExactPoint.of("1", "1.0000001", "0"),
                ExactPoint.of("0", "1", "0"));
        assertEquals(2, parts(p).size());
        assertCovers(p, parts(p));
    }

    @Test
    void aConcaveQuadrilateralIsCutAtItsInnerCorner() {
        List<ExactPoint> dart = polygon(0, 0, 4, 0, 1, 1, 0, 4);
        for (int turn = 0; turn < 4; turn++) {
            Collections.rotate(dart, 1);
            List<Shape> parts = parts(dart);
            assertEquals(2, parts.size());
            assertCovers(dart, parts);
            for (Shape t : parts) {
                assertTrue(t.anchors().contains(ExactPoint.of(1, 1, 6)), "every part has the inner corner");
            }
        }
    }

    @Test
    void aStarIsCoveredOnceInEitherOrientation() {
        List<ExactPoint> star = polygon(0, 5, -1, 1, -5, 1, -2, -1, -3, -5, 0, -2, 3, -5, 2, -1, 5, 1, 1, 1);
        assertCovers(star, parts(star));
        Collections.reverse(star);
        assertCovers(star, parts(star));
        assertEquals(8, parts(star).size());
    }

    @Test
    void aCombWithTeethOfAllLengthsIsCoveredOnce() {
        SplittableRandom random = new SplittableRandom(7);
        List<Double> uv = new ArrayList<>(List.of(40.0, -1.0, 0.0, -1.0));
        for (int i = 0; i <= 40; i++) {
            uv.add((double) i);
            uv.add(i % 2 == 0 ? 0 : 1 + (double) random.nextInt(50));
        }
        List<ExactPoint> comb = polygon(uv.stream().mapToDouble(d -> d).toArray());
        assertCovers(comb, parts(comb));
        assertEquals(comb.size() - 2, parts(comb).size());
    }

    @Test
    void verticesInTheMiddleOfSidesBelongToTheParts() {
        List<ExactPoint> square = polygon(0, 0, 1, 0, 2, 0, 2, 1, 2, 2, 1, 2, 0, 2, 0, 1);
        List<Shape> parts = parts(square);
        assertEquals(6, parts.size());
        assertCovers(square, parts);
    }

    @Test
    void aHoleJoinedByACutStaysOpen() {
        List<ExactPoint> frame = polygon(0, 0, 9, 0, 9, 9, 0, 9, 0, 0, 3, 3, 3, 6, 6, 6, 6, 3, 3, 3);
        List<Shape> parts = parts(frame);
        assertCovers(frame, parts);
        assertEquals(BigDecimal.valueOf(2 * (81 - 9)), twiceArea(frame));
        for (Shape t : parts) {
            double u =
                    t.anchors().stream().mapToDouble(p -> p.x().doubleValue()).sum() / 3;
            double v =
                    t.anchors().stream().mapToDouble(p -> p.y().doubleValue()).sum() / 3;
            assertTrue(!(u > 3 && u < 6 && v > 3 && v < 6), () -> t + " lies in the hole");
        }
    }

    @Test
    void repeatedVerticesCountOnce() {
        List<ExactPoint> p = polygon(0, 0, 0, 0, 3, 0, 3, 0, 0, 3, 0, 0);
        assertEquals(List.of(new Triangle(p.get(5), p.get(2), p.get(4))).size(), parts(p).size());
        assertCovers(polygon(0, 0, 3, 0, 0, 3), parts(p));
    }

    @Test
    void aLineHasNoParts() {
        assertEquals(List.of(), parts(polygon(0, 0, 1, 1, 2, 2, 5, 5)));
        assertEquals(List.of(), parts(polygon(1, 1, 1, 1, 1, 1)));
    }

    @Test
    void aPolygonThatCrossesItselfIsRefused() {
        assertEquals(Optional.empty(), Polygons.parts(polygon(0, 0, 2, 2, 2, 0, 0, 1)));
        List<ExactPoint> pentagram = polygon(0, 10, -6, -8, 9.5, 3, -9.5, 3, 6, -8);
        assertEquals(Optional.empty(), Polygons.parts(pentagram));
    }

    @Test
    void polygonsThatStandOnEdgeAreSeenFromTheirSide() {
        List<ExactPoint> wall =
                List.of(ExactPoint.of(5, 0, 0), ExactPoint.of(5, 3, 0), ExactPoint.of(5, 1, 1), ExactPoint.of(5, 0, 3));
        assertEquals(2, parts(wall).size());
    }

    @Test
    void decisionsDoNotDependOnWhereThePolygonStands() {
        // The inner corner is a millionth off the diagonal: doubles near 1e15 could not see it.
        BigDecimal far = new BigDecimal("1e15");
        List<ExactPoint> dart = new ArrayList<>();
        for (String[] uv : new String[][] {{"0", "0"}, {"1", "0"}, {"0.499999", "0.5"}, {"0", "1"}}) {
            dart.add(new ExactPoint(far.add(new BigDecimal(uv[0])), far.add(new BigDecimal(uv[1])), far));
        }
        List<Shape> parts = parts(dart);
        assertEquals(2, parts.size());
        assertCovers(dart, parts);
    }
}
