package enlightenment.geometry;

import enlightenment.math.Check;
import enlightenment.math.Point;
import enlightenment.math.SceneFrame;
import java.util.List;

/**
 * A flat triangle, seen from both sides.
 *
 * @param a first vertex
 * @param b second vertex
 * @param c third vertex; not in line with the others
 */
public record Triangle(Point a, Point b, Point c) implements Shape {
    public Triangle {
        Check.that(!Parallelograms.collinear(a, b, c), "vertices", "must not lie in one line");
    }

    @Override
    public String type() {
        return "triangle";
    }

    @Override
    public Primitive place(SceneFrame frame) {
        return new TrianglePrimitive(
                Parallelograms.lostNormal(a, b, c, frame), frame.toFrame(a), frame.toFrame(b), frame.toFrame(c));
    }

    @Override
    public List<Point> anchors() {
        return List.of(a, b, c);
    }

    @Override
    public double reach() {
        return 0;
    }
}
