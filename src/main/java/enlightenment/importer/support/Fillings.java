package enlightenment.importer.support;

import enlightenment.geometry.Mesh;
import enlightenment.geometry.Shape;
import enlightenment.mesh.TriangleMesh;
import java.util.Optional;

/**
 * Shapes that glass or a medium is to fill. Renderers that tell the inside by the side of a surface that light meets fill meshes with holes, too; here
 * only what is closed has an inside, and so small holes are closed.
 */
public final class Fillings {
    /** The largest share of a mesh's area that its holes may have: the foot of a model, not the mouth of a bowl. A choice, not a fit. */
    private static final double SMALL = 0x1p-4;

    private Fillings() {}

    /** The shape with its holes closed, without the name of its file; empty if it is closed, is no mesh, or has larger holes. */
    public static Optional<Shape> closed(Shape shape) {
        if (!(shape instanceof Mesh m) || m.enclosesVolume()) {
            return Optional.empty();
        }
        Optional<TriangleMesh> whole = m.triangles().withoutHoles(SMALL);
        return whole.map(triangles -> new Mesh(triangles, Optional.empty(), m.transform()));
    }
}
