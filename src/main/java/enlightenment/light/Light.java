package enlightenment.light;

import enlightenment.check.Check;
import enlightenment.color.DisplayRgb;
import enlightenment.frame.Parallelograms;
import enlightenment.math.ExactPoint;
import java.util.List;
import java.util.Objects;

/**
 * A light: an immutable description in scene coordinates and scene units, exact, validated when it is made. A light never
 * occludes another light.
 *
 * <p>The constructors throw {@link enlightenment.math.InvalidValueException}, with the key of the scene format, for a value out
 * of range or a degenerate light, and {@link NullPointerException} for a missing value.
 */
public sealed interface Light permits Light.Sphere, Light.Rectangle, Light.Point {

    /** The light's colour: what a viewer looking straight at it sees. */
    DisplayRgb color();

    /** The name of this kind of light in the scene format, such as {@code "sphere"}. */
    String type();

    /** Points that give the light's position, at least one; the light lies within {@link #reach} of their convex hull. */
    List<ExactPoint> anchors();

    /** How far the light reaches beyond the convex hull of its {@link #anchors}, at most: in scene units, at least 0. */
    double reach();

    /**
     * A glowing ball.
     *
     * @param center its centre
     * @param radius greater than 0
     * @param color its colour
     */
    record Sphere(ExactPoint center, double radius, DisplayRgb color) implements Light {
        /** Validates the components, as {@link Light} states. */
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
        public List<ExactPoint> anchors() {
            return List.of(center);
        }

        @Override
        public double reach() {
            return radius;
        }
    }

    /**
     * A glowing parallelogram that emits to both sides. The corners are given in order around it.
     *
     * @param lowerLeft first corner
     * @param upperLeft next corner
     * @param upperRight the corner opposite to the first: {@code upperLeft + (lowerRight − lowerLeft)}, up to rounding of the
     *     decimals
     * @param lowerRight last corner; not collinear with the first two
     * @param color its colour
     */
    record Rectangle(
            ExactPoint lowerLeft, ExactPoint upperLeft, ExactPoint upperRight, ExactPoint lowerRight, DisplayRgb color)
            implements Light {
        /** Validates the components, as {@link Light} states. */
        public Rectangle {
            Parallelograms.check("corners", lowerLeft, upperLeft, upperRight, lowerRight);
            Objects.requireNonNull(color, "color");
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

    /**
     * A light without extent; it cannot be seen.
     *
     * @param position where it is
     * @param color its colour
     */
    record Point(ExactPoint position, DisplayRgb color) implements Light {
        /** Validates the components, as {@link Light} states. */
        public Point {
            Objects.requireNonNull(position, "position");
            Objects.requireNonNull(color, "color");
        }

        @Override
        public String type() {
            return "point";
        }

        @Override
        public List<ExactPoint> anchors() {
            return List.of(position);
        }

        @Override
        public double reach() {
            return 0;
        }
    }
}
