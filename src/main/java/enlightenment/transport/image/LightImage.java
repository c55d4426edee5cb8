package enlightenment.transport.image;

import enlightenment.world.light.PhysicalLight;
import java.util.Arrays;

/**
 * Where the eye sees a light straight, in one mirror, or by a longer chain of reflections and refractions: a convex polygon around it, in
 * pixels from the picture's upper left corner. Immutable.
 */
final class LightImage {
    /** Instead of a mirror's id: the light is seen straight. */
    static final int STRAIGHT = -1;

    /** Instead of a mirror's face: any. */
    static final int ANY_FACE = -1;

    /** The light's index. */
    final int light;

    /** The mirror's id, or {@link #STRAIGHT}. */
    final int mirror;

    /** The mirror's face, or {@link #ANY_FACE}. */
    final int face;

    /** The {@link SpecularChain} that it is seen by; none if it is seen straight or in one mirror. */
    final long chain;

    /** The light's radiance, or what the chain leaves of it, in the band that it is brightest in; greater than 0. */
    final double brightness;

    /** The corners, in order; not to be changed. */
    final double[] x;

    final double[] y;
    private final double left;
    private final double right;
    private final double top;
    private final double bottom;

    /**
     * @param light the light's index
     * @param from the light
     * @param x the corners, in order, with the inside to the left of each side where x points to the right and y upwards
     * @param y as many
     */
    LightImage(int light, PhysicalLight from, int mirror, int face, double[] x, double[] y) {
        this(light, brightness(from), mirror, face, SpecularChain.NONE, x, y);
    }

    /**
     * @param brightness what the chain leaves of the light's radiance
     * @param chain that the light is seen by
     */
    LightImage(int light, double brightness, long chain, double[] x, double[] y) {
        this(light, brightness, STRAIGHT, ANY_FACE, chain, x, y);
    }

    private LightImage(int light, double brightness, int mirror, int face, long chain, double[] x, double[] y) {
        this.light = light;
        this.mirror = mirror;
        this.face = face;
        this.x = x;
        this.y = y;
        this.brightness = brightness;
        this.chain = chain;
        left = Arrays.stream(x).min().orElseThrow();
        right = Arrays.stream(x).max().orElseThrow();
        top = Arrays.stream(y).min().orElseThrow();
        bottom = Arrays.stream(y).max().orElseThrow();
    }

    /** A light's radiance in the band that it is brightest in. */
    static double brightness(PhysicalLight l) {
        return Math.max(l.r, Math.max(l.g, l.b));
    }

    /** Whether it is seen by a chain of this kind, of more than one reflection. */
    boolean isSeenBy(long events) {
        return chain == events && chain != SpecularChain.NONE;
    }

    /** Whether it is seen straight, but for panes. */
    boolean isStraight() {
        return mirror == STRAIGHT && chain == SpecularChain.NONE;
    }

    /** The polygon's area in pixels. */
    double area() {
        return ClippedPolygon.area(x, y, x.length);
    }

    /** Whether the boxes around two polygons overlap. */
    boolean overlaps(LightImage other) {
        return reaches(other.left, other.top, other.right, other.bottom);
    }

    /** Whether the polygon's own box reaches into a box. */
    boolean reaches(double x0, double y0, double x1, double y1) {
        return left < x1 && right > x0 && top < y1 && bottom > y0;
    }
}
