package enlightenment.importer.pbrt;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import enlightenment.color.Color;
import enlightenment.color.Rgb;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Sphere;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.importer.SceneImporter;
import enlightenment.importer.support.Fronts;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.Vec3;
import enlightenment.mesh.TriangleMesh;
import enlightenment.scene.SceneObject;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Area lights that are objects: the side that they emit to, what they reflect, and their pictures. */
class PbrtLampTest {
    private static final String QUAD =
            "Shape \"trianglemesh\" \"point3 P\" [-1 -1 0 1 -1 0 1 1 0 -1 1 0]" + " \"integer indices\" [0 1 2 0 2 3]";

    @TempDir
    private Path folder;

    private SceneImporter.Result lamp(String light, String shape) throws IOException {
        Path file = folder.resolve("scene.pbrt");
        Files.writeString(
                file,
                "WorldBegin\nMaterial \"diffuse\" \"rgb reflectance\" [.25 .25 .25] AreaLightSource \"diffuse\" "
                        + light + " " + shape);
        return SceneImporter.read(file, SceneImporter.Options.DEFAULT.withExtracted(folder.resolve("made")));
    }

    private SceneObject object(String light, String shape) throws IOException {
        return lamp(light, shape).scene().objects().get(0);
    }

    private Vec3 front(String shape) throws IOException {
        SceneImporter.Result s = lamp("\"rgb L\" [1 2 3]", shape);
        assertEquals(List.of(), s.notes());
        SceneObject o = s.scene().objects().get(0);
        assertEquals(Material.EmissionPattern.Side.FRONT, o.material().pattern().side());
        assertEquals(new Rgb(1, 2, 3), o.material().radiance());
        assertEquals(Texture.of(Rgb.gray(0.25)), o.material().color());
        return Fronts.normal(o.shape()).normalized();
    }

    /** The normal of a disk is mapped as normals are; that of triangles is turned where the map changes the handedness. */
    @ParameterizedTest
    @ValueSource(strings = {QUAD, "Shape \"disk\"", QUAD + " \"normal N\" [0 0 1 0 0 1 0 0 1 0 0 1]"})
    void flatLampsEmitToTheSideOfTheirNormalAndReflect(String shape) throws IOException {
        assertEquals(1, front(shape).z());
        assertEquals(-1, front("ReverseOrientation " + shape).z());
        assertEquals(1, front("Scale -1 1 1 " + shape).z());
        assertEquals(-1, front("Scale 1 1 -1 " + shape).z());
        assertEquals(1, front("ReverseOrientation Scale 1 1 -1 " + shape).z());
    }

    @Test
    void normalsOfVerticesCountBeforeTheWinding() throws IOException {
        assertEquals(
                -1, front(QUAD + " \"normal N\" [0 0 -1 0 0 -1 0 0 -1 0 0 -1]").z());
    }

    @Test
    void partsOfSpheresEmitOutwardsOrInwards() throws IOException {
        String cap = "Shape \"sphere\" \"float zmax\" .5";
        for (String reversed : new String[] {"", "ReverseOrientation "}) {
            SceneObject o = object("\"rgb L\" [1 2 3]", reversed + cap);
            double outwards = Fronts.normal(o.shape()).dot(Fronts.point(o.shape()));
            assertEquals(reversed.isEmpty(), outwards > 0);
            assertEquals(
                    Material.EmissionPattern.Side.FRONT, o.material().pattern().side());
        }
    }

    @Test
    void tubesAndBallsEmitOutwardsUnlessTheyAreReversed() throws IOException {
        String light = "\"rgb L\" [1 2 3]";
        for (String type : new String[] {"sphere", "cylinder"}) {
            String shape = "Shape \"" + type + "\"";
            SceneImporter.Result inwards = lamp(light, "ReverseOrientation " + shape);
            assertEquals(List.of(), inwards.notes());
            assertEquals(
                    Material.EmissionPattern.Side.BACK,
                    side(inwards.scene().objects().get(0)));
            assertEquals(List.of(), lamp(light, shape).notes());
        }
        assertInstanceOf(Sphere.class, object(light, "Shape \"sphere\"").shape());
        SceneObject tube = object(light, "Shape \"cylinder\"");
        assertInstanceOf(Cylinder.class, tube.shape());
        assertEquals(Material.EmissionPattern.Side.FRONT, side(tube));
    }

    private static Material.EmissionPattern.Side side(SceneObject o) {
        return o.material().pattern().side();
    }

    @Test
    void twoSidedLampsEmitToBothSides() throws IOException {
        SceneObject o = object("\"rgb L\" [1 2 3] \"bool twosided\" true", "ReverseOrientation " + QUAD);
        assertEquals(Material.EmissionPattern.Side.BOTH, side(o));
        assertEquals(1, Fronts.normal(o.shape()).normalized().z());
    }

    @Test
    void aPictureOfALampBecomesItsMap() throws IOException {
        ImageFiles.writePng(new Image(1, 1, new float[] {0.5f, 0.5f, 0.5f}), folder.resolve("p.png"));
        SceneObject o =
                object("\"string filename\" \"p.png\" \"float scale\" 4", QUAD + " \"point2 uv\" [0 0 1 0 1 1 0 1]");
        assertEquals(Rgb.gray(4), o.material().radiance());
        Texture.File map = (Texture.File) o.material().radianceMap().orElseThrow();
        assertEquals("p.png", map.file().getFileName().toString());
        assertEquals(Texture.Encoding.SRGB, map.encoding());
        TriangleMesh mesh = ((Mesh) o.shape()).triangles();
        for (int v = 0; v < mesh.vertices(); v++) {
            assertEquals((1 + mesh.position(v).y()) / 2, mesh.uv(v, 1));
        }
    }

    @Test
    void picturesOfFloatsAreDividedByTheirLargestComponent() throws IOException {
        float[] light = {8, 2, 0, 4, 4, 1};
        ImageFiles.writePfm(new Image(2, 1, light, Color.Encoding.LINEAR), folder.resolve("p.pfm"));
        Material m = object("\"string filename\" \"p.pfm\"", QUAD).material();
        assertEquals(Rgb.gray(8), m.radiance());
        Image map = ImageFiles.read(((Texture.File) m.radianceMap().orElseThrow()).file());
        for (int i = 0; i < light.length; i++) {
            assertEquals(light[i] / 8, map.component(i / 3, 0, i % 3), 1.0 / 65535);
        }
    }

    @Test
    void powerIsSharedByAreaAndMeanLuminance() throws IOException {
        float[] light = {8, 2, 0, 4, 4, 1};
        ImageFiles.writePfm(new Image(2, 1, light, Color.Encoding.LINEAR), folder.resolve("p.pfm"));
        Material m =
                object("\"string filename\" \"p.pfm\" \"float power\" 7", QUAD).material();
        double mean = 0.2126 * 6 + 0.7152 * 3 + 0.0722 * 0.5;
        // Φ = π A L of the mean luminance; the map is relative to 8.
        assertEquals(7 / (Math.PI * 4 * mean) * 8, m.radiance().g(), 1e-12);
    }
}
