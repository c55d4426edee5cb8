package enlightenment.importer.mitsuba;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Rectangle;
import enlightenment.importer.support.ImportDraft;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Shading;
import enlightenment.surroundings.Surroundings;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** Where importers go wrong. Expected values follow from Mitsuba's documentation. */
class MitsubaTrapsTest extends MitsubaSceneTest {
    private static final String BALL = "<shape type=\"sphere\"/>";

    private Camera.Window view(String inside, int width, int height) throws IOException {
        return view("", inside, width, height);
    }

    private Camera.Window view(String film, String inside, int width, int height) throws IOException {
        Camera camera = scenes.read("<sensor type=\"perspective\">" + inside
                        + "<film type=\"hdrfilm\"><integer name=\"width\" value=\"" + width
                        + "\"/><integer name=\"height\" value=\"" + height + "\"/>" + film + "</film></sensor>" + BALL)
                .camera()
                .orElseThrow();
        return camera instanceof Camera.Perspective p ? window(p, (double) width / height) : (Camera.Window) camera;
    }

    /** What a camera with a vertical angle of view sees, by a window at distance 1. */
    private static Camera.Window window(Camera.Perspective p, double aspect) {
        assertEquals(Camera.FieldOfViewAxis.VERTICAL, p.axis());
        Vec3 forward = p.eye().directionTo(p.lookAt()).normalized();
        Vec3 toLeftHand = p.up().cross(forward).normalized();
        Vec3 right = p.handedness() == Camera.Handedness.LEFT ? toLeftHand : toLeftHand.negated();
        double half = StrictMath.tan(StrictMath.toRadians(p.fieldOfView() / 2));
        Vec3 x = right.times(half * aspect);
        Vec3 y = (p.handedness() == Camera.Handedness.LEFT ? forward.cross(right) : right.cross(forward)).times(half);
        ExactPoint middle = p.eye().plus(forward);
        return new Camera.Window(
                p.eye(),
                middle.plus(x.plus(y).negated()),
                middle.plus(y.minus(x)),
                middle.plus(x.plus(y)),
                middle.plus(x.minus(y)),
                0);
    }

    private static Vec3 direction(Camera.Window w, double x, double y) {
        Vec3 right = w.lowerLeft().directionTo(w.lowerRight());
        Vec3 toLeft = w.lowerLeft().minus(w.eye());
        Vec3 across = w.lowerRight().minus(w.lowerLeft());
        Vec3 up = w.upperLeft().minus(w.lowerLeft());
        assertTrue(right.length() > 0);
        return toLeft.plus(across.times(x)).plus(up.times(y)).normalized();
    }

    private static double angle(Vec3 a, Vec3 b) {
        return StrictMath.toDegrees(StrictMath.acos(a.dot(b)));
    }

    @Test
    void fovAxisIsHorizontalUnlessItIsSaid() throws IOException {
        Camera.Window w = view("<float name=\"fov\" value=\"40\"/>", 200, 100);
        assertEquals(40, angle(direction(w, 0, 0.5), direction(w, 1, 0.5)), 1e-9);
    }

    @Test
    void fovAxisMayBeAnyOfFive() throws IOException {
        String fov = "<float name=\"fov\" value=\"40\"/><string name=\"%s\" value=\"%s\"/>";
        String[][] cases = {
            {"x", "h"}, {"y", "v"}, {"smaller", "v"}, {"larger", "h"}, {"diagonal", "d"},
        };
        for (String[] c : cases) {
            for (String name : new String[] {"fov_axis", "fovAxis"}) {
                Camera.Window w = view(fov.formatted(name, c[0]), 200, 100);
                double found =
                        switch (c[1]) {
                            case "h" -> angle(direction(w, 0, 0.5), direction(w, 1, 0.5));
                            case "v" -> angle(direction(w, 0.5, 0), direction(w, 0.5, 1));
                            default -> angle(direction(w, 0, 0), direction(w, 1, 1));
                        };
                assertEquals(40, found, 1e-9, c[0]);
            }
        }
    }

    @Test
    void theCamerasXPointsToTheLeftOfThePicture() throws IOException {
        Camera.Window w = view("<float name=\"fov\" value=\"90\"/>", 100, 100);
        Vec3 left = direction(w, 0, 0.5);
        assertTrue(left.x() > 0.7 && left.z() > 0.7, left::toString);
        assertTrue(direction(w, 0.5, 1).y() > 0.7);
    }

    @Test
    void mirroredCamerasAreMirrored() throws IOException {
        String mirror = "<transform name=\"to_world\"><scale x=\"-1\"/></transform>";
        Camera.Window w = view("<float name=\"fov\" value=\"90\"/>" + mirror, 100, 100);
        assertTrue(direction(w, 0, 0.5).x() < -0.7);
    }

