package enlightenment.geometry;

import enlightenment.check.Check;
import enlightenment.frame.Parallelograms;
import enlightenment.math.ExactPoint;
import java.util.List;

/**
 * A flat triangle, seen from both sides.
 *
 * @param a first vertex
 * @param b second vertex
 * @param c third vertex; not in line with the others
 */
public record Triangle(ExactPoint a, ExactPoint b, ExactPoint c) implements Shape {
    public Triangle {
        Check.that(!Parallelograms.collinear(a, b, c), "vertices", "must not lie in one line");
    }

    @Override
    public String type() {
        return "triangle";
    }

    @Override
    public List<ExactPoint> anchors() {
        return List.of(a, b, c);
    }

    @Override
    public double reach() {
        return 0;
    }
}
