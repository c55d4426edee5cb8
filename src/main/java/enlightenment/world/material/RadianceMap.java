package enlightenment.world.material;

import enlightenment.numeric.Scale;
import enlightenment.primitive.Hit;
import java.util.Arrays;
import java.util.function.Consumer;

/** The texture by which a surface's radiance is multiplied, with bounds of its factors. Immutable. */
public final class RadianceMap {
    private final TextureLookup texture;

    /** The largest factor of each band. */
    private final double[] largest = new double[3];

    /**
     * @param texture whose colours are linear light
     */
    public RadianceMap(TextureLookup texture) {
        this.texture = texture;
        texture.forEachColor(rgb -> raise(largest, rgb));
    }

    private static void raise(double[] bound, double[] rgb) {
        for (int band = 0; band < bound.length; band++) {
            bound[band] = Math.max(bound[band], rgb[band]);
        }
    }

    /**
     * Writes the factor at a point.
     *
     * @param hit whose primitive, point, normal and face are set; receives the texture coordinates
     */
    public void factor(Hit hit, double[] rgb) {
        hit.primitive.textureCoordinates(hit);
        texture.color(hit.u, hit.v, hit.primitive.repeatsTextures(), rgb);
    }

    /** Roughly the number of texels in a box of texture coordinates, along the side that has more of them. */
    public double texels(double width, double height) {
        return texture.texelsAlong(width, height);
    }

    /** Writes upper bounds of the factors everywhere. */
    public void bound(double[] rgb) {
        System.arraycopy(largest, 0, rgb, 0, largest.length);
    }

    /** Writes upper bounds of the factors where texture coordinates lie in a box. */
    public void bound(double u0, double v0, double u1, double v1, double[] rgb) {
        // Rounded coordinates of a point of the box may lie a little beside it.
        double slack =
                Scale.gamma(64) * (1 + Math.max(Math.abs(u0), Math.abs(u1)) + Math.max(Math.abs(v0), Math.abs(v1)));
        boolean isKnown = texture.forEachColor(u0 - slack, v0 - slack, u1 + slack, v1 + slack, new Bound(rgb));
        if (!isKnown) {
            bound(rgb);
        }
    }

    /** Collects the largest factor of each band. */
    private record Bound(double[] rgb) implements Consumer<double[]> {
        Bound {
            Arrays.fill(rgb, 0);
        }

        @Override
        public void accept(double[] texel) {
            raise(rgb, texel);
        }
    }

    /** A text that is equal for maps that look the same, on every machine. */
    String look() {
        return texture.look();
    }
}
