package enlightenment.importer.support;

import enlightenment.geometry.Mesh;
import enlightenment.geometry.Shape;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.material.Texture;
import enlightenment.mesh.TriangleMesh;
import java.util.Optional;

/**
 * What glass and media fill. Renderers that tell the inside by the side of a surface that light meets fill meshes with holes, too; here
 * only what is closed has an inside, and so small holes are closed.
 */
public final class Fillings {
    /** The largest share of a mesh's area that its holes may have: the foot of a model, not the mouth of a bowl. A choice, not a fit. */
    private static final double SMALL = 0x1p-4;

    private Fillings() {}

    /** Whether {@link #filled} loses the texture of the glass's roughness: its border becomes smooth. */
    public static boolean losesTexture(Glass glass, Medium.Coefficients inside) {
        return inside.scattering().max() > 0 && !(glass.roughness() instanceof Texture.Amount.Constant);
    }

    /** Glass that a medium fills: it absorbs, or is a solid that light is scattered in. */
    public static Material filled(Glass glass, Medium.Coefficients inside) {
        if (inside.scattering().max() == 0) {
            return glass.withAbsorption(inside.absorption());
        }
        double roughness = glass.roughness() instanceof Texture.Amount.Constant constant ? constant.value() : 0;
        return new Material.Scattering(inside, glass.indexOfRefraction(), roughness, 0);
    }

    /** The mesh with its holes closed; empty if it is closed, or has larger holes. */
    public static Optional<TriangleMesh> closed(TriangleMesh mesh) {
        return mesh.withoutHoles(SMALL);
    }

    /** The shape with its holes closed, without the name of its file; empty if it is closed, is no mesh, or has larger holes. */
    public static Optional<Shape> closed(Shape shape) {
        if (!(shape instanceof Mesh m) || m.enclosesVolume()) {
            return Optional.empty();
        }
        return closed(m.triangles()).map(triangles -> new Mesh(triangles, Optional.empty(), m.transform()));
    }
}
