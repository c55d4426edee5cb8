package enlightenment.importer.mitsuba;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Sphere;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.importer.support.Fronts;
import enlightenment.importer.support.ImportDraft;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.TriangleMesh;
import enlightenment.scene.SceneObject;
import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Shapes with area emitters. Which side emits was measured with Mitsuba 3.9, by rays from both sides. */
class MitsubaLampsTest extends MitsubaSceneTest {
    private static final String BLACK = "<bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0\"/></bsdf>";

    private static final String FLIP = "<boolean name=\"flip_normals\" value=\"true\"/>";

    private ImportDraft lamp(String type, String inside) throws IOException {
        return scenes.read("<shape type=\"" + type + "\">" + inside
                + "<emitter type=\"area\"><rgb name=\"radiance\" value=\"3\"/></emitter></shape>");
    }

    /** As {@link #lamp}, in a scene that is mirrored at the plane x = 0, as scenes with a parallel view are. */
    private ImportDraft mirrored(String type, String inside) throws IOException {
        return scenes.read("<sensor type=\"orthographic\"/><shape type=\"" + type + "\">" + inside
                + "<emitter type=\"area\"><rgb name=\"radiance\" value=\"3\"/></emitter></shape>");
    }

    private static String scaled(String axis) {
        return axis.isEmpty() ? "" : "<transform name=\"to_world\"><scale " + axis + "=\"-1\"/></transform>";
    }

    /** The side that the only lamp emits to, after a check that it is one side. */
    private static Vec3 front(ImportDraft draft) {
        assertEquals(List.of(), draft.notes().list());
        if (!draft.lights().isEmpty()) {
            Light.Rectangle r = (Light.Rectangle) draft.lights().get(0);
            assertFalse(r.twoSided());
            return ExactPoint.normal(r.lowerLeft(), r.upperLeft(), r.lowerRight())
                    .normalized();
        }
        SceneObject o = draft.objects().get(0);
        assertEquals(Material.EmissionPattern.Side.FRONT, o.material().pattern().side());
        assertEquals(Rgb.gray(3), o.material().radiance());
        return Fronts.normal(o.shape()).normalized();
    }

    @ParameterizedTest
    @ValueSource(strings = {"rectangle", "disk"})
    void flatLampsEmitToTheSideOfTheirMappedNormal(String type) throws IOException {
        for (String bsdf : new String[] {"", BLACK}) {
            assertEquals(1, front(lamp(type, bsdf)).z());
            assertEquals(-1, front(lamp(type, bsdf + FLIP)).z());
            assertEquals(1, front(lamp(type, bsdf + scaled("x"))).z());
            assertEquals(-1, front(lamp(type, bsdf + FLIP + scaled("x"))).z());
            assertEquals(-1, front(lamp(type, bsdf + scaled("z"))).z());
            assertEquals(1, front(lamp(type, bsdf + FLIP + scaled("z"))).z());
            assertEquals(1, front(mirrored(type, bsdf)).z());
            assertEquals(-1, front(mirrored(type, bsdf + scaled("z"))).z());
        }
    }

    @Test
    void blackRectanglesBecomeLightsAndOthersStayObjects() throws IOException {
        assertEquals(1, lamp("rectangle", BLACK).lights().size());
        Material grey = lamp("rectangle", "").objects().get(0).material();
        assertEquals(Texture.of(Rgb.gray(0.5)), grey.color());
    }

