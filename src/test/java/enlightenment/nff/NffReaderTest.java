package enlightenment.nff;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Triangle;
import enlightenment.image.Image;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.Shading;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;

class NffReaderTest {
    private static final String VIEW = "v\nfrom 0 0 -5\nat 0 0 0\nup 0 1 0\nangle 90\nhither 1\nresolution 101 101\n";

    private static NffReader.Result parse(String text) {
        return NffReader.parse(VIEW + text, "x.nff", "x");
    }

    private static Shape onlyShape(String text) {
        List<enlightenment.scene.SceneObject> objects = parse(text).scene().objects();
        assertEquals(1, objects.size());
        return objects.get(0).shape();
    }

    private static Material material(String fill) {
        return parse(fill + "\ns 0 0 0 1").scene().objects().get(0).material();
    }

    private static Scene database(String name) throws IOException {
        return NffReader.read(Path.of("src", "test", "resources", "enlightenment", "nff", name)
                        .toAbsolutePath())
                .scene();
    }

    private static long count(Scene scene, Class<? extends Shape> kind) {
        return scene.objects().stream().filter(o -> kind.isInstance(o.shape())).count();
    }

    private static String problem(String text) {
        SceneException e = assertThrows(SceneException.class, () -> NffReader.parse(text, "x.nff", "x"));
        return e.problems().get(0).toString();
    }

    @Test
    void ballsHaveTheirNumberOfSpheresAndAFloor() throws IOException {
        Scene scene = database("balls-2.nff");
        assertEquals(91, count(scene, Sphere.class));
        assertEquals(1, count(scene, Rectangle.class));
        assertEquals(92, scene.objects().size());
        assertEquals("balls-2", scene.name());
        assertEquals(512, scene.width());
        assertEquals(3, scene.lights().size());
        assertEquals(2, scene.materials().size());
        assertEquals(new DisplayRgb(0.078, 0.361, 0.753), ((Shading.Classic) scene.shading()).background());
    }

    @Test
    void theLargerBallsHaveSevenThousandSpheres() throws IOException {
        Path file = Path.of(System.getProperty("project.directory", "."), "..", "shared", "data", "spd", "balls-4.nff");
        Assumptions.assumeTrue(Files.isReadable(file));
        Scene scene = NffReader.read(file).scene();
        assertEquals(7381, count(scene, Sphere.class));
        assertEquals(7382, scene.objects().size());
    }

    @Test
    void ringsAreSpheresAndOpenCylinders() throws IOException {
        Scene scene = database("rings-3.nff");
        List<String> lines =
                Files.readAllLines(Path.of("src", "test", "resources", "enlightenment", "nff", "rings-3.nff"));
        long cones = lines.stream().filter(l -> l.startsWith("c ")).count();
        long spheres = lines.stream().filter(l -> l.startsWith("s ")).count();
        assertEquals(cones, count(scene, Cylinder.class));
        assertEquals(spheres, count(scene, Sphere.class));
        assertEquals(1, count(scene, Rectangle.class));
        assertTrue(scene.objects().stream().allMatch(o -> !(o.shape() instanceof Cylinder c) || !c.capped()));
    }

    @Test
    void theTetrahedronHasFourToTheFourthTimesFourTriangles() throws IOException {
        Scene scene = database("tetra-4.nff");
        assertEquals(256, count(scene, Triangle.class));
        assertEquals(256, scene.objects().size());
    }

    @Test
    void decimalsStayExact() {
        Sphere s = (Sphere) onlyShape("s 0.1 1.11022e-16 -100000000000000000000.3 0.0555556");
        assertEquals(ExactPoint.of("0.1", "1.11022e-16", "-100000000000000000000.3"), s.center());
        assertEquals(0.0555556, s.radius());
        assertEquals(ExactPoint.of("-0.5", "0.5", "3"), ((Sphere) onlyShape("s -.5 +.5 3. 1")).center());
    }

    @Test
    void theWindowStandsAtTheHitherPlaneWithTheViewersRightOnTheRight() {
        // Looking along +z with y up in right-handed axes, the viewer's right is forward × up = −x.
        Camera.Window w = (Camera.Window) parse("").scene().camera();
        assertEquals(ExactPoint.of(0, 0, -5), w.eye());
        Vec3 right = w.lowerRight().minus(w.lowerLeft());
        Vec3 up = w.upperLeft().minus(w.lowerLeft());
        assertTrue(right.x() < 0 && right.y() == 0 && right.z() == 0, right::toString);
        assertTrue(up.y() > 0 && up.x() == 0 && up.z() == 0, up::toString);
        assertEquals(ExactPoint.of(0, 0, -4).z(), w.lowerLeft().z());
    }

