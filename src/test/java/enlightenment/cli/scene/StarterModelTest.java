package enlightenment.cli.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.cli.CliRun;
import enlightenment.geometry.Mesh;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Models in starter scenes stand upright on the ground, in the picture's middle, and are not mirrored. */
class StarterModelTest {
    @TempDir
    Path folder;

    /** A tetrahedron whose first corner is the box's lower one; the others lie along x, y and z. */
    private Path ply(double x, double y, double z, double width, double height, double depth) throws IOException {
        return Files.writeString(
                folder.resolve("model.ply"),
                """
                ply
                format ascii 1.0
                element vertex 4
                property double x
                property double y
                property double z
                element face 4
                property list uchar int vertex_indices
                end_header
                """
                        + corner(x, y, z) + corner(x + width, y, z) + corner(x, y + height, z) + corner(x, y, z + depth)
                        + "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
    }

    private static String corner(double x, double y, double z) {
        return x + " " + y + " " + z + "\n";
    }

    private Scene made(String kind, Path model) throws IOException {
        Path file = folder.resolve(kind + ".json");
        CliRun run = CliRun.of("new", file, "--kind", kind, "--model", model);
        assertEquals(0, run.code(), run.err());
        assertEquals(0, CliRun.of("validate", file).code());
        return SceneReader.read(file);
    }

    private static Mesh mesh(Scene scene) {
        List<Mesh> meshes = new ArrayList<>();
        scene.objects().forEach(o -> {
            if (o.shape() instanceof Mesh mesh) {
                meshes.add(mesh);
            }
        });
        assertEquals(1, meshes.size());
        return meshes.get(0);
    }

    /** The vertices of the scene's only mesh in the scene, in the order of the file. */
    private static List<Vec3> vertices(Scene scene) {
        Mesh mesh = mesh(scene);
        List<Vec3> placed = new ArrayList<>();
        for (int i = 0; i < mesh.triangles().vertices(); i++) {
            placed.add(mesh.transform().apply(mesh.triangles().position(i)).toVec3());
        }
        return placed;
    }

    private static List<Vec3> corners(Scene scene) {
        Mesh mesh = mesh(scene);
        Vec3 a = mesh.triangles().min();
        Vec3 b = mesh.triangles().max();
        List<Vec3> placed = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            placed.add(mesh.transform()
                    .apply(new Vec3(
                            (i & 1) == 0 ? a.x() : b.x(), (i & 2) == 0 ? a.y() : b.y(), (i & 4) == 0 ? a.z() : b.z()))
                    .toVec3());
        }
        return placed;
    }

    /** Where a point is in the picture: −1..1 from left to right, and from bottom to top. */
    private static Vec3 seen(Scene scene, Vec3 p) {
        Camera.Perspective camera = (Camera.Perspective) scene.camera();
        Vec3 eye = camera.eye().toVec3();
        Vec3 forward = camera.lookAt().toVec3().minus(eye).normalized();
        Vec3 right = camera.up().cross(forward).normalized();
        Vec3 up = forward.cross(right);
        Vec3 d = p.minus(eye);
        double half = StrictMath.tan(StrictMath.toRadians(camera.fieldOfView() / 2)) * d.dot(forward);
        return new Vec3(d.dot(right) / (half * 800 / 450), d.dot(up) / half, 0);
    }

    @ParameterizedTest
    @EnumSource(StarterKind.class)
    void theBoxStandsOnTheGroundInThePicturesMiddle(StarterKind kind) throws IOException {
        Scene scene = made(kind.toString(), ply(1000.25, -3, 70, 2, 5, 1));
        ModelPlace place = kind.place();
        Vec3 middle = new Vec3(0, 0, 0);
        double lowest = Double.MAX_VALUE;
        double highest = -Double.MAX_VALUE;
        double reach = 0;
        for (Vec3 p : corners(scene)) {
            Vec3 seen = seen(scene, p);
            assertTrue(Math.abs(seen.x()) < 1 && Math.abs(seen.y()) < 1, kind + " " + seen);
            middle = middle.plus(p.times(1.0 / 8));
            lowest = Math.min(lowest, p.y());
            highest = Math.max(highest, p.y());
            reach = Math.max(
                    reach,
                    StrictMath.hypot(
                            p.x() - place.foot().x(), p.z() - place.foot().z()));
        }
        assertEquals(place.foot().x(), middle.x(), 1e-5);
        assertEquals(place.foot().z(), middle.z(), 1e-5);
        assertTrue(lowest > place.foot().y() && lowest < place.foot().y() + place.height() / 500, "" + lowest);
        // As large as it can be: the height is reached, or the radius.
        double filled = Math.max((highest - lowest) / place.height(), reach / place.radius());
        assertEquals(1, filled, 1e-4);
        Vec3 center = seen(scene, middle);
        assertTrue(Math.abs(center.x()) < 1.0 / 3 && Math.abs(center.y()) < 0.5, kind + " " + center);
    }

