package enlightenment.transport.bidirectional;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Hit;
import enlightenment.world.PhysicalScene;
import java.util.Arrays;

/**
 * The vertices of one light subpath, kept until they have been connected to the first vertices of all paths of a group. Mutable, reused
 * from path to path.
 */
public final class LightVertices {
    final PathVertices vertices = new PathVertices();
    private Hit[] hits = {};

    /** By vertex, whether it is on an opaque surface: paths from the eye pass others before they are continued. */
    private boolean[] isOpaque = {};

    /** By vertex, whether light can be shared among paths there; and whether it is. */
    private boolean[] isOpen = {};

    private boolean[] isShared = {};
    private final Scattering leaving = new Scattering();

    private final PhysicalScene physical;

    /** Makes the vertices of no path. */
    public LightVertices(PhysicalScene physical) {
        this.physical = physical;
    }

    /** Records the surface that the last vertex is on; to be called before the subpath leaves it. */
    void note(LightSubpath path, boolean isSurface, boolean opens, boolean shares) {
        int k = vertices.size() - 1;
        if (k >= hits.length) {
            int old = hits.length;
            hits = Arrays.copyOf(hits, 2 * k + 4);
            isOpaque = Arrays.copyOf(isOpaque, hits.length);
            isOpen = Arrays.copyOf(isOpen, hits.length);
            isShared = Arrays.copyOf(isShared, hits.length);
            for (int i = old; i < hits.length; i++) {
                hits[i] = new Hit();
            }
        }
        isOpaque[k] = isSurface;
        isOpen[k] = opens;
        isShared[k] = shares;
        if (shares) {
            hits[k].set(path.path.at.hit);
        }
    }

    /** The number of vertices. */
    public int size() {
        return vertices.size();
    }

    /** Whether any vertex {@linkplain #isOwn may be connected} to the first vertex of its own path. */
    public boolean hasOwn(boolean shares) {
        for (int k = 0; k < size(); k++) {
            if (isOwn(k, shares)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Whether vertex k may be connected to the first vertex of its own path.
     *
     * @param shares whether that receives light from the vertices of other paths
     */
    boolean isOwn(int k, boolean shares) {
        return isOpaque[k] && !(shares && isOpen[k]);
    }

    /** Whether vertex k gives light to the first vertices of all paths of a group. */
    public boolean gives(int k) {
        return isShared[k] && vertices.bsdf(k) != null && vertices.bounces(k) + 2 <= physical.maxBounces;
    }

    /** The surface point of vertex k, which {@linkplain #gives gives}. */
    public Hit hit(int k) {
        return hits[k];
    }

    /** The id of the primitive that vertex k is on. */
    public int id(int k) {
        return vertices.id(k);
    }

    /** The BSDF of vertex k. */
    public Bsdf bsdf(int k) {
        return vertices.bsdf(k);
    }

    /** The scattering at vertex k, until the next call: o leads to where the light comes from. */
    public Scattering scattering(int k) {
        vertices.get(k, leaving);
        return leaving;
    }

    /**
     * Divides the light that vertex k, which is rough and {@linkplain #gives gives}, reflects to the first vertices of paths.
     *
     * @param density as of {@link #leave}
     */
    public void divide(int k, double density, LightDivision by) {
        scattering(k);
        double weight = weight(k, density, by.aim(leaving.ox, leaving.oy, leaving.oz));
        // The BSDF's values have this cosine, the power of a light subpath has it, too.
        double f = weight * density / SubpathDensities.cosine(leaving.geometricCosineOut());
        by.divide(f * vertices.red(k), f * vertices.green(k), f * vertices.blue(k));
    }

    /**
     * Writes the light that vertex k, which is matte and {@linkplain #gives gives}, sends to the first vertices of paths.
     *
     * @param density the expected number of second vertices per area, with which paths through those first vertices would have found
     *     this one, over the number of light subpaths
     * @param out receives power per solid angle and projected area, times the MIS weight
     */
    public void leave(int k, double density, double[] out) {
        scattering(k);
        double f = weight(k, density, leaving.geometricCosineOut() / Math.PI) / Math.PI;
        out[0] = f * leaving.red * vertices.red(k);
        out[1] = f * leaving.green * vertices.green(k);
        out[2] = f * leaving.blue * vertices.blue(k);
    }

    /**
     * The MIS weight of light that vertex k gives.
     *
     * @param density as of {@link #leave}
     * @param back the density per solid angle with which paths from the eye leave the vertex to where its light comes from
     */
    private double weight(int k, double density, double back) {
        double others = SubpathDensities.square(density * physical.areaUnit);
        return SubpathDensities.weight(others * vertices.behind(k, vertices.survival(k) * back), 0);
    }
}
