package enlightenment.world.material;

import enlightenment.primitive.Hit;
import enlightenment.sampling.Hash;
import java.util.List;

/**
 * The part of a material that decides, at a point, what the surface is made of there: one of several materials, a hole, or the same with
 * another normal. Immutable.
 *
 * <p>Random numbers are hashes of the position, so that all paths find the same there.
 */
public final class SurfaceDetail {
    /** The kinds of detail. */
    enum Kind {
        MIX,
        MASK,
        ROUGHNESS,
        CLEARCOAT_ROUGHNESS,
        NORMAL_MAP,
        BUMP
    }

    private static final long MIX_NUMBER = 0x6d69780000000001L;
    private static final long MASK_NUMBER = 0x6d61736b00000001L;

    private static final long ROUGHNESS_NUMBER = 0x726f756700000001L;

    private static final long CLEARCOAT_NUMBER = 0x636c656100000001L;

    private final Kind kind;

    /** The two materials of a mix, one for each roughness level, or one otherwise. */
    private final SurfaceMaterial[] parts;

    private final AmountLookup amount;

    /** The texture of {@link #amount}. */
    private final TextureLookup map;

    /** The roughness of each part; null if parts do not differ in roughness. */
    private final RoughnessLevels levels;

    private final double height;

    /** Purpose of the random numbers: different from that of each nested detail, so that they are independent. */
    private final long purpose;

    private SurfaceDetail(
            Kind kind, SurfaceMaterial[] parts, AmountLookup amount, double height, RoughnessLevels levels) {
        this.kind = kind;
        this.parts = parts;
        this.amount = amount;
        map = amount.map();
        this.height = height;
        this.levels = levels;
        long number =
                switch (kind) {
                    case MIX -> MIX_NUMBER;
                    case ROUGHNESS -> ROUGHNESS_NUMBER;
                    case CLEARCOAT_ROUGHNESS -> CLEARCOAT_NUMBER;
                    default -> MASK_NUMBER;
                };
        purpose = Hash.next(number, depth());
    }

    private static SurfaceDetail ofOne(Kind kind, SurfaceMaterial of, AmountLookup amount, double height) {
        return new SurfaceDetail(kind, new SurfaceMaterial[] {of}, amount, height, null);
    }

    /** The largest number of nested details. */
    private int depth() {
        int inside = 0;
        for (SurfaceMaterial part : parts) {
            inside = Math.max(inside, part.detail == null ? 0 : part.detail.depth());
        }
        return 1 + inside;
    }

    /** One of two materials at random: the second with probability weight. */
    public static SurfaceDetail mix(SurfaceMaterial first, SurfaceMaterial second, AmountLookup weight) {
        return new SurfaceDetail(Kind.MIX, new SurfaceMaterial[] {first, second}, weight, 0, null);
    }

    /** One of several materials that differ in roughness, at random: of the two levels next to the texture's roughness. */
    public static SurfaceDetail ofRoughness(
            RoughnessLevels levels, List<SurfaceMaterial> parts, AmountLookup roughness) {
        return new SurfaceDetail(Kind.ROUGHNESS, parts.toArray(SurfaceMaterial[]::new), roughness, 0, levels);
    }

    /** One of several materials that differ in the roughness of their clear coat, at random, as {@link #ofRoughness}. */
    public static SurfaceDetail ofClearcoatRoughness(
            RoughnessLevels levels, List<SurfaceMaterial> parts, AmountLookup roughness) {
        return new SurfaceDetail(Kind.CLEARCOAT_ROUGHNESS, parts.toArray(SurfaceMaterial[]::new), roughness, 0, levels);
    }

    /** An alpha mask: the surface exists with probability alpha, else there is a hole. */
    public static SurfaceDetail mask(SurfaceMaterial of, AmountLookup alpha) {
        return ofOne(Kind.MASK, of, alpha, 0);
    }

    /** A normal map: the normal is given by a texture in the basis of its own directions. */
    public static SurfaceDetail normalMap(SurfaceMaterial of, TextureLookup map) {
        return ofOne(Kind.NORMAL_MAP, of, AmountLookup.mean(map), 0);
    }

