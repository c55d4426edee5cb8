package enlightenment.light;

import enlightenment.check.Check;
import enlightenment.color.Color;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.frame.Parallelograms;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;

/**
 * A light of a scene, such as an emitting sphere or a spotlight: an immutable description in scene coordinates, validated when it is made.
 * In classic shading a light never occludes another light, and only its colour is used; in physical shading its surface is black and
 * opaque, and its emission is used.
 *
 * <p>The constructors throw {@link enlightenment.math.InvalidValueException}, with the key of the scene format, for a value out of range or
 * a degenerate light, and {@link NullPointerException} for a missing value.
 */
public sealed interface Light permits Light.Sphere, Light.Rectangle, Light.FromPoint, Light.Distant {

    /** The light's colour: in classic shading, what a viewer looking straight at it sees. */
    Color color();

    /** The emission that the colour is multiplied by. */
    Emission emission();

    /** The emitted light: linear colour times the value of {@link #emission}, in its quantity. */
    default Rgb emitted() {
        return color().linear().times(emission().value());
    }

    /** The emitted near ultraviolet (300 to 400 nm), in the quantity of {@link #emission}, independent of colour. */
    default double ultraviolet() {
        return emission().ultraviolet();
    }

    /** Whether the light has a surface; others emit from one point, or from infinity. */
    default boolean hasSurface() {
        return true;
    }

    /** Whether the light can be used in classic shading. */
    default boolean isForClassicShading() {
        return true;
    }

    /** The name of this kind of light in the scene format, such as {@code "sphere"}. */
    String type();

    /** Points that give the light's position, none for a distant one; the light lies within {@link #reach} of their convex hull. */
    List<ExactPoint> anchors();

    /** How far the light reaches beyond the convex hull of its {@link #anchors}, at most: in scene units, at least 0. */
    double reach();

    /**
     * An emitting ball.
     *
     * @param center its centre
     * @param radius greater than 0
     * @param color its colour
     * @param emission radiance or power; radiance = power / (4 π² radius²)
     */
    record Sphere(ExactPoint center, double radius, Color color, Emission emission) implements Light {
        /** Validates the components, as {@link Light} states. */
        public Sphere {
            Objects.requireNonNull(center, "center");
            Check.positive("radius", radius);
            Emissions.checkSurface("sphere", color, emission);
        }

