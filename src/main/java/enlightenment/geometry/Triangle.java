package enlightenment.geometry;

import enlightenment.check.Check;
import enlightenment.math.ExactPoint;
import java.util.List;

/**
 * A flat triangle, visible from both sides.
 *
 * @param a the vertex that shows the texture's lower left
 * @param b the vertex that shows the texture's upper left
 * @param c the vertex that shows the texture's lower right; not collinear with the others
 */
public record Triangle(ExactPoint a, ExactPoint b, ExactPoint c) implements Shape {
    /** Validates the components, as {@link Shape} states. */
    public Triangle {
        Check.that(!ExactPoint.areCollinear(a, b, c), "vertices", "must not lie in one line");
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

    @Override
    public boolean enclosesVolume() {
        return false;
    }

    @Override
    public Shape placed(Transform transform) {
        return new Triangle(transform.apply(a), transform.apply(b), transform.apply(c));
    }
}
