package enlightenment.importer.mitsuba;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.importer.support.ImportDraft;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.SceneException;
import java.io.IOException;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;

/** Lights that shine into a part of all directions, and lenses. */
class MitsubaLightsTest extends MitsubaSceneTest {
    private static final String BALL = "<shape type=\"sphere\"/>";

    private ImportDraft emitter(String type, String inside) throws IOException {
        return scenes.read("<emitter type=\"" + type + "\">" + inside + "</emitter>" + BALL);
    }

    private static String number(String name, double value) {
        return "<float name=\"" + name + "\" value=\"" + value + "\"/>";
    }

    private Light.Spot spot(double beam, double cutoff) throws IOException {
        return (Light.Spot) emitter("spot", number("cutoff_angle", cutoff) + number("beam_width", beam))
                .lights()
                .get(0);
    }

    /** The power of a spot of intensity 1, by the midpoint rule. */
    private static double power(java.util.function.DoubleUnaryOperator intensityByAngle) {
        int n = 100_000;
        double sum = 0;
        for (int i = 0; i < n; i++) {
            double a = StrictMath.PI * (i + 0.5) / n;
            sum += intensityByAngle.applyAsDouble(a) * StrictMath.sin(a);
        }
        return 2 * StrictMath.PI * sum * StrictMath.PI / n;
    }

    private static double smoothstep(Light.Spot s, double angle) {
        double outer = StrictMath.cos(StrictMath.toRadians(s.angle()));
        double inner = StrictMath.cos(StrictMath.toRadians(s.innerAngle()));
        double t = StrictMath.min(StrictMath.max((StrictMath.cos(angle) - outer) / (inner - outer), 0), 1);
        return t * t * (3 - 2 * t);
    }

    @Test
    void spotsHaveThePowerOfALinearFalloff() throws IOException {
        double[][] angles = {{15, 20}, {0, 20}, {5, 60}, {30, 60}, {0, 90}, {10, 180}, {170, 180}};
        for (double[] a : angles) {
            Light.Spot s = spot(a[0], a[1]);
            double b = StrictMath.toRadians(a[0]);
            double c = StrictMath.toRadians(a[1]);
            double theirs = power(x -> StrictMath.min(StrictMath.max((c - x) / (c - b), 0), 1));
            assertEquals(theirs, power(x -> smoothstep(s, x)), 1e-4 * theirs, a[0] + " " + a[1]);
            assertTrue(s.angle() <= a[1]);
        }
    }

    @Test
    void spotsShineAlongZFromTheirOrigin() throws IOException {
        ImportDraft draft = emitter(
                "spot",
                "<rgb name=\"intensity\" value=\"1 2 3\"/><transform name=\"to_world\">"
                        + "<lookat origin=\"1, 2, 3\" target=\"1, 0, 3\" up=\"0, 0, 1\"/></transform>");
        Light.Spot s = (Light.Spot) draft.lights().get(0);
        assertEquals(ExactPoint.of(1, 2, 3), s.position());
        assertEquals(-1, s.direction().normalized().y(), 1e-12);
        assertEquals(new Rgb(1, 2, 3), s.emitted());
        assertEquals(20, s.angle());
    }

    @Test
    void spotsWithASharpEdgeAreExact() throws IOException {
        ImportDraft draft = emitter("spot", number("cutoff_angle", 30) + number("beam_width", 30));
        assertEquals(30, ((Light.Spot) draft.lights().get(0)).innerAngle());
        assertTrue(draft.notes().list().isEmpty(), draft.notes().list()::toString);
    }

    @Test
    void spotsWithImpossibleAnglesAreRefusedWithTheirLine() {
        SceneException e = Assertions.assertThrows(SceneException.class, () -> spot(30, 20));
        assertTrue(e.getMessage().contains("beam_width") && e.getMessage().contains("scene.xml:2:"), e.getMessage());
    }

    private Light.Projector projector(String inside) throws IOException {
        return (Light.Projector) emitter("projector", inside).lights().get(0);
    }

    @Test
    void projectorsLightAPlaneEvenly() throws IOException {
        Light.Projector p = projector(number("fov", 60) + number("scale", 2));
        Image picture = ImageFiles.read(p.picture().file());
        double half = StrictMath.tan(StrictMath.toRadians(30));
        assertEquals(60, p.fieldOfView(), 1e-12);
        for (int i = 0; i < picture.width(); i += 15) {
            double x = half * ((2 * i + 1.0) / picture.width() - 1);
            double y = half / picture.height();
            double cosine = 1 / StrictMath.sqrt(1 + x * x + y * y);
            double intensity = p.emitted().g() * picture.component(i, picture.height() / 2, 1);
            // On the plane at distance 1: intensity · cos / distance².
            assertEquals(2 * StrictMath.PI, intensity * StrictMath.pow(cosine, 3), 1e-3);
        }
    }

    @Test
    void projectedPicturesShowTheirRightAtTheSideOfNegativeX() throws IOException {
        ImageFiles.writePng(new Image(2, 1, new float[] {1, 0, 0, 0, 0, 1}), folder.resolve("p.png"));
        Light.Projector p = projector(number("fov", 40)
                + "<texture type=\"bitmap\" name=\"irradiance\"><string name=\"filename\" value=\"p.png\"/></texture>");
        Image made = ImageFiles.read(p.picture().file());
        Vec3 right = p.up().cross(p.direction());
        assertTrue(right.x() > 0);
        // Red was at the left, which is where Mitsuba's x points, and ours is at the right there.
        assertTrue(made.component(1, 0, 0) > 0.9 && made.component(0, 0, 2) > 0.9);
    }

    private ImportDraft lens(String inside) throws IOException {
        return scenes.read("<sensor type=\"thinlens\">" + number("fov", 40) + inside + "</sensor>" + BALL);
    }

    @Test
    void thinLensesKeepTheirApertureAndFocus() throws IOException {
        ImportDraft draft = lens(number("aperture_radius", 0.25) + number("focus_distance", 7));
        Camera.Perspective camera = (Camera.Perspective) draft.camera().orElseThrow();
        assertEquals(Camera.Lens.round(0.25, 7), camera.lens().orElseThrow());
        assertTrue(draft.notes().list().isEmpty(), draft.notes().list()::toString);
    }

    @Test
    void lensesOfShiftedPicturesBecomePinholesWithANote() throws IOException {
        ImportDraft draft = lens(number("aperture_radius", 0.25)
                + number("focus_distance", 7)
                + number("principal_point_offset_x", 0.1));
        assertTrue(
                draft.notes().list().get(0).contains("pinhole"), draft.notes().list()::toString);
    }

    @Test
    void lensesWithoutFocusAreRefused() {
        SceneException e = Assertions.assertThrows(
                SceneException.class, () -> lens(number("aperture_radius", 1) + number("focus_distance", 0)));
        assertTrue(e.getMessage().contains("focus_distance"), e.getMessage());
    }
}