    @Test
    void lookatLooksFromItsOriginToItsTarget() throws IOException {
        for (String tag : new String[] {"lookat", "lookAt"}) {
            Camera.Window w = view(
                    "<float name=\"fov\" value=\"90\"/><transform name=\"toWorld\"><" + tag
                            + " origin=\"1, 2, 3\" target=\"1, 2, 7\" up=\"0, 1, 0\"/></transform>",
                    100,
                    100);
            assertEquals(ExactPoint.of(1, 2, 3), w.eye());
            assertEquals(1, direction(w, 0.5, 0.5).z(), 1e-12);
        }
    }

    @Test
    void cropsSeeTheirPartOfTheFilm() throws IOException {
        String crop = "<integer name=\"crop_offset_x\" value=\"50\"/><integer name=\"crop_offset_y\" value=\"20\"/>"
                + "<integer name=\"crop_width\" value=\"25\"/><integer name=\"crop_height\" value=\"40\"/>";
        Camera.Window whole = view("<float name=\"fov\" value=\"70\"/>", 100, 100);
        Camera.Window part = view(crop, "<float name=\"fov\" value=\"70\"/>", 100, 100);
        assertEquals(0, direction(whole, 0.5, 0.8).minus(direction(part, 0, 1)).length(), 1e-9);
        assertEquals(0, direction(whole, 0.75, 0.4).minus(direction(part, 1, 0)).length(), 1e-9);
    }

    @Test
    void stepsOfTransformsAreAppliedInTheirOrder() throws IOException {
        ImportDraft draft = scenes.read("<emitter type=\"point\"><point name=\"position\" x=\"1\" y=\"0\" z=\"0\"/>"
                + "<transform name=\"to_world\"><scale value=\"2\"/><rotate z=\"1\" angle=\"90\"/><translate x=\"10\"/>"
                + "</transform></emitter>" + BALL);
        Vec3 at = ((Light.Point) draft.lights().get(0)).position().toVec3();
        assertEquals(0, at.minus(new Vec3(10, 2, 0)).length(), 1e-12);
    }

    @Test
    void directionalLightsShineAlongTheirDirection() throws IOException {
        ImportDraft draft = scenes.read("<emitter type=\"directional\"><vector name=\"direction\" value=\"0 -2 0\"/>"
                + "<rgb name=\"irradiance\" value=\"3 2 1\"/></emitter><emitter type=\"directional\">"
                + "<transform name=\"to_world\"><rotate x=\"1\" angle=\"90\"/></transform></emitter>" + BALL);
        Light.Distant first = (Light.Distant) draft.lights().get(0);
        assertEquals(new Rgb(3, 2, 1), first.emitted());
        // A quarter of a turn about x takes z to -y.
        for (Light light : draft.lights()) {
            Vec3 direction = ((Light.Distant) light).direction().normalized();
            assertEquals(0, direction.minus(Vec3.of(0, -1, 0)).length(), 1e-15);
        }
    }

    @Test
    void matricesAreRowByRow() throws IOException {
        ImportDraft draft = scenes.read("<emitter type=\"point\"><transform name=\"to_world\">"
                + "<matrix value=\"1 0 0 5  0 1 0 6  0 0 1 7  0 0 0 1\"/></transform></emitter>" + BALL);
        assertEquals(ExactPoint.of(5, 6, 7), ((Light.Point) draft.lights().get(0)).position());
    }

    private static final String PICTURE = "<bsdf type=\"diffuse\"><texture type=\"bitmap\" name=\"reflectance\">"
            + "<string name=\"filename\" value=\"p.png\"/></texture></bsdf>";

    @Test
    void uvOriginOfRectanglesShowsTheUpperEdgeAtTheirLowerOne() throws IOException {
        // Rendered by Mitsuba 3.9: the first row of a picture lies at y = −1.
        scenes.write("p.png", "");
        ImportDraft draft = scenes.read("<shape type=\"rectangle\">" + PICTURE + "</shape>");
        Rectangle r = (Rectangle) draft.objects().get(0).shape();
        assertEquals(ExactPoint.of(-1, 1, 0), r.lowerLeft());
        assertEquals(ExactPoint.of(-1, -1, 0), r.upperLeft());
        assertEquals(ExactPoint.of(1, 1, 0), r.lowerRight());
    }