    /** The columns: normals of the file along z or none, the mirrored axis, face_normals, and the side that emits. */
    @ParameterizedTest
    @CsvSource({
        "0,, false, 1", "0,, true, 1", "0, x, false, -1", "0, x, true, -1", "0, z, false, 1", "0, z, true, 1",
        "1,, false, 1", "1,, true, 1", "1, x, false, 1", "1, x, true, -1", "1, z, false, -1", "1, z, true, 1",
        "-1,, false, -1", "-1,, true, 1", "-1, x, false, -1", "-1, x, true, -1", "-1, z, false, 1", "-1, z, true, 1"
    })
    void meshesEmitToTheSideOfTheirShadingNormals(int normal, String axis, boolean isFlat, int side)
            throws IOException {
        String normals = normal == 0 ? "" : "vn 0 0 " + normal + "\n";
        String corner = normal == 0 ? "%s" : "%s//1";
        StringBuilder faces = new StringBuilder();
        for (int[] f : new int[][] {{1, 2, 3}, {1, 3, 4}, {1, 4, 5}}) {
            faces.append("f");
            for (int v : f) {
                faces.append(' ').append(corner.formatted(v));
            }
            faces.append('\n');
        }
        String file = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -2 0 0\n" + normals + faces;
        scenes.write("lamp.obj", file);
        scenes.write("pane.obj", file.replaceAll("f 1(//1)? 4.*\n", ""));
        for (String name : new String[] {"lamp.obj", "pane.obj"}) {
            String inside = "<string name=\"filename\" value=\"" + name + "\"/><boolean name=\"face_normals\" value=\""
                    + isFlat + "\"/>" + scaled(axis == null ? "" : axis);
            for (String bsdf : new String[] {"", BLACK}) {
                assertEquals(side, front(lamp("obj", inside + bsdf)).z());
                assertEquals(-side, front(lamp("obj", inside + bsdf + FLIP)).z());
                assertEquals(side, front(mirrored("obj", inside + bsdf)).z());
                assertEquals(-side, front(mirrored("obj", inside + bsdf + FLIP)).z());
            }
        }
    }

    @Test
    void meshesThatNeedNotBeTurnedKeepTheirFile() throws IOException {
        scenes.write("lamp.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nf 1 2 3\n");
        String inside = "<string name=\"filename\" value=\"lamp.obj\"/>";
        assertTrue(
                ((Mesh) lamp("obj", inside).objects().get(0).shape()).origin().isPresent());
        assertTrue(((Mesh) lamp("obj", inside + FLIP).objects().get(0).shape())
                .origin()
                .isEmpty());
    }

    @Test
    void tubesEmitOutwardsAndTheFacesOfCubesToo() throws IOException {
        for (String axis : new String[] {"", "x", "z"}) {
            SceneObject tube = lamp("cylinder", scaled(axis)).objects().get(0);
            assertInstanceOf(Cylinder.class, tube.shape());
            assertEquals(
                    Material.EmissionPattern.Side.FRONT,
                    tube.material().pattern().side());
        }
        String turned =
                "<transform name=\"to_world\"><scale x=\"%s\"/><rotate x=\"1\" y=\"2\" angle=\"30\"/></transform>";
        for (String x : new String[] {"2", "-2"}) {
            ImportDraft faces = lamp("cube", turned.formatted(x));
            assertEquals(6, faces.objects().size());
            for (SceneObject o : faces.objects()) {
                assertTrue(Fronts.normal(o.shape()).dot(Fronts.point(o.shape())) > 0);
                assertEquals(
                        Material.EmissionPattern.Side.FRONT,
                        o.material().pattern().side());
            }
        }
    }

    @Test
    void ballsAndTubesThatAreFlippedEmitInwards() throws IOException {
        for (String type : new String[] {"sphere", "cylinder"}) {
            assertEquals(Material.EmissionPattern.Side.BACK, side(lamp(type, FLIP)));
            assertEquals(Material.EmissionPattern.Side.FRONT, side(lamp(type, "")));
        }
        assertInstanceOf(Sphere.class, lamp("sphere", FLIP).objects().get(0).shape());
        // A ball that is mirrored emits inwards, one that is flipped besides outwards.
        assertEquals(Material.EmissionPattern.Side.BACK, side(lamp("sphere", scaled("x"))));
        assertEquals(Material.EmissionPattern.Side.FRONT, side(lamp("sphere", FLIP + scaled("x"))));
    }

    private static Material.EmissionPattern.Side side(ImportDraft draft) {
        assertEquals(List.of(), draft.notes().list());
        return draft.objects().get(0).material().pattern().side();
    }

    private static String screen(String texture) {
        return "<shape type=\"rectangle\">%s<emitter type=\"area\">" + texture + "</emitter></shape>";
    }

    private static String bitmap(String file, String inside) {
        return "<texture type=\"bitmap\" name=\"radiance\"><string name=\"filename\" value=\"" + file + "\"/>" + inside
                + "</texture>";
    }

    @Test
    void aTextureOfTheRadianceBecomesItsMap() throws IOException {
        scenes.write("p.png", "");
        ImportDraft draft = scenes.read(screen(bitmap("p.png", "")).formatted(""));
        SceneObject o = draft.objects().get(0);
        assertEquals(List.of(), draft.notes().list());
        assertEquals(Rgb.WHITE, o.material().radiance());
        Texture.File map = (Texture.File) o.material().radianceMap().orElseThrow();
        assertEquals("p.png", map.file().getFileName().toString());
        assertEquals(Texture.Encoding.SRGB, map.encoding());
        assertInstanceOf(Rectangle.class, o.shape());
        assertEquals(1, Fronts.normal(o.shape()).normalized().z());
    }