    /** A bump map: the normal is that of a surface displaced by a texture times a height. */
    public static SurfaceDetail bump(SurfaceMaterial of, TextureLookup map, double height) {
        return ofOne(Kind.BUMP, of, AmountLookup.mean(map), height);
    }

    /** Whether this detail reads an image. */
    boolean hasImage() {
        return map.hasImage();
    }

    /** The materials that this detail may resolve to. */
    public SurfaceMaterial[] parts() {
        return parts.clone();
    }

    /** Whether this detail changes shading normals. */
    public boolean turnsNormal() {
        return kind == Kind.NORMAL_MAP || kind == Kind.BUMP;
    }

    /** Whether this detail may leave holes. */
    public boolean isMask() {
        return kind == Kind.MASK;
    }

    /** The material of the surface at a hit, which may have detail of its own. */
    public SurfaceMaterial at(Hit hit, double[] scratch) {
        return switch (kind) {
            case MIX -> parts[number(hit) < value(hit, scratch) ? 1 : 0];
            case ROUGHNESS, CLEARCOAT_ROUGHNESS -> parts[levels.at(value(hit, scratch), number(hit))];
            default -> parts[0];
        };
    }

    /** Whether an alpha mask has a hole at a hit. */
    public boolean isHole(Hit hit, double[] scratch) {
        return number(hit) >= value(hit, scratch);
    }

    private double number(Hit hit) {
        return Hash.unit(Hash.of(
                purpose + Double.doubleToLongBits(hit.px),
                Double.doubleToLongBits(hit.py),
                Double.doubleToLongBits(hit.pz)));
    }

    /** The amount at a hit. */
    private double value(Hit hit, double[] scratch) {
        if (map.isTextured()) {
            hit.primitive.textureCoordinates(hit);
        }
        return value(hit.u, hit.v, hit, scratch);
    }

    private double value(double u, double v, Hit hit, double[] rgb) {
        if (map.isTextured()) {
            map.color(u, v, hit.primitive.repeatsTextures(), rgb);
        } else {
            map.color(rgb);
        }
        return amount.of(rgb);
    }

    /**
     * Changes a hit's shading normal.
     *
     * @param hit with a shading normal, and the directions of its texture
     * @return whether it is changed, to a normal on the same side of the surface
     */
    public boolean turn(Hit hit, double[] scratch) {
        if (!hit.primitive.textureDirections(hit)) {
            return false;
        }
        hit.primitive.textureCoordinates(hit);
        return kind == Kind.BUMP ? turnByHeights(hit, scratch) : turnByNormals(hit, scratch);
    }

    /** The texture's red and green are the slopes along u to the right and v upwards, its blue the normal: each from −1 to 1. */
    private boolean turnByNormals(Hit hit, double[] rgb) {
        map.color(hit.u, hit.v, hit.primitive.repeatsTextures(), rgb);
        double x = 2 * rgb[0] - 1;
        double y = 2 * rgb[1] - 1;
        double z = 2 * rgb[2] - 1;
        return hit.turnShadingNormal(x, y, z);
    }

    /**
     * Bump mapping by J. Blinn, "Simulation of wrinkled surfaces", 1978: slopes are differences over a texel, which does not reach over an
     * edge.
     */
    private boolean turnByHeights(Hit hit, double[] rgb) {
        double d = map.texel() / 2;
        double left = hit.u - d;
        double right = hit.u + d;
        if (!hit.primitive.repeatsTextures()) {
            left = Math.max(left, 0);
            right = Math.min(right, 1);
        }
        double top = Math.max(hit.v - d, Math.floor(hit.v));
        double bottom = Math.min(hit.v + d, Math.floor(hit.v) + 1);
        double alongU = (value(right, hit.v, hit, rgb) - value(left, hit.v, hit, rgb)) / (right - left);
        double alongV = (value(hit.u, top, hit, rgb) - value(hit.u, bottom, hit, rgb)) / (bottom - top);
        return hit.tiltShadingNormal(height * alongU, height * alongV);
    }

    /** A text that is equal for details that look the same. Parts that differ in roughness alone follow from one of them. */
    String look() {
        String of = levels == null ? "" : levels.toString();
        for (int k = 0; k < (levels == null ? parts.length : 1); k++) {
            of += " [" + parts[k].appearance() + "]";
        }
        return kind + " " + amount.look() + " " + height + " " + of;
    }
}