    @Test
    void uvOriginOfMeshesDependsOnTheirFormat() throws IOException {
        scenes.write("p.png", "");
        scenes.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0.25\nvt 1 0.25\nvt 0 1\nf 1/1 2/2 3/3\n");
        scenes.write(
                "t.ply",
                "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                        + "property float u\nproperty float v\nelement face 1\nproperty list uchar int vertex_indices\n"
                        + "end_header\n0 0 0 0 0.25\n1 0 0 1 0.25\n0 1 0 0 1\n3 0 1 2\n");
        String shape = "<shape type=\"%s\"><string name=\"filename\" value=\"t.%s\"/>%s" + PICTURE + "</shape>";
        String flip = "<boolean name=\"flip_tex_coords\" value=\"%s\"/>";
        assertEquals(0.25, firstV(shape.formatted("obj", "obj", "")), 1e-7);
        assertEquals(0.75, firstV(shape.formatted("obj", "obj", flip.formatted("false"))), 1e-7);
        assertEquals(0.75, firstV(shape.formatted("ply", "ply", "")), 1e-7);
        assertEquals(0.25, firstV(shape.formatted("ply", "ply", flip.formatted("true"))), 1e-7);
    }

    /** v upwards, at the mesh's corner in the origin. */
    private double firstV(String shape) throws IOException {
        Mesh mesh = (Mesh) scenes.read(shape).objects().get(0).shape();
        return mesh.triangles().uv(0, 1);
    }

    @Test
    void checkersBeginWithTheirFirstColourAtTheUpperLeft() throws IOException {
        ImportDraft draft =
                scenes.read("<shape type=\"rectangle\"><bsdf type=\"diffuse\"><texture type=\"checkerboard\""
                        + " name=\"reflectance\"><rgb name=\"color0\" value=\"0.9\"/><rgb name=\"color1\""
                        + " value=\"0.1\"/><transform name=\"to_uv\"><scale"
                        + " value=\"3\"/></transform></texture></bsdf></shape>");
        Texture.Checker c = (Texture.Checker) draft.objects().get(0).material().color();
        assertEquals(6, c.scale());
        assertEquals(Rgb.gray(0.9), c.colors().get(0));
    }

    @Test
    void faceNormalsAreFlatAndMissingOnesAreMade() throws IOException {
        scenes.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\n");
        String shape = "<shape type=\"obj\"><string name=\"filename\" value=\"t.obj\"/>%s</shape>";
        Mesh smooth = (Mesh) scenes.read(shape.formatted("")).objects().get(0).shape();
        assertTrue(smooth.triangles().hasNormals());
        Mesh flat = (Mesh) scenes.read(shape.formatted("<boolean name=\"face_normals\" value=\"true\"/>"))
                .objects()
                .get(0)
                .shape();
        assertFalse(flat.triangles().hasNormals());
    }

    @Test
    void depthOnePathsScatterNoLight() throws IOException {
        String integrator = "<integrator type=\"path\"><integer name=\"max_depth\" value=\"%s\"/></integrator>" + BALL;
        assertEquals(0, scenes.read(integrator.formatted("1")).maxBounces().orElseThrow());
        assertEquals(7, scenes.read(integrator.formatted("8")).maxBounces().orElseThrow());
        assertTrue(scenes.read(integrator.formatted("-1")).maxBounces().isEmpty());
    }

    @Test
    void spectraOfEqualEnergyAreNoWhiteLight() throws IOException {
        // XYZ (1, 1, 1) in linear sRGB, by the matrix of IEC 61966-2-1.
        Rgb light = emitted("<spectrum name=\"radiance\" value=\"2\"/>");
        assertEquals(2 * 1.2048, light.r(), 0.02);
        assertEquals(2 * 0.9484, light.g(), 0.02);
        assertEquals(2 * 0.9087, light.b(), 0.02);
        assertEquals(Rgb.gray(2), emitted("<float name=\"radiance\" value=\"2\"/>"));
    }

    private Rgb emitted(String radiance) throws IOException {
        return scenes.read("<shape type=\"sphere\"><emitter type=\"area\">" + radiance + "</emitter></shape>")
                .objects()
                .get(0)
                .material()
                .radiance();
    }

    @Test
    void hotterBlackBodiesAreBluerAndByStefansLawBrighter() throws IOException {
        Rgb warm = emitted("<blackbody name=\"radiance\" temperature=\"3000K\"/>");
        Rgb cold = emitted("<blackbody name=\"radiance\" temperature=\"9000K\"/>");
        assertTrue(warm.r() > warm.b() && cold.b() > cold.r());
        assertTrue(cold.g() > warm.g());
    }