    @Test
    void theAngleEndsAtTheCentresOfTheOuterPixels() {
        // tan 45° = 1: centres of the outer rows are 2 apart at distance 1, over 100 steps; 101 pixels are 2.02 high.
        Camera.Window w = (Camera.Window) parse("").scene().camera();
        assertEquals(2.02, w.upperLeft().minus(w.lowerLeft()).length(), 4 * Math.ulp(2.02));
        assertEquals(2.02, w.lowerRight().minus(w.lowerLeft()).length(), 4 * Math.ulp(2.02));
    }

    @Test
    void theWindowFollowsAnEyeFarFromTheOrigin() {
        String far = VIEW.replace("from 0 0 -5", "from 0 0 -1e15").replace("at 0 0 0", "at 0 0 -999999999999999.9");
        Camera.Window w =
                (Camera.Window) NffReader.parse(far, "x.nff", "x").scene().camera();
        Camera.Window near = (Camera.Window) parse("").scene().camera();
        BigDecimal farOffset = w.upperLeft().x().subtract(w.eye().x());
        assertEquals(near.upperLeft().x().subtract(near.eye().x()), farOffset);
    }

    @Test
    void withoutAHitherPlaneTheWindowHasNoRoomBeforeIt() {
        Camera.Window w = (Camera.Window) NffReader.parse(VIEW.replace("hither 1\n", ""), "x.nff", "x")
                .scene()
                .camera();
        assertEquals(0, w.lowerLeft().minus(w.eye()).z() - 5 * 0x1p-40, 1e-25);
    }

    @Test
    void fillsBecomeGlassMirrorOrMatte() {
        Texture color = Texture.of(new DisplayRgb(1, 0.5, 0));
        assertEquals(Material.Matte.of(color), material("f 1 0.5 0 0.8 0.3 3 0 1"));
        assertEquals(Material.Mirror.of(color), material("f 1 0.5 0 0 0.3 3 0 1"));
        assertEquals(Material.Matte.of(color), material("f 1 0.5 0 0 0 3 0 1"));
        assertEquals(new Glass(color, 1.5, 0.75, 0, true), material("f 1 0.5 0 0 0.3 3 0.75 1.5"));
    }

    @Test
    void equalFillsAreOneMaterialAndUnusedOnesNone() {
        String a = "f 1 0 0 1 0 1 0 1\n";
        String b = "f 0 1 0 1 0 1 0 1\n";
        String unused = "f 0 0 1 1 0 1 0 1\n";
        Scene scene = parse(a + "s 0 0 0 1\n" + b + "s 0 0 0 2\n" + unused + a + "s 0 0 0 3\n")
                .scene();
        assertEquals(2, scene.materials().size());
        assertEquals(
                System.identityHashCode(scene.objects().get(0).material()),
                System.identityHashCode(scene.objects().get(2).material()));
    }

    @Test
    void conesAreOpenAndTakeTheirWiderEndAsBase() {
        ExactPoint p = ExactPoint.of(0, 0, 0);
        ExactPoint q = ExactPoint.of(0, 0, 3);
        assertEquals(new Cone(p, q, 2, 1, false), onlyShape("c\n0 0 0 2\n0 0 3 1\n"));
        assertEquals(new Cone(q, p, 2, 1, false), onlyShape("c 0 0 0 1 0 0 3 2"));
        assertEquals(new Cone(q, p, 2, 0, false), onlyShape("c 0 0 0 0 0 0 3 2"));
        assertEquals(new Cylinder(p, q, 2, false), onlyShape("c 0 0 0 2 0 0 3 2"));
        assertEquals(new Cylinder(p, q, 2, false), onlyShape("c 0 0 0 -2 0 0 3 -2"));
    }

    @Test
    void lightsMayHaveAColour() {
        List<Light> lights =
                parse("l 1 2 3\nl 1 2 3 0.5 0.25 0\nl 4 5 6 4 2 0").scene().lights();
        assertEquals(new Light.Point(ExactPoint.of(1, 2, 3), DisplayRgb.WHITE), lights.get(0));
        assertEquals(new Light.Point(ExactPoint.of(1, 2, 3), new DisplayRgb(0.5, 0.25, 0)), lights.get(1));
        assertEquals(new Light.Point(ExactPoint.of(4, 5, 6), new DisplayRgb(1, 0.5, 0)), lights.get(2));
    }

    @Test
    void commentsAndAnyLineBreaksAreAccepted() {
        Scene scene = parse("# s 1 1 1 1\r\ns 0 0\r\n0 # centre\r\n1#radius\r\np 3 0 0 0 1 0 0 0 1 0")
                .scene();
        assertEquals(2, scene.objects().size());
    }

