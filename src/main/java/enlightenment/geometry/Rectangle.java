package enlightenment.geometry;

import enlightenment.frame.Parallelograms;
import enlightenment.math.ExactPoint;
import java.util.List;

/**
 * A flat parallelogram, visible from both sides. The corners are given in order around it.
 *
 * @param lowerLeft the corner that shows the texture's lower left
 * @param upperLeft the corner that shows the texture's upper left
 * @param upperRight the opposite corner: {@code upperLeft + (lowerRight − lowerLeft)}, up to rounding of the decimals
 * @param lowerRight the corner that shows the texture's lower right; not collinear with the first two
 */
public record Rectangle(ExactPoint lowerLeft, ExactPoint upperLeft, ExactPoint upperRight, ExactPoint lowerRight)
        implements Shape {
    /** Validates the components, as {@link Shape} states. */
    public Rectangle {
        Parallelograms.check("corners", lowerLeft, upperLeft, upperRight, lowerRight);
    }

    @Override
    public String type() {
        return "rectangle";
    }

    @Override
    public List<ExactPoint> anchors() {
        return List.of(lowerLeft, upperLeft, upperRight, lowerRight);
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
        ExactPoint a = transform.apply(lowerLeft);
        ExactPoint b = transform.apply(upperLeft);
        ExactPoint c = transform.apply(upperRight);
        // The fourth corner is exact whatever the others were rounded to.
        ExactPoint d = new ExactPoint(
                a.x().add(c.x()).subtract(b.x()),
                a.y().add(c.y()).subtract(b.y()),
                a.z().add(c.z()).subtract(b.z()));
        return new Rectangle(a, b, c, d);
    }
}