    @Test
    void envmapsLieAroundTheSceneAsInMitsuba() throws IOException {
        int width = 16;
        int height = 8;
        Path picture = folder.resolve("sky.pfm");
        Files.write(picture, pfm(width, height));
        for (String steps : new String[] {
            "",
            "<rotate y=\"1\" angle=\"70\"/>",
            "<rotate x=\"1\" angle=\"90\"/>",
            "<scale x=\"-1\"/>",
            "<scale x=\"-1\"/><rotate y=\"1\" angle=\"-50\"/>",
            "<rotate x=\"1\" y=\"2\" z=\"3\" angle=\"120\"/><scale value=\"3\"/>",
            "<scale z=\"-1\"/><rotate z=\"1\" angle=\"90\"/>"
        }) {
            for (int i = 0; i < width * height; i += 5) {
                compare(steps, (i % width + 0.5) / width, (i / width + 0.5) / height, picture, i);
            }
        }
    }

    /** In the direction of a texel's middle, by Mitsuba's formula, shines that texel. */
    private void compare(String steps, double u, double v, Path picture, int texel) throws IOException {
        double phi = 2 * StrictMath.PI * u;
        double theta = StrictMath.PI * v;
        // u = atan2(x, −z) / 2π, v = acos(y) / π.
        String local = StrictMath.sin(theta) * StrictMath.sin(phi) + ", " + StrictMath.cos(theta) + ", "
                + -StrictMath.sin(theta) * StrictMath.cos(phi);
        String transform = "<transform name=\"to_world\">" + steps + "</transform>";
        ImportDraft draft = scenes.read("<emitter type=\"envmap\"><string name=\"filename\" value=\"sky.pfm\"/>"
                + transform + "</emitter><emitter type=\"point\"><point name=\"position\" value=\"" + local + "\"/>"
                + transform + "</emitter>" + BALL);
        Shading.Background.Picture sky = (Shading.Background.Picture) draft.background();
        Surroundings around =
                Surroundings.read(picture, sky.radiance(), sky.rotation(), new Surroundings.Texels(true, true));
        Vec3 d = ((Light.Point) draft.lights().get(0)).position().toVec3();
        double[] rgb = new double[3];
        around.radiance(d.x(), d.y(), d.z(), rgb);
        assertArrayEquals(new double[] {texel + 1, texel + 1, texel + 1}, rgb, 1e-4, steps + " texel " + texel);
    }

    /** Each texel has its number, from 1 at the upper left. */
    private static byte[] pfm(int width, int height) {
        byte[] header = ("PF\n" + width + " " + height + "\n-1\n").getBytes(StandardCharsets.US_ASCII);
        ByteBuffer out =
                ByteBuffer.allocate(header.length + 12 * width * height).order(ByteOrder.LITTLE_ENDIAN);
        out.put(header);
        for (int y = height - 1; y >= 0; y--) {
            for (int x = 0; x < width; x++) {
                for (int c = 0; c < 3; c++) {
                    out.putFloat(y * width + x + 1);
                }
            }
        }
        return out.array();
    }

    @Test
    void picturesAroundMirrorTheSceneWithItsCamera() throws IOException {
        Files.write(folder.resolve("sky.pfm"), pfm(2, 2));
        ImportDraft draft =
                scenes.read("<emitter type=\"envmap\"><string name=\"filename\" value=\"sky.pfm\"/></emitter>"
                        + "<sensor type=\"perspective\"><float name=\"fov\" value=\"90\"/></sensor>"
                        + "<shape type=\"sphere\"><point name=\"center\" x=\"1\" y=\"0\" z=\"1\"/></shape>");
        Camera.Window w = window((Camera.Perspective) draft.camera().orElseThrow(), 1);
        // What is at +x stays at the left.
        Vec3 center = draft.objects().get(0).shape().anchors().get(0).toVec3();
        assertTrue(direction(w, 0, 0.5).dot(center) > direction(w, 1, 0.5).dot(center));
    }

    @Test
    void orthographicViewsShowXAtTheLeft() throws IOException {
        ImportDraft draft =
                scenes.read("<sensor type=\"orthographic\"><transform name=\"to_world\"><scale value=\"3\"/>"
                        + "</transform><film type=\"hdrfilm\"><integer name=\"width\" value=\"200\"/>"
                        + "<integer name=\"height\" value=\"100\"/></film></sensor>" + BALL);
        assertEquals(3, ((Camera.Orthographic) draft.camera().orElseThrow()).height(), 1e-12);
        assertTrue(draft.notes().list().isEmpty(), draft.notes().list()::toString);
    }

    @Test
    void twosidedIsNotNeededForWhatIsOneSidedInMitsuba() throws IOException {
        assertEquals(Material.Matte.of(Texture.of(Rgb.gray(0.5))), scenes.material("<bsdf type=\"diffuse\"/>"));
    }
}