    @Test
    void whatIsLeftOutIsNotedOnceWithItsLines() {
        NffReader.Result read = parse("f 1 1 1 0.5 0.2 9 0 1\ns 0 0 0 -1\ns 0 0 0 0\ns 0 0 0 -2\n"
                + "pp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\np 3 0 0 0 1 1 1 2 2 2\n");
        assertEquals(
                List.of(
                        "line 8: Ks 0.2 and Shine are not used: beside Kd > 0 the surface is matte",
                        "line 8: Kd 0.5 is not used: a matte surface shows its colour as written",
                        "lines 9 and 11: a negative radius shows the inside only; here both sides are seen",
                        "line 10: a sphere of radius 0 is left out",
                        "line 12: the normals of a patch are not used: it is shown flat",
                        "line 16: a polygon without area is left out"),
                read.notes());
        assertEquals(3, read.scene().objects().size());
    }

    @Test
    void manyLinesAreNotAllListed() {
        String none = "s 0 0 0 0\n";
        String left = ": a sphere of radius 0 is left out";
        assertEquals(List.of("lines 8, 9 and 10" + left), parse(none.repeat(3)).notes());
        assertEquals(
                List.of("lines 8, 9, 10 and 2 more" + left),
                parse(none.repeat(5)).notes());
    }

    @Test
    void aBallOnTheViewersRightIsSeenOnTheRightAndOneAboveAbove() {
        // Looking along +z with y up, −x is on the right in right-handed axes.
        Scene scene = parse("f 1 0 0 1 0 1 0 1\ns -3 0 0 1\nf 0 1 0 1 0 1 0 1\ns 0 3 0 1\n")
                .scene();
        Image image = Renderer.render(scene, RenderSettings.of(scene).withAntialias(1));
        int right = (int) (50.5 + 3 / 5.05 * 50.5);
        int above = (int) (50.5 - 3 / 5.05 * 50.5);
        assertTrue(image.component(right, 50, 0) > 0 && image.component(right, 50, 1) == 0);
        assertTrue(image.component(50, above, 1) > 0 && image.component(50, above, 0) == 0);
        assertEquals(0, image.component(100 - right, 50, 0));
        assertEquals(0, image.component(50, 100 - above, 1));
    }

    @Test
    void problemsNameLineColumnAndWhatWasExpected() {
        assertEquals("x.nff:8:7: expected the sphere's centre z (a number), not 'x'", problem(VIEW + "s 0 0 x 1"));
        assertEquals(
                "x.nff:9:1: expected the sphere's radius (a number), not the end of the file",
                problem(VIEW + "s 0 0 0\n"));
        assertEquals(
                "x.nff:8:1: expected an entity (v, b, l, f, c, s, p or pp), not 'sphere'",
                problem(VIEW + "sphere 0 0 0 1"));
        assertEquals(
                "x.nff:8:11: expected an entity (v, b, l, f, c, s, p or pp), not '7': more numbers than the entity"
                        + " before it has",
                problem(VIEW + "s 0 0 0 1 7"));
        assertEquals("x.nff:8:5: expected the fill's green in 0..1, not '1.5'", problem(VIEW + "f 0 1.5 0 1 0 1 0 1"));
        assertEquals(
                "x.nff:8:3: expected the number of vertices (a whole number in 3..1000000), not '2.5'",
                problem(VIEW + "p 2.5"));
        assertEquals("x.nff:2:1: expected \"from\" in the view, not 's'", problem("v\ns 0 0 0 1"));
        assertEquals(
                "x.nff:8:1: expected a polygon that does not cross itself",
                problem(VIEW + "p 4 0 0 0 2 2 0 2 0 0 0 1 0"));
        assertEquals(
                "x.nff:8:1: expected a cone whose base and apex are different points",
                problem(VIEW + "c 0 0 0 1 0 0 0 2"));
        assertEquals(
                "x.nff:1:1: expected a view with \"at\" away from \"from\" and \"up\" not along the line of sight",
                problem(VIEW.replace("up 0 1 0", "up 0 0 2")));
        assertTrue(problem("s 0 0 0 1").startsWith("x.nff: expected a view"));
    }

    @Test
    void allTheProblemsOfAFileAreListed() {
        SceneException e = assertThrows(
                SceneException.class, () -> NffReader.parse(VIEW + "s 0 0 x 1\ns 1 1 1 1\nl 1 y\n", "x.nff", "x"));
        assertEquals(List.of(8, 10), e.problems().stream().map(p -> p.line()).toList());
    }

    @Test
    void numbersThatWouldTakeForeverAreRefused() {
        assertTrue(problem(VIEW + "s 1e999999999 0 0 1").startsWith("x.nff:8:3: expected"));
        assertTrue(problem(VIEW + "s 1e-999999999 0 0 1").startsWith("x.nff:8:3: expected"));
        assertTrue(problem(VIEW + "s 1e99999999999 0 0 1").startsWith("x.nff:8:3: expected"));
        assertEquals(
                BigDecimal.ZERO,
                ((Sphere) onlyShape("s 0e-999999999 0 0 1")).center().x());
    }
}
