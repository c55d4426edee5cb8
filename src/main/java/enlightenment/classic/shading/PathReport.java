package enlightenment.classic.shading;

/**
 * What a shader found out about its last path, beside the colour: for methods that decide by it where to sample. The shader fills it in
 * while it follows the path; the method reads it afterwards.
 */
public final class PathReport {
    /** Position p and q on the light in the unit disk, and importance sampling weight, of guided samples. */
    public static final int P = 0;

    public static final int Q = 1;
    public static final int WEIGHT = 2;

    /** Three coordinates each of the surface point and the light point of a ray. */
    public static final int SURFACE_POINT = 0;

    public static final int LIGHT_POINT = 3;

    /** A hash of the surfaces of the path, in order: if it is equal for neighbouring rays, no edge lies between them. */
    public long pathKey;

    /** The number of shadow rays. */
    public int shadowRays;

    /** The number of them that were blocked. */
    public int blockedShadowRays;

    /**
     * What the shadow rays decide: the squared difference in colour between all light points visible and all blocked, as the mean of the
     * three components, summed over the lights and surfaces concerned.
     */
    public double visibilityContrast;

    /**
     * The variance of the colour with a single light point that is due to the cosine, where the cosine has no closed form; summed as
     * {@link #visibilityContrast}.
     */
    public double colorVariance;

    /** The light samples that the {@link LightGuide} proposed, but for those outside the disk. */
    public final LightSamples guided = new LightSamples(3);

    /** The shadow rays, and one light sample where no ray was needed; none unless {@link #keepRays} was asked for. */
    public final LightSamples rays = new LightSamples(6);

    private boolean keepsRays;

    /** Whether a caller reads this report; otherwise it stays empty. */
    private boolean isRead = true;

    PathReport() {}

    /** Asks for {@link #rays}. */
    public void keepRays() {
        keepsRays = true;
    }

    /** Leaves this report empty from now on. */
    void stayEmpty() {
        isRead = false;
    }

    boolean isRead() {
        return isRead;
    }

    boolean keepsRays() {
        return keepsRays;
    }

    void clear() {
        pathKey = 0;
        shadowRays = 0;
        blockedShadowRays = 0;
        visibilityContrast = 0;
        colorVariance = 0;
        guided.clear();
        rays.clear();
    }
}
