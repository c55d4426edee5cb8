package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.panel;
import static enlightenment.physical.PhysicalScenes.room;
import static enlightenment.physical.PhysicalScenes.sphereLight;

import enlightenment.color.Rgb;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Transform;
import enlightenment.material.Coated;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.math.Vec3;
import enlightenment.mesh.TestMeshes;
import enlightenment.mesh.TriangleMesh;
import enlightenment.render.TestScenes;
import enlightenment.scene.Scene;
import java.util.Map;

/** Meshes of few triangles that are shaded as if they were smooth, of all kinds of material. */
final class MeshScenes {
    private static final TriangleMesh BALL = TestMeshes.ball(1);

    private MeshScenes() {}

    private static Shape ball(double x, double y, double z, double radius) {
        return Mesh.of(
                BALL,
                Transform.of(
                        new Transform.Scale(new Vec3(radius, radius, radius)), new Transform.Translate(at(x, y, z))));
    }

    static void addTo(Map<String, Scene.Builder> scenes) {
        scenes.put(
                "smooth meshes of matte, mirror and glass",
                room().light(panel(0.05, 1.9, 0, 0.6, new Rgb(5, 4, 2), false))
                        .object(ball(-0.45, 0.5, 0.1, 0.45), PhysicalScenes.WHITE)
                        .object(ball(0.5, 0.6, 0.3, 0.4), Material.Mirror.of(linear(0.95, 0.9, 0.85)))
                        .object(ball(0.1, 0.4, -0.5, 0.3), Glass.of(linear(0.95, 1, 0.9), 1.5)));
        scenes.put(
                "smooth meshes of metal and coats",
                room().light(sphereLight(0.2, 1.5, -0.1, 0.3, 6))
                        .object(ball(-0.45, 0.5, 0.1, 0.45), Glossy.of(linear(0.9, 0.6, 0.3), 0.7))
                        .object(ball(0.5, 0.6, 0.3, 0.4), Coated.of(linear(0.1, 0.5, 0.9), 0))
                        .object(ball(0.1, 0.4, -0.5, 0.3), Coated.of(linear(0.2, 0.9, 0.6), 0.5)));
        Glass glass = Glass.of(linear(0.95, 1, 0.9), 1.5).withSmoothRefraction(true);
        scenes.put(
                "meshes that refract smoothly",
                room().light(panel(0.05, 1.9, 0, 0.6, new Rgb(5, 4, 2), false))
                        .object(ball(-0.35, 0.8, 0.1, 0.55), glass.withAbsorption(new Rgb(0.2, 0.1, 0.6)))
                        .object(ball(0.5, 0.5, -0.2, 0.4), glass));
        Transform cube = Transform.of(
                new Transform.Rotate(new Vec3(0, 30, 0)),
                new Transform.Scale(new Vec3(0.6, 0.6, 0.6)),
                new Transform.Translate(at(-0.6, 0.2, -0.3)));
        Transform above = Transform.of(
                new Transform.Rotate(new Vec3(0, 30, 0)),
                new Transform.Scale(new Vec3(0.55, 0.55, 0.55)),
                new Transform.Translate(at(-0.2, 1, -0.4)));
        // Paths from lights that end at the eye do not see glass: a screen is before it.
        scenes.put(
                "hidden cube that refracts smoothly",
                room().light(panel(0.05, 1.9, 0, 0.6, new Rgb(5, 4, 2), false))
                        .object(
                                TestScenes.rectangle(
                                        -0.5, 0.8, -0.95, -0.5, 1.75, -0.95, 0.5, 1.75, -0.95, 0.5, 0.8, -0.95),
                                PhysicalScenes.RED)
                        .object(Mesh.of(TestMeshes.cube().smooth(), above), glass));
        scenes.put(
                "meshes whose normals are bent",
                room().light(panel(0.3, 1.9, 0, 0.4, new Rgb(8, 8, 8), false))
                        .object(Mesh.of(TestMeshes.cube().smooth(), cube), PhysicalScenes.WHITE)
                        .object(slope(), Material.Matte.of(linear(0.8, 0.8, 0.8))));
    }

    /** A square above the floor, shaded as if it were turned towards the right wall. */
    private static Shape slope() {
        TriangleMesh square = TestMeshes.moved(TestMeshes.grid(1), true, v -> new Vec3(v.x(), 0.02, v.y()));
        float[] normals = new float[3 * square.vertices()];
        for (int v = 0; v < square.vertices(); v++) {
            normals[3 * v] = 0.9f;
            normals[3 * v + 1] = 1;
        }
        return Mesh.of(square.withNormals(normals));
    }
}
