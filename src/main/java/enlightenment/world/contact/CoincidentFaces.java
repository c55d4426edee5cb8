package enlightenment.world.contact;

import enlightenment.frame.Bounds;
import enlightenment.primitive.EndFaces;
import enlightenment.world.parts.IntList;
import enlightenment.world.parts.PlaceTree;
import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * The faces of other primitives that coincide with those of one, numbered in the order in which they were found. A pair of faces takes 16
 * bytes, 8 at either primitive: the number of pairs is quadratic in that of the faces in one plane. The tolerance of a pair, and the box
 * where it counts, are computed from the two primitives' boxes on demand, except where there are few pairs.
 */
public final class CoincidentFaces {
    /** The number of bits of a face's number, half of an int; no primitive has more than about six faces. */
    private static final int FACE_BITS = 16;

    private static final int FACE = (1 << FACE_BITS) - 1;

    /** The distance, in tolerances, within which a face known to coincide is searched for: enough never to miss it. */
    static final double REACH = EndFaces.REACH;

    /** Whether a face is the interface of a solid of glass. */
    interface InterfaceOfGlass {
        boolean test(int id, int face);
    }

    private final double minX;
    private final double minY;
    private final double minZ;
    private final double maxX;
    private final double maxY;
    private final double maxZ;

    /** The largest absolute coordinate of the box. */
    private final double reach;

    private int[] others = new int[2];

    /** By pair: this primitive's face in the upper half, the other's in the lower. */
    private int[] faces = new int[2];

    private int size;

    /** The pairs in which the other face is the interface of a solid of glass. */
    private int[] glass = {};

    /** Where pairs are few, for each a box outside of which no point of this surface has the other one within the search; null for many. */
    private double[] places;

    /** Where pairs are many, a tree over these boxes; null for few. */
    private PlaceTree tree;

    /**
     * Begins without pairs.
     *
     * @param box of the primitive
     */
    CoincidentFaces(Bounds box) {
        minX = box.min().x();
        minY = box.min().y();
        minZ = box.min().z();
        maxX = box.max().x();
        maxY = box.max().y();
        maxZ = box.max().z();
        reach = box.maxAbs();
    }

    void add(int face, int other, int otherFace) {
        if (size == others.length) {
            others = Arrays.copyOf(others, 2 * size);
            faces = Arrays.copyOf(faces, 2 * size);
        }
        others[size] = other;
        faces[size++] = face << FACE_BITS | otherFace;
    }

    /**
     * Completes the pairs.
     *
     * @param all by id
     * @param isGlass whether a face of a primitive, by their numbers, is the interface of a solid of glass
     */
    void end(CoincidentFaces[] all, InterfaceOfGlass isGlass) {
        if (size < others.length) {
            others = Arrays.copyOf(others, size);
            faces = Arrays.copyOf(faces, size);
        }
        glass = IntStream.range(0, size)
                .filter(k -> isGlass.test(others[k], otherFace(k)))
                .toArray();
        double[] boxes = places(all);
        if (size <= PlaceTree.LEAF) {
            places = boxes;
        } else {
            double[] own = new double[PlaceTree.BOX];
            place(0, own, 0);
            tree = new PlaceTree(boxes, own);
        }
    }

    private double[] places(CoincidentFaces[] all) {
        double[] boxes = new double[PlaceTree.BOX * size];
        for (int k = 0; k < size; k++) {
            CoincidentFaces other = all[others[k]];
            other.place(margin(other), boxes, PlaceTree.BOX * k);
        }
        return boxes;
    }

    private void place(double by, double[] out, int at) {
        out[at] = minX - by;
        out[at + 1] = minY - by;
        out[at + 2] = minZ - by;
        out[at + 3] = maxX + by;
        out[at + 4] = maxY + by;
        out[at + 5] = maxZ + by;
    }

    /** The number of pairs. */
    int size() {
        return size;
    }

    /** Whether this face of the primitive belongs to a pair. */
    boolean has(int face) {
        for (int k = 0; k < size; k++) {
            if (face(k) == face) {
                return true;
            }
        }
        return false;
    }

    /** The face of this primitive in pair k. */
    public int face(int k) {
        return faces[k] >> FACE_BITS;
    }

    /** The id of the other primitive in pair k. */
    public int other(int k) {
        return others[k];
    }

    /** The face of the other primitive in pair k. */
    public int otherFace(int k) {
        return faces[k] & FACE;
    }

    /** The pairs in which the other face is the interface of a solid of glass; not to be changed. */
    public int[] glass() {
        return glass;
    }

    /** The largest distance between coincident surfaces of this primitive and another, in the frame. */
    double tolerance(CoincidentFaces other) {
        return CoincidentSurfaces.tolerance(reach, other.reach);
    }

    /** Twice the reach of the search, in the frame: covers the roundings of hit points and of boxes. */
    private double margin(CoincidentFaces other) {
        return 2 * REACH * tolerance(other);
    }

    boolean has(int face, int other, int otherFace) {
        int both = face << FACE_BITS | otherFace;
        for (int k = 0; k < size; k++) {
            if (others[k] == other && faces[k] == both) {
                return true;
            }
        }
        return false;
    }

    /**
     * Finds the pairs of a face that count at a point of it, without those whose other surface is certainly not there.
     *
     * @param all by id
     * @param out is cleared and receives the pairs' numbers, in ascending order
     */
    void near(int face, double x, double y, double z, CoincidentFaces[] all, IntList out) {
        out.clear();
        if (tree == null) {
            for (int k = 0; k < size; k++) {
                if (face(k) == face && isWithin(PlaceTree.BOX * k, x, y, z)) {
                    out.add(k);
                }
            }
            return;
        }
        tree.candidates(x, y, z, out);
        int n = 0;
        for (int i = 0; i < out.size(); i++) {
            int k = out.get(i);
            if (face(k) == face && isNear(all[others[k]], x, y, z)) {
                out.set(n++, k);
            }
        }
        out.shorten(n);
        out.sort();
    }

    private boolean isWithin(int at, double x, double y, double z) {
        double[] p = places;
        return x >= p[at] && x <= p[at + 3] && y >= p[at + 1] && y <= p[at + 4] && z >= p[at + 2] && z <= p[at + 5];
    }

    private boolean isNear(CoincidentFaces other, double x, double y, double z) {
        double by = margin(other);
        return x >= other.minX - by
                && x <= other.maxX + by
                && y >= other.minY - by
                && y <= other.maxY + by
                && z >= other.minZ - by
                && z <= other.maxZ + by;
    }

    /**
     * For each pair seven numbers: this primitive's face, and the least and the greatest coordinates of the box outside of which the pair
     * does not count; null where pairs are many.
     */
    double[] boxes() {
        if (places == null) {
            return null;
        }
        double[] all = new double[(PlaceTree.BOX + 1) * size];
        for (int k = 0; k < size; k++) {
            all[(PlaceTree.BOX + 1) * k] = face(k);
            System.arraycopy(places, PlaceTree.BOX * k, all, (PlaceTree.BOX + 1) * k + 1, PlaceTree.BOX);
        }
        return all;
    }
}
