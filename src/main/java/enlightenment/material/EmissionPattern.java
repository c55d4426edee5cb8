package enlightenment.material;

import java.util.Objects;
import java.util.Optional;

/**
 * How what a surface emits depends on the point and on the side of the surface. Immutable.
 *
 * @param map the factor, by band and in linear light, that {@link Material#radiance} is multiplied by at each point of the surface; that
 *     of {@link Material#ultraviolet} is the blue one. Empty if all points emit alike
 * @param side the sides that emit
 */
public record EmissionPattern(Optional<Texture> map, Side side) {
    /** All points emit alike, to both sides. */
    public static final EmissionPattern EVEN = new EmissionPattern(Optional.empty(), Side.BOTH);

    /** The sides of a surface that emit. */
    public enum Side {
        /** Both sides. */
        BOTH,

        /**
         * The front alone: the side that the geometric normal points to. That is the outside of balls, boxes, cylinders, cones and tori; the side
         * that (upperLeft − lowerLeft) × (lowerRight − lowerLeft) of a rectangle points to, that a disk's normal points to, and, of a triangle with the
         * corners a, b, c, also in a mesh, the side that (b − a) × (c − a) points to once it is placed.
         */
        FRONT,

        /** The other side alone: the inside of balls, boxes, cylinders, cones and tori. */
        BACK
    }

    /** Both must be there. */
    public EmissionPattern {
        Objects.requireNonNull(map, "radianceMap");
        Objects.requireNonNull(side, "radianceSide");
    }

    /** Emission to both sides. */
    public static EmissionPattern of(Optional<Texture> map) {
        return new EmissionPattern(map, Side.BOTH);
    }

    /** This pattern with another factor. */
    public EmissionPattern withMap(Texture value) {
        return new EmissionPattern(Optional.of(value), side);
    }

    /** This pattern on other sides. */
    public EmissionPattern withSide(Side value) {
        return new EmissionPattern(map, value);
    }
}
