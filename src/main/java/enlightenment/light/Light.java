package enlightenment.light;

import enlightenment.check.Check;
import enlightenment.color.DisplayRgb;
import enlightenment.frame.Parallelograms;
import java.util.List;
import java.util.Objects;

/** What gives light. A light never blocks another light. */
public sealed interface Light permits Light.Sphere, Light.Rectangle, Light.Point {

    /** The light's colour: what a viewer sees who looks straight at it. */
    DisplayRgb color();

    /** The name of this kind of light in the scene format. */
    String type();

    /** Points that, with {@link #reach}, bound the light. */
    List<enlightenment.math.ExactPoint> anchors();

    /** No point of the light is farther than this from its nearest anchor's convex hull. */
    double reach();

    /**
     * A glowing ball.
     *
     * @param center its centre
     * @param radius greater than 0
     * @param color its colour
     */
    record Sphere(enlightenment.math.ExactPoint center, double radius, DisplayRgb color) implements Light {
        public Sphere {
            Objects.requireNonNull(center, "center");
            Check.positive("radius", radius);
            Objects.requireNonNull(color, "color");
        }

        @Override
        public String type() {
            return "sphere";
        }

        @Override
        public List<enlightenment.math.ExactPoint> anchors() {
            return List.of(center);
        }

        @Override
        public double reach() {
            return radius;
        }
    }

    /**
     * A glowing parallelogram; it shines to both sides.
     *
     * @param lowerLeft first corner
     * @param upperLeft next corner
     * @param upperRight next corner
     * @param lowerRight last corner
     * @param color its colour
     */
    record Rectangle(
            enlightenment.math.ExactPoint lowerLeft,
            enlightenment.math.ExactPoint upperLeft,
            enlightenment.math.ExactPoint upperRight,
            enlightenment.math.ExactPoint lowerRight,
            DisplayRgb color)
            implements Light {
        public Rectangle {
            Parallelograms.check("corners", lowerLeft, upperLeft, upperRight, lowerRight);
            Objects.requireNonNull(color, "color");
        }

        @Override
        public String type() {
            return "rectangle";
        }

        @Override
        public List<enlightenment.math.ExactPoint> anchors() {
            return List.of(lowerLeft, upperLeft, upperRight, lowerRight);
        }

        @Override
        public double reach() {
            return 0;
        }
    }

    /**
     * A light without extent; it cannot be seen.
     *
     * @param position where it is
     * @param color its colour
     */
    record Point(enlightenment.math.ExactPoint position, DisplayRgb color) implements Light {
        public Point {
            Objects.requireNonNull(position, "position");
            Objects.requireNonNull(color, "color");
        }

        @Override
        public String type() {
            return "point";
        }

        @Override
        public List<enlightenment.math.ExactPoint> anchors() {
            return List.of(position);
        }

        @Override
        public double reach() {
            return 0;
        }
    }
}
