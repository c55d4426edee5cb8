package enlightenment.geometry;

import enlightenment.math.Point;
import enlightenment.math.SceneFrame;
import java.util.List;

/**
 * A flat parallelogram, seen from both sides.
 *
 * @param lowerLeft the corner where the texture's lower left lies
 * @param upperLeft next corner
 * @param upperRight next corner
 * @param lowerRight last corner; closes the parallelogram
 */
public record Rectangle(Point lowerLeft, Point upperLeft, Point upperRight, Point lowerRight) implements Shape {
    public Rectangle {
        Parallelograms.check("corners", lowerLeft, upperLeft, upperRight, lowerRight);
    }

    @Override
    public String type() {
        return "rectangle";
    }

    @Override
    public Primitive place(SceneFrame frame) {
        return new RectanglePrimitive(
                Parallelograms.lostNormal(lowerLeft, upperLeft, lowerRight, frame),
                frame.toFrame(lowerLeft),
                frame.toFrame(upperLeft),
                frame.toFrame(upperRight),
                frame.toFrame(lowerRight));
    }

    @Override
    public List<Point> anchors() {
        return List.of(lowerLeft, upperLeft, upperRight, lowerRight);
    }

    @Override
    public double reach() {
        return 0;
    }
}
