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

    /**
     * Glass that a medium fills: it absorbs, or is a solid that light is scattered in, whose border becomes smooth if the roughness has a texture.
     *
     * @param notes where that is noted
     * @param place in the file
     */
    public static Material filled(Glass glass, Medium.Coefficients inside, ImportNotes notes, String place) {
        if (inside.scattering().max() == 0) {
            return glass.withAbsorption(inside.absorption());
        }
        if (glass.roughness() instanceof Texture.Amount.Constant roughness) {
            return new Material.Scattering(inside, glass.indexOfRefraction(), roughness.value(), 0);
        }
        notes.add(
                place, "the texture of the roughness around a medium that scatters is left out: the border is smooth");
        return new Material.Scattering(inside, glass.indexOfRefraction(), 0, 0);
    }

    /**
     * The mesh with its holes closed; the mesh itself if it is closed, or has larger holes.
     *
     * @param notes where that is noted
     * @param place in the file
     */
    public static TriangleMesh whole(TriangleMesh mesh, ImportNotes notes, String place) {
        Optional<TriangleMesh> closed = mesh.withoutHoles(SMALL);
        if (closed.isPresent()) {
            notes.add(place, "small holes of a mesh that is filled are closed");
        }
        return closed.orElse(mesh);
    }

    /** As {@link #whole(TriangleMesh, ImportNotes, String)}, for any shape; what is closed no longer has the name of its file. */
    public static Shape whole(Shape shape, ImportNotes notes, String place) {
        if (!(shape instanceof Mesh m)) {
            return shape;
        }
        TriangleMesh whole = whole(m.triangles(), notes, place);
        return whole == m.triangles() ? shape : new Mesh(whole, Optional.empty(), m.transform());
    }
}
