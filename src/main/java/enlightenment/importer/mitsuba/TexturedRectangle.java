package enlightenment.importer.mitsuba;

import enlightenment.geometry.Rectangle;
import enlightenment.importer.support.UvMap;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.MeshBuilder;
import enlightenment.mesh.TriangleMesh;
import java.util.List;

/** A parallelogram as two triangles with the same front, for texture coordinates of its own. */
final class TexturedRectangle {
    private TexturedRectangle() {}

    static TriangleMesh mesh(Rectangle r, UvMap map) {
        MeshBuilder mesh = new MeshBuilder();
        List<ExactPoint> corners = List.of(r.lowerLeft(), r.lowerRight(), r.upperRight(), r.upperLeft());
        for (int i = 0; i < 4; i++) {
            Vec3 p = corners.get(i).toVec3();
            mesh.vertex(p.x(), p.y(), p.z());
            mesh.uv(i == 1 || i == 2 ? 1 : 0, i >= 2 ? 1 : 0);
        }
        mesh.triangle(0, 2, 1);
        mesh.triangle(0, 3, 2);
        return map.mapped(mesh.build(), false);
    }
}
