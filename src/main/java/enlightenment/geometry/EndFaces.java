package enlightenment.geometry;

import java.util.ArrayList;
import java.util.List;

/**
 * The faces that a light lies on: a lamp in a ceiling's plane, a bulb on a wall. A shadow ray that ends on the light ends on
 * them too, and is not blocked by them there, just as it is not blocked by the surface that it starts on: whether rounding puts
 * their crossing before the light or behind it means nothing. A crossing of them anywhere else blocks. Immutable once made.
 */
public final class EndFaces {
    private final List<Primitive> primitives = new ArrayList<>();
    private final List<Integer> ids = new ArrayList<>();
    private final List<Integer> faces = new ArrayList<>();
    private final List<Double> tolerances = new ArrayList<>();

    /** No faces yet. */
    public EndFaces() {}

    /**
     * Adds a face while a scene is compiled.
     *
     * @param primitive the face's primitive
     * @param id its number
     * @param face which of its faces
     * @param tolerance how far the face and the light are apart at most, by rounding: a length in the frame
     */
    public void add(Primitive primitive, int id, int face, double tolerance) {
        primitives.add(primitive);
        ids.add(id);
        faces.add(face);
        tolerances.add(tolerance);
    }

    public boolean isEmpty() {
        return ids.isEmpty();
    }

    /** Whether a face of a primitive is one of these. */
    public boolean has(int id, int face) {
        for (int k = 0; k < ids.size(); k++) {
            if (ids.get(k) == id && faces.get(k) == face) {
                return true;
            }
        }
        return false;
    }

    /** Whether any face of the primitive is one of these. */
    boolean concerns(Primitive p) {
        return primitives.contains(p);
    }

    /**
     * Whether a crossing is the end of the segment and nothing in its way.
     *
     * @param ray the segment's ray, which ends at {@link Ray#tEnd}
     * @param hit the crossing, completed
     */
    boolean isEnd(Ray ray, Hit hit) {
        for (int k = 0; k < faces.size(); k++) {
            if (primitives.get(k) == hit.primitive && faces.get(k) == hit.face) {
                // A line meets a plane once, and it meets this one in the light. A round face it may meet before as
                // well.
                double across = Math.abs(hit.nx * ray.dx + hit.ny * ray.dy + hit.nz * ray.dz);
                boolean flat = hit.primitive.support(hit.face).isFlat();
                return flat || (ray.tEnd - hit.t) * across <= tolerances.get(k);
            }
        }
        return false;
    }
}