        /** A ball of this colour and radiance 1. */
        public Sphere(ExactPoint center, double radius, Color color) {
            this(center, radius, color, Emission.RADIANCE_1);
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
     * An emitting parallelogram. The corners are given in order around it.
     *
     * @param lowerLeft first corner
     * @param upperLeft next corner
     * @param upperRight the corner opposite to the first: {@code upperLeft + (lowerRight − lowerLeft)}, up to rounding of the decimals
     * @param lowerRight last corner; not collinear with the first two
     * @param color its colour
     * @param twoSided whether it emits from both sides, or only from its front: the side that (upperLeft − lowerLeft) × (lowerRight −
     *     lowerLeft) points to, from which the corners look as they are named. In classic shading it emits from both
     * @param emission radiance or power; radiance = power / (π area), or with both sides power / (2 π area)
     */
    record Rectangle(
            ExactPoint lowerLeft,
            ExactPoint upperLeft,
            ExactPoint upperRight,
            ExactPoint lowerRight,
            Color color,
            boolean twoSided,
            Emission emission)
            implements Light {
        /** Validates the components, as {@link Light} states. */
        public Rectangle {
            Parallelograms.check("corners", lowerLeft, upperLeft, upperRight, lowerRight);
            Emissions.checkSurface("rectangle", color, emission);
        }

        /** A parallelogram of this colour that emits radiance 1 from both sides. */
        public Rectangle(
                ExactPoint lowerLeft, ExactPoint upperLeft, ExactPoint upperRight, ExactPoint lowerRight, Color color) {
            this(lowerLeft, upperLeft, upperRight, lowerRight, color, true, Emission.RADIANCE_1);
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

    /** A light without extent. */
    sealed interface FromPoint extends Light permits Point, Spot, Projector, Ies {
        /** The position of the light. */
        ExactPoint position();

        @Override
        default boolean hasSurface() {
            return false;
        }

        @Override
        default List<ExactPoint> anchors() {
            return List.of(position());
        }

        @Override
        default double reach() {
            return 0;
        }
    }

    /**
     * A light without extent, which cannot be seen.
     *
     * @param position of the light
     * @param color its colour
     * @param emission intensity or power; intensity = power / (4 π)
     */
    record Point(ExactPoint position, Color color, Emission emission) implements FromPoint {
        /** Validates the components, as {@link Light} states. */
        public Point {
            Objects.requireNonNull(position, "position");
            Emissions.checkPoint("point", color, emission);
        }

        /** A point light of this colour and intensity 1. */
        public Point(ExactPoint position, Color color) {
            this(position, color, Emission.INTENSITY_1);
        }

        @Override
        public String type() {
            return "point";
        }
    }

    /**
     * A spotlight, which cannot be seen. Up to {@code innerAngle} from the direction its intensity is the full one, at {@code angle} it is
     * 0, and between them it falls by the cubic smoothstep of the cosine. For physical shading.
     *
     * @param position of the light
     * @param direction the axis of the cone, of any length
     * @param angle between the axis and where it is dark, in degrees: above 0, at most 180
     * @param innerAngle between the axis and where the intensity begins to fall, in degrees: 0..{@code angle}
     * @param color its colour
     * @param emission intensity on the axis, or power; intensity = power / (2π (1 − (cos {@code innerAngle} + cos {@code angle}) / 2))
     */
    record Spot(ExactPoint position, Vec3 direction, double angle, double innerAngle, Color color, Emission emission)
            implements FromPoint {
        /** Validates the components, as {@link Light} states. */
        public Spot {
            Objects.requireNonNull(position, "position");
            Objects.requireNonNull(direction, "direction");
            Check.direction("direction", direction);
            Check.that(angle > 0 && angle <= 180, "angle", "must be above 0 and at most 180 degrees, not " + angle);
            Check.that(
                    innerAngle >= 0 && innerAngle <= angle,
                    "innerAngle",
                    "must lie in 0.." + angle + ", where \"angle\" is, not " + innerAngle);
            Emissions.checkPoint("spot", color, emission);
        }

        @Override
        public String type() {
            return "spot";
        }

        @Override
        public boolean isForClassicShading() {
            return false;
        }
    }

    /**
     * A point light whose intensity by direction is in an IES file; it cannot be seen. For physical shading. The file is read when a scene
     * is rendered.
     *
     * @param position of the light
     * @param file the path of the file
     * @param direction the nadir axis, from which the file's vertical angles are counted, of any length
     * @param rotation degrees by which the luminaire is rotated around that axis, in the direction of growing horizontal angles; at 0 the
     *     horizontal angle 0 is the image of the x axis under the smallest rotation from −y to {@code direction}. Seen against that,
     *     horizontal angles grow clockwise: with −y from +x towards −z
     * @param color its colour
     * @param emission intensity: the factor of the file's candelas; or power
     */
    record Ies(ExactPoint position, Path file, Vec3 direction, double rotation, Color color, Emission emission)
            implements FromPoint {
        /** Validates the components, as {@link Light} states. */
        public Ies {
            Objects.requireNonNull(position, "position");
            Objects.requireNonNull(file, "file");
            Objects.requireNonNull(direction, "direction");
            Check.direction("direction", direction);
            Check.finite("rotation", rotation);
            Emissions.checkPoint("ies", color, emission);
        }

        @Override
        public String type() {
            return "ies";
        }

        @Override
        public boolean isForClassicShading() {
            return false;
        }
    }

    /**
     * A point light that projects a picture; it cannot be seen. Its intensity in a direction is multiplied by the picture there, as linear
     * light; outside of the picture it is 0. Seen along {@code direction} the picture is upright and not mirrored. For physical shading.
     *
     * @param position of the light
     * @param picture the picture; white is the full intensity
     * @param direction through the middle of the picture, of any length
     * @param up points to the picture's upper edge; not parallel to {@code direction}
     * @param fieldOfView across the picture's width, in degrees: above 0, below 180
     * @param color its colour
     * @param emission intensity of white, or power: of all bands together, by luminance
     */
    record Projector(
            ExactPoint position,
            Texture.File picture,
            Vec3 direction,
            Vec3 up,
            double fieldOfView,
            Color color,
            Emission emission)
            implements FromPoint {
        /** Validates the components, as {@link Light} states. */
        public Projector {
            Objects.requireNonNull(position, "position");
            Objects.requireNonNull(picture, "picture");
            Objects.requireNonNull(direction, "direction");
            Objects.requireNonNull(up, "up");
            Check.direction("direction", direction);
            Check.direction("up", up);
            Check.that(
                    direction.normalized().cross(up.normalized()).maxAbs() > 0,
                    "up",
                    "must not be parallel to \"direction\"");
            Check.that(
                    fieldOfView > 0 && fieldOfView < 180,
                    "fieldOfView",
                    "must be above 0 and below 180 degrees, not " + fieldOfView);
            Emissions.checkPoint("projector", color, emission);
        }

        @Override
        public String type() {
            return "projector";
        }

        @Override
        public boolean isForClassicShading() {
            return false;
        }
    }

    /**
     * A disk at infinity of constant radiance, such as the sun's: visible where nothing occludes it, and in reflections. For physical
     * shading.
     *
     * @param direction the direction in which its light travels, of any length
     * @param angle the angular diameter of the disk, in degrees: {@link #LEAST_ANGLE}..{@link #GREATEST_ANGLE}. At the least one the shadow
     *     of an edge a metre away is 0.2 mm wide
     * @param color its colour
     * @param emission irradiance on a surface perpendicular to {@code direction}; radiance = irradiance / (π sin² ({@code angle} / 2)). No
     *     ultraviolet
     */
    record Distant(Vec3 direction, double angle, Color color, Emission emission) implements Light {
        /** The least angle: BSDF samples still hit such a disk, so that every method converges to all of its light. */
        public static final double LEAST_ANGLE = 0.01;

        /** The greatest angle: wider sources are for environment maps. */
        public static final double GREATEST_ANGLE = 20;

        /** The angular diameter of the sun as seen from the earth, in degrees. */
        public static final double USUAL_ANGLE = 0.53;

        /** Validates the components, as {@link Light} states. */
        public Distant {
            Objects.requireNonNull(direction, "direction");
            Check.direction("direction", direction);
            Check.that(
                    angle >= LEAST_ANGLE && angle <= GREATEST_ANGLE,
                    "angle",
                    "must lie in " + LEAST_ANGLE + ".." + (int) GREATEST_ANGLE + " degrees, not " + angle);
            Objects.requireNonNull(color, "color");
            Objects.requireNonNull(emission, "emission");
            double sine = StrictMath.sin(StrictMath.toRadians(angle / 2));
            Emissions.checkDistant(color, emission, 1 / (Math.PI * sine * sine));
        }

        /** A disk as wide as the sun's, of this irradiance. */
        public Distant(Vec3 direction, Rgb irradiance) {
            this(direction, USUAL_ANGLE, DisplayRgb.WHITE, Emission.irradiance(irradiance));
        }

        @Override
        public String type() {
            return "distant";
        }

        @Override
        public boolean hasSurface() {
            return false;
        }

        @Override
        public boolean isForClassicShading() {
            return false;
        }

        @Override
        public List<ExactPoint> anchors() {
            return List.of();
        }

        @Override
        public double reach() {
            return 0;
        }
    }
}
