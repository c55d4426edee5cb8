package enlightenment.compiled;

import enlightenment.color.DisplayCurve;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** All that is known of light that paths from the eye find by chance only, by where it is and what it comes from. Immutable. */
public final class ChanceLights {
    /** Nothing is known to be left to chance. */
    public static final ChanceLights NONE = new ChanceLights(List.of());

    /** What a method may find in other ways. */
    public enum Kind {
        /** Caustics on surfaces that are seen in mirrors or through glass. */
        SURFACES,
        /** In media behind borders that refract, light of points, which chance never finds. */
        POINTS_IN_MEDIA,
        /** The same of lamps. */
        LAMPS_IN_MEDIA,
        /** The same of the sun's disk. */
        SUN_IN_MEDIA,
        /** Of that of points and lamps what paths from both ends do not meet on, as borders are on both sides of each place. */
        UNCONNECTED_IN_MEDIA,
        /** The rest of that, which they find where that from the light has come into the medium, and near to the other. */
        CONNECTED_IN_MEDIA
    }

    private record Part(Kind kind, ChanceLight light) {}

    private final List<Part> all;

    private ChanceLights(List<Part> all) {
        this.all = List.copyOf(all);
    }

    /** These and more of a kind; these if that is null. */
    public ChanceLights and(Kind kind, ChanceLight light) {
        if (light == null) {
            return this;
        }
        List<Part> more = new ArrayList<>(all);
        more.add(new Part(kind, light));
        return new ChanceLights(more);
    }

    /**
     * What is known of a rectangle of the picture.
     *
     * @param left as a share of the picture's width, less than {@code right}; and so on, from the top left
     */
    public ChanceLights within(double left, double top, double right, double bottom) {
        List<Part> inside = new ArrayList<>();
        for (Part part : all) {
            inside.add(new Part(part.kind, part.light.within(left, top, right, bottom)));
        }
        return new ChanceLights(inside);
    }

    /** What those of some kinds do to the error of a picture with so many samples per pixel. */
    public ChanceError error(Set<Kind> kinds, DisplayCurve curve, double samples) {
        ChanceError sum = ChanceError.NONE;
        for (Part part : all) {
            if (kinds.contains(part.kind)) {
                sum = sum.plus(part.light.error(curve, samples));
            }
        }
        return sum;
    }

    /** The same of a picture of which so many pixels show together what one of them has found. */
    public ChanceError error(Set<Kind> kinds, DisplayCurve curve, double samples, double together) {
        ChanceError sum = ChanceError.NONE;
        for (Part part : all) {
            if (kinds.contains(part.kind)) {
                sum = sum.plus(part.light.error(curve, samples, together));
            }
        }
        return sum;
    }
}
