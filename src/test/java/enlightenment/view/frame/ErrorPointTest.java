package enlightenment.view.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class ErrorPointTest {
    private static ErrorPoint at(double seconds) {
        return new ErrorPoint(seconds, 1, 0.1, 0);
    }

    @Test
    void pointsStayInTheirOrder() {
        List<ErrorPoint> points = ErrorPoint.with(ErrorPoint.with(List.of(), at(1)), at(2));
        assertEquals(List.of(at(1), at(2)), points);
    }

    @Test
    void manyPassesMakeFewPointsAndTheLastIsAmongThem() {
        List<ErrorPoint> points = List.of();
        for (int i = 1; i <= 20_000; i++) {
            points = ErrorPoint.with(points, at(i));
        }
        assertTrue(points.size() < 1000, points.size() + " points");
        assertEquals(1, points.get(0).seconds());
        assertEquals(20_000, points.get(points.size() - 1).seconds());
        for (int i = 2; i < points.size() - 1; i++) {
            assertTrue(points.get(i).seconds() >= 1.02 * points.get(i - 1).seconds());
        }
    }

    @Test
    void anotherExposureIsAnotherPoint() {
        List<ErrorPoint> points = List.of(at(1), at(1.001));
        assertEquals(
                3, ErrorPoint.with(points, new ErrorPoint(1.002, 1, 0.1, 2)).size());
    }
}