    @Test
    void texturesOfTurnedLampsStayWhereTheyAre() throws IOException {
        scenes.write("p.png", "");
        SceneObject o = scenes.read(screen(bitmap("p.png", "")).formatted(FLIP))
                .objects()
                .get(0);
        assertEquals(-1, Fronts.normal(o.shape()).normalized().z());
        TriangleMesh mesh = ((Mesh) o.shape()).triangles();
        for (int v = 0; v < mesh.vertices(); v++) {
            Vec3 p = mesh.position(v);
            // The first row of a picture lies at y = −1; v of meshes runs upwards.
            assertEquals((1 + p.x()) / 2, mesh.uv(v, 0));
            assertEquals((1 - p.y()) / 2, mesh.uv(v, 1));
        }
    }

    @Test
    void toUvOfARadianceChangesTheMesh() throws IOException {
        scenes.write("p.png", "");
        String scale = "<transform name=\"to_uv\"><scale x=\"3\" y=\"2\"/></transform>";
        SceneObject o = scenes.read(screen(bitmap("p.png", scale)).formatted(""))
                .objects()
                .get(0);
        TriangleMesh mesh = ((Mesh) o.shape()).triangles();
        double most = 0;
        for (int v = 0; v < mesh.vertices(); v++) {
            most = Math.max(most, mesh.uv(v, 0));
        }
        assertEquals(3, most);
        assertEquals(1, Fronts.normal(o.shape()).normalized().z());
    }

    @Test
    void oneSurfaceHasOneMapOfTextureCoordinates() throws IOException {
        ImageFiles.writePng(new Image(1, 1, new float[] {0.5f, 0.5f, 0.5f}), folder.resolve("p.png"));
        String checkered =
                "<bsdf type=\"diffuse\"><texture type=\"bitmap\" name=\"reflectance\"><string name=\"filename\""
                        + " value=\"p.png\"/></texture></bsdf>";
        String scale = "<transform name=\"to_uv\"><scale x=\"3\" y=\"2\"/></transform>";
        ImportDraft same = scenes.read(screen(bitmap("p.png", "")).formatted(checkered));
        assertEquals(List.of(), same.notes().list());
        assertTrue(same.objects().get(0).material().radianceMap().isPresent());
        ImportDraft others = scenes.read(screen(bitmap("p.png", scale)).formatted(checkered));
        assertTrue(others.notes().list().get(0).contains("becomes its mean"));
        assertTrue(others.objects().get(0).material().radianceMap().isEmpty());
    }

    @Test
    void picturesOfFloatsAreDividedByTheirLargestComponent() throws IOException {
        ImageFiles.writePfm(
                new Image(2, 1, new float[] {8, 2, 0, 4, 4, 1}, enlightenment.color.Color.Encoding.LINEAR),
                folder.resolve("p.pfm"));
        Material m = scenes.read(screen(bitmap("p.pfm", "")).formatted(""))
                .objects()
                .get(0)
                .material();
        assertEquals(Rgb.gray(8), m.radiance());
        Image map = ImageFiles.read(((Texture.File) m.radianceMap().orElseThrow()).file());
        double[] expected = {1, 0.25, 0, 0.5, 0.5, 0.125};
        for (int i = 0; i < expected.length; i++) {
            assertEquals(expected[i], map.component(i / 3, 0, i % 3), 1.0 / 65535);
        }
    }

    @Test
    void checkersKeepTheirRadiance() throws IOException {
        Material m = scenes.read(
                        screen("<texture type=\"checkerboard\" name=\"radiance\"><rgb name=\"color0\" value=\"4 2 1\"/>"
                                        + "<rgb name=\"color1\" value=\"0 0 8\"/></texture>")
                                .formatted(""))
                .objects()
                .get(0)
                .material();
        assertEquals(Rgb.gray(8), m.radiance());
        Texture.Checker c = (Texture.Checker) m.radianceMap().orElseThrow();
        assertEquals(List.of(new Rgb(0.5, 0.25, 0.125), new Rgb(0, 0, 1)), c.colors());
    }
}