    /** In every format of meshes x is right and y up for somebody who looks along −z: what lies at greater z is nearer. */
    @Test
    void modelsShowTheirFrontAndAreNotMirrored() throws IOException {
        Scene scene = made("studio", ply(0, 0, 0, 1, 1, 1));
        List<Vec3> v = vertices(scene);
        assertTrue(v.get(1).x() > v.get(0).x(), v.toString());
        assertTrue(v.get(2).y() > v.get(0).y(), v.toString());
        assertTrue(v.get(3).z() < v.get(0).z(), v.toString());
    }

    @Test
    void stlFilesAreTurnedUpright() throws IOException {
        String text = "solid t\n";
        for (String three :
                List.of("0 0 0,2 0 0,0 1 0", "0 0 0,0 0 5,2 0 0", "0 0 0,0 1 0,0 0 5", "2 0 0,0 0 5,0 1 0")) {
            text += "facet normal 0 0 0\nouter loop\nvertex " + three.replace(",", "\nvertex ")
                    + "\nendloop\nendfacet\n";
        }
        Path stl = Files.writeString(folder.resolve("t.stl"), text + "endsolid t\n");
        Mesh mesh = mesh(made("outdoor", stl));
        Vec3 origin = mesh.transform().apply(new Vec3(0, 0, 0)).toVec3();
        Vec3 high = mesh.transform().apply(new Vec3(0, 0, 5)).toVec3().minus(origin);
        Vec3 right = mesh.transform().apply(new Vec3(2, 0, 0)).toVec3().minus(origin);
        Vec3 back = mesh.transform().apply(new Vec3(0, 1, 0)).toVec3().minus(origin);
        double scale = high.length() / 5;
        assertEquals(5 * scale, high.y(), 1e-12);
        assertEquals(2 * scale, right.x(), 1e-12);
        assertEquals(scale, back.z(), 1e-12);
        assertEquals(2.8, high.y(), 1e-4);
    }

    @ParameterizedTest
    @CsvSource({"1e-30, 1e-30", "1e12, 1000", "-1e20, 1e15", "0, 1e30", "123456.789, 1"})
    void modelsOfAnySizeAndPlaceStandThere(double at, double size) throws IOException {
        Scene scene = made("studio", ply(at, at, at, size, size, size));
        ModelPlace place = StarterKind.STUDIO.place();
        for (Vec3 p : corners(scene)) {
            assertTrue(p.y() > 0 && p.y() < place.height() * 1.01, p.toString());
            double reach = StrictMath.hypot(
                    p.x() - place.foot().x(), p.z() - place.foot().z());
            assertTrue(reach < place.radius() * 1.0001, p.toString());
        }
    }

    @Test
    void flatModelsAreWideAtMost() throws IOException {
        Path flat = Files.writeString(folder.resolve("flat.obj"), "v 0 7 0\nv 1 7 0\nv 0 7 1\nf 1 2 3\n");
        for (Vec3 p : vertices(made("studio", flat))) {
            assertEquals(2.0 / 1024, p.y(), 1e-6);
        }
    }

    @Test
    void aModelOutsideOfTheFolderIsFoundAndTold() throws IOException {
        Path model = ply(0, 0, 0, 1, 1, 1);
        Path scenes = Files.createDirectory(folder.resolve("scenes"));
        CliRun run = CliRun.of("new", scenes.resolve("a.json"), "--model", model);
        assertEquals(0, run.code(), run.err());
        assertEquals(1, run.errLines().size(), run.err());
        assertTrue(run.err().contains("\"../model.ply\"") && run.err().contains("copy it"), run.err());
        assertEquals(0, CliRun.of("validate", scenes.resolve("a.json")).code());
        Path own = Files.copy(model, scenes.resolve("o\"d\\d.ply"));
        CliRun inside = CliRun.of("new", scenes.resolve("b.json"), "--model", own);
        assertEquals("", inside.err());
        assertEquals(0, CliRun.of("validate", scenes.resolve("b.json")).code());
    }

    @ParameterizedTest
    @EnumSource(StarterKind.class)
    void scenesWithAModelRender(StarterKind kind) throws IOException {
        made(kind.toString(), ply(0, 0, 0, 1, 2, 1));
        CliRun run = CliRun.of(
                "render",
                folder.resolve(kind + ".json"),
                "-o",
                folder.resolve("p.png"),
                "--size",
                "16x9",
                "--samples",
                "4");
        assertEquals(0, run.code(), run.err());
    }
}
