package enlightenment.primitive;

import enlightenment.mesh.TriangleMesh;

/**
 * A primitive as plain numbers, for code on another device that repeats the primitive's computation operation by operation. The order of
 * the numbers is documented in that code.
 *
 * @param mesh of which it is an instance, or null
 */
public record FlatForm(Kind kind, double[] numbers, TriangleMesh mesh) {
    /** The kinds of primitives that such code supports. */
    public enum Kind {
        SPHERE,
        RECTANGLE,
        TRIANGLE,
        DISK,
        BOX,
        CUBE,
        AXIAL,
        MESH
    }

    static FlatForm of(Kind kind, double[]... parts) {
        int size = 0;
        for (double[] part : parts) {
            size += part.length;
        }
        double[] all = new double[size];
        int at = 0;
        for (double[] part : parts) {
            System.arraycopy(part, 0, all, at, part.length);
            at += part.length;
        }
        return new FlatForm(kind, all, null);
    }
}
