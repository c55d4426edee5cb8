package enlightenment.render;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * What a render can tell of each pixel beside its colour. All of it comes as an {@link enlightenment.image.Image} of raw numbers,
 * as large as the picture; where there is one number per pixel, all three components are equal.
 */
public enum Auxiliary {
    /**
     * The estimated standard deviation of the pixel's colour, in display units 0..1. The estimate of a single pixel is a rough
     * guess, so this is the root of the mean variance over the 3×3 finished pixels around it; +∞ where nothing is finished.
     */
    ERROR,

    /** The number of samples in the pixel; 0 where it is not finished. */
    SAMPLES,

    /**
     * How far from the eye the first thing is that the ray through the pixel's middle meets, in the scene's units and measured
     * along the ray; +∞ where there is nothing. The orthographic camera's rays start on the plane through its eye; in the
     * isometric view, which has no eye, it is the plane through the point that the camera looks at, and what lies before that
     * has a negative depth.
     */
    DEPTH,

    /**
     * The unit normal there, in the scene's axes, on the side that faces the viewer: x, y, z in −1..1 as the three components;
     * 0, 0, 0 where there is nothing.
     */
    NORMAL,

    /** Where that is: x, y, z in the scene's units and axes, as the nearest floats; 0, 0, 0 where there is nothing. */
    POSITION,

    /**
     * Which object it is: its place in the scene's list of objects, counted from 0. Lights count on after the last object; −1
     * where there is nothing.
     */
    OBJECT,

    /**
     * What share of light the first surface reflects that is neither a mirror nor glass: linear, 0..1, its colour, or of a metal its
     * reflectance at normal incidence; the mean over the samples of the pixel. Where mirrors and glass show it, with their colours.
     * Black where there is nothing. Physical shading only, as are those that follow.
     */
    ALBEDO,

    /**
     * The part of the picture that comes from lights, glowing things and the background straight: as they are seen, and from them to the
     * first surface that is neither a mirror nor glass; also where mirrors and glass show it. Linear light.
     */
    DIRECT,

    /**
     * The rest of the picture: light that has been scattered at least twice, and caustics, which are light that came by way of mirrors
     * or glass to the surface that is seen. The picture less {@link #DIRECT}, so that both add up to it; noise can make it negative
     * where the picture is not made of the same paths, as by method {@code cluster}.
     */
    INDIRECT;

    /** The names that the command line knows, in order. */
    public static List<String> words() {
        return Arrays.stream(values()).map(Auxiliary::word).toList();
    }

    /** The one with this name, if there is any. */
    public static Optional<Auxiliary> of(String word) {
        return Arrays.stream(values()).filter(a -> a.word().equals(word)).findFirst();
    }

    /** Its name in small letters, as on the command line and in names of files. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Whether it is told by one ray to each pixel rather than by the samples of the picture. */
    boolean needsRays() {
        return this == DEPTH || this == NORMAL || this == POSITION || this == OBJECT;
    }

    /**
     * What its numbers are called as channels of a layer of this {@linkplain #word name}, as in OpenEXR files: R, G, B of what is light or
     * reflectance, X, Y, Z of points and directions, Z of the depth and Y of other single numbers.
     */
    public List<String> channels() {
        return switch (this) {
            case ERROR, SAMPLES, OBJECT -> List.of("Y");
            case DEPTH -> List.of("Z");
            case NORMAL, POSITION -> List.of("X", "Y", "Z");
            case ALBEDO, DIRECT, INDIRECT -> List.of("R", "G", "B");
        };
    }

    /** Whether it is light or reflectance, of physical shading. */
    public boolean needsPaths() {
        return this == ALBEDO || this == DIRECT || this == INDIRECT;
    }
}
