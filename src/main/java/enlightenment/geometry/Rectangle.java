package enlightenment.geometry;

import enlightenment.frame.Parallelograms;
import enlightenment.math.ExactPoint;
import java.util.List;

/**
 * A flat parallelogram, seen from both sides.
 *
 * @param lowerLeft the corner where the texture's lower left lies
 * @param upperLeft next corner
 * @param upperRight next corner
 * @param lowerRight last corner; closes the parallelogram
 */
public record Rectangle(ExactPoint lowerLeft, ExactPoint upperLeft, ExactPoint upperRight, ExactPoint lowerRight)
        implements Shape {
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
}
