package enlightenment.world.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.frame.Bounds;
import enlightenment.frame.SceneFrame;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The rays of each camera against the geometry of its description. */
class CompiledCameraTest {
    private static final int WIDTH = 300;
    private static final int HEIGHT = 100;
    private static final double ASPECT = 3;

    /** Lengths in the frame are a quarter of those in the scene. */
    private static final int EXPONENT = 2;

    private static final double UNIT = 0.25;
    private static final double TOLERANCE = 1e-15;

    private static CompiledCamera compile(Camera camera) {
        return CompiledCamera.of(camera, new SceneFrame(camera.origin(), EXPONENT), WIDTH, HEIGHT);
    }

    private static Ray ray(CompiledCamera camera, double x, double y) {
        Ray ray = new Ray();
        camera.ray(x, y, ray);
        return ray;
    }

    private static Vec3 origin(Ray ray) {
        return new Vec3(ray.ox, ray.oy, ray.oz);
    }

    private static Vec3 direction(Ray ray) {
        return new Vec3(ray.dx, ray.dy, ray.dz);
    }

    private static void assertClose(Vec3 expected, Vec3 actual, String what) {
        double size = Math.max(1, expected.maxAbs());
        assertEquals(0, expected.minus(actual).maxAbs(), TOLERANCE * size, what + ": " + expected + " and " + actual);
    }

    @Test
    void aWindowsRaysGoFromTheEyeThroughTheWindow() {
        ExactPoint eye = ExactPoint.of(1, 2, -3);
        // A slanted parallelogram that is not centred before the eye.
        Vec3 lowerLeft = new Vec3(-2, 0, 1);
        Vec3 up = new Vec3(0.5, 3, 0.25);
        Vec3 right = new Vec3(4, 0.5, -1);
        ExactPoint corner = ExactPoint.of(lowerLeft.x(), lowerLeft.y(), lowerLeft.z());
        CompiledCamera camera = compile(
                new Camera.Window(eye, corner, corner.plus(up), corner.plus(up.plus(right)), corner.plus(right), 0));
        for (double x : new double[] {0, 0.25, 0.5, 0.875, 1}) {
            for (double y : new double[] {0, 0.125, 0.5, 1}) {
                Ray ray = ray(camera, x, y);
                Vec3 onWindow = lowerLeft.plus(up.times(1 - y)).plus(right.times(x));
                assertEquals(Vec3.ZERO, origin(ray), "the eye is the frame's origin");
                assertClose(onWindow.minus(eye.toVec3()).times(UNIT), direction(ray), "window at " + x + ", " + y);
                assertEquals(1, ray.tMin, "rays start on the window");
            }
        }
    }

    @Test
    void aPerspectiveRayHasTheSlopeOfItsPositionInTheFieldOfView() {
        double half = StrictMath.tan(StrictMath.toRadians(35));
        CompiledCamera camera = compile(
                new Camera.Perspective(ExactPoint.of(1, 2, 3), ExactPoint.of(1, 2, 11), new Vec3(0, 2, 0.5), 70));
        for (double x : new double[] {0, 0.25, 0.5, 1}) {
            for (double y : new double[] {0, 0.5, 0.75, 1}) {
                Ray ray = ray(camera, x, y);
                assertEquals(Vec3.ZERO, origin(ray));
                // For a viewer along +z, +x is to the right and +y up; y grows downwards in the picture.
                Vec3 expected = new Vec3(half * ASPECT * (2 * x - 1), half * (1 - 2 * y), 1);
                assertClose(expected, direction(ray).times(1 / ray.dz), "position " + x + ", " + y);
                assertEquals(0, ray.tMin);
            }
        }
    }

    @Test
    void aPerspectiveInAnyDirectionHasItsAngleOfViewAndLooksWhereItShould() {
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < 200; i++) {
            Vec3 along = vector(random);
            Vec3 up = vector(random);
            double angle = 1 + 170 * random.nextDouble();
            CompiledCamera camera =
                    compile(new Camera.Perspective(ExactPoint.ORIGIN, ExactPoint.ORIGIN.plus(along), up, angle));
            Vec3 forward = along.normalized();
            // The ray in the middle is a sum of the corner and of half the picture's width and height, which cancel.
            double widest = ASPECT * StrictMath.tan(StrictMath.toRadians(angle / 2));
            assertEquals(0, direction(ray(camera, 0.5, 0.5)).cross(forward).length(), TOLERANCE * (1 + widest));
            Vec3 top = direction(ray(camera, 0.5, 0));
            Vec3 bottom = direction(ray(camera, 0.5, 1));
            double measured =
                    StrictMath.toDegrees(StrictMath.atan2(top.cross(bottom).length(), top.dot(bottom)));
            assertEquals(angle, measured, 1e-12 * 180);
            // The top of the picture is on the side of up, and all three lie in one plane with it.
            assertTrue(top.minus(bottom).dot(up) > 0, "upside down");
            assertEquals(0, top.cross(bottom).normalized().dot(up.normalized()), 1e-12);
            Vec3 left = direction(ray(camera, 0, 0.5));
            Vec3 right = direction(ray(camera, 1, 0.5));
            assertEquals(ASPECT, right.minus(left).length() / top.minus(bottom).length(), 1e-12);
            assertTrue(up.cross(forward).dot(right.minus(left)) > 0, "mirrored");
        }
    }

    @ParameterizedTest
    @CsvSource({
        "VERTICAL, 300, 100, 1", "VERTICAL, 100, 300, 1", "HORIZONTAL, 300, 100, 0", "HORIZONTAL, 100, 300, 0",
        "SMALLER, 300, 100, 1", "SMALLER, 100, 300, 0", "LARGER, 300, 100, 0", "LARGER, 100, 300, 1"
    })
    void theFieldOfViewSpansItsAxis(Camera.FieldOfViewAxis axis, int width, int height, int spanned) {
        Camera.Perspective p =
                new Camera.Perspective(ExactPoint.ORIGIN, ExactPoint.of(0, 0, 1), Vec3.Y, 90).withAxis(axis);
        CompiledCamera camera = CompiledCamera.of(p, new SceneFrame(p.origin(), 0), width, height);
        Vec3 d = direction(ray(camera, 1, 0));
        double across = d.x() / d.z();
        double up = d.y() / d.z();
        assertEquals(1, spanned == 0 ? across : up, TOLERANCE);
        assertEquals((double) width / height, across / up, 4 * TOLERANCE);
    }

    @Test
    void aRightHandedViewIsTheMirrorImageOfALeftHandedOne() {
        ExactPoint eye = ExactPoint.of(1, 2, 3);
        ExactPoint aim = ExactPoint.of(2, 1, -4);
        List<List<Camera>> pairs = List.of(
                List.of(
                        new Camera.Perspective(eye, aim, Vec3.Y, 50),
                        new Camera.Perspective(eye, aim, Vec3.Y, 50).withHandedness(Camera.Handedness.RIGHT)),
                List.of(
                        new Camera.Orthographic(eye, aim, Vec3.Y, 5),
                        new Camera.Orthographic(eye, aim, Vec3.Y, 5, Camera.Handedness.RIGHT)),
                List.of(
                        new Camera.Panorama(eye, aim, Vec3.Y),
                        new Camera.Panorama(eye, aim, Vec3.Y, 0, Camera.Handedness.RIGHT)));
        for (List<Camera> pair : pairs) {
            for (double x : new double[] {0, 0.125, 0.5, 1}) {
                Ray left = ray(compile(pair.get(0)), x, 0.25);
                Ray right = ray(compile(pair.get(1)), 1 - x, 0.25);
                assertClose(direction(left), direction(right), pair.get(0).type());
                assertClose(origin(left), origin(right), pair.get(0).type());
            }
        }
        // The picture's right is forward × up.
        Camera towardsZ = new Camera.Perspective(ExactPoint.ORIGIN, ExactPoint.of(0, 0, -1), Vec3.Y, 50)
                .withHandedness(Camera.Handedness.RIGHT);
        assertTrue(direction(ray(compile(towardsZ), 1, 0.5)).x() > 0);
    }

    @Test
    void aPanoramaHasLongitudesFromLeftToRightAndLatitudesDownwards() {
        CompiledCamera camera =
                compile(new Camera.Panorama(ExactPoint.of(1, 2, 3), ExactPoint.of(1, 2, 5), new Vec3(0, 3, 0.5)));
        for (double x : new double[] {0, 0.25, 0.4, 0.5, 0.75, 1}) {
            for (double y : new double[] {0, 0.2, 0.5, 1}) {
                double longitude = 2 * Math.PI * (x - 0.5);
                double latitude = Math.PI * (0.5 - y);
                double level = StrictMath.cos(latitude);
                Vec3 expected = new Vec3(
                        level * StrictMath.sin(longitude), StrictMath.sin(latitude), level * StrictMath.cos(longitude));
                Ray ray = ray(camera, x, y);
                assertClose(expected, direction(ray), "at " + x + ", " + y);
                assertEquals(0, origin(ray).maxAbs());
                assertEquals(0, ray.tMin);
            }
        }
    }

    /** Right eye minus left eye is the separation, towards the right of the longitude. */
    @Test
    void theEyesOfAStereoPairStandBesideEachOtherForEachLongitude() {
        CompiledCamera camera = compile(new Camera.Panorama(
                ExactPoint.of(1, 2, 3), ExactPoint.of(1, 2, 5), Vec3.Y, 0.5, Camera.Handedness.LEFT));
        for (double x : new double[] {0, 0.25, 0.4, 0.5, 0.75}) {
            for (double y : new double[] {0.125, 0.5, 0.75}) {
                Ray left = ray(camera, x, y / 2);
                Ray right = ray(camera, x, 0.5 + y / 2);
                assertClose(direction(left), direction(right), "parallel");
                double longitude = 2 * Math.PI * (x - 0.5);
                Vec3 beside = new Vec3(StrictMath.cos(longitude), 0, -StrictMath.sin(longitude));
                assertClose(beside.times(0.5 * UNIT), origin(right).minus(origin(left)), "apart");
                assertClose(Vec3.ZERO, origin(right).plus(origin(left)), "around the middle");
            }
        }
    }

    private static Vec3 vector(SplittableRandom random) {
        return new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    }

    @Test
    void orthographicRaysAreParallelAndStartInThePlaneOfTheEye() {
        double height = 4;
        CompiledCamera camera = compile(
                new Camera.Orthographic(ExactPoint.of(1, 2, 3), ExactPoint.of(1, 2, 5), new Vec3(0, 3, 0.5), height));
        for (double x : new double[] {0, 0.25, 1}) {
            for (double y : new double[] {0, 0.5, 1}) {
                Ray ray = ray(camera, x, y);
                Vec3 start = new Vec3(height * ASPECT * (x - 0.5), height * (0.5 - y), 0);
                assertClose(start.times(UNIT), origin(ray), "start at " + x + ", " + y);
                assertClose(Vec3.Z, direction(ray), "parallel to the line of sight");
                assertEquals(0, ray.tMin);
            }
        }
    }

    @Test
    void anIsometricRayPassesThroughThePointThatTheDrawingShowsThere() {
        double height = 5;
        ExactPoint lookAt = ExactPoint.of(3, -1, 2);
        CompiledCamera camera = compile(new Camera.Isometric(lookAt, height));
        SplittableRandom random = new SplittableRandom(6);
        for (int i = 0; i < 500; i++) {
            Vec3 p = vector(random).times(4);
            double drawnX = (p.x() - p.z()) * Math.sqrt(0.75);
            double drawnY = p.y() + (p.x() + p.z()) / 2;
            Ray ray = ray(camera, 0.5 + drawnX / (height * ASPECT), 0.5 - drawnY / height);
            Vec3 offset = p.times(UNIT).minus(origin(ray));
            assertEquals(0, offset.cross(direction(ray)).length(), 8 * TOLERANCE, "the ray misses " + p);
            assertEquals(1, direction(ray).length(), TOLERANCE);
            // Every coordinate in the frame is below 2, so no point is farther than √12 behind the plane.
            double start = origin(ray).plus(direction(ray).times(ray.tMin)).dot(direction(ray));
            assertTrue(start < -Math.sqrt(12), "rays start behind everything");
        }
        assertTrue(direction(ray(camera, 0.5, 0.5)).dot(new Vec3(1, -1, 1)) > 1.7, "seen from above, from -x and -z");
    }

    @Test
    void theStartBoundsHoldTheStartsOfAllRays() {
        Camera[] cameras = {
            new Camera.Window(
                    ExactPoint.of(0, 1, -3),
                    ExactPoint.of(-3, 0, 0),
                    ExactPoint.of(-3, 3, 0),
                    ExactPoint.of(3, 3, 0),
                    ExactPoint.of(3, 0, 0),
                    0),
            new Camera.Perspective(ExactPoint.ORIGIN, ExactPoint.of(1, 2, 3), Vec3.Y, 40),
            new Camera.Orthographic(ExactPoint.ORIGIN, ExactPoint.of(1, 2, 3), Vec3.Y, 3),
            new Camera.Isometric(ExactPoint.ORIGIN, 3),
            new Camera.Panorama(ExactPoint.ORIGIN, ExactPoint.of(1, 2, 3), Vec3.Y, 0.5, Camera.Handedness.LEFT)
        };
        for (Camera c : cameras) {
            CompiledCamera camera = compile(c);
            Bounds bounds = camera.startBounds();
            for (int i = 0; i <= 16; i++) {
                for (int j = 0; j <= 16; j++) {
                    Ray ray = ray(camera, i / 16.0, j / 16.0);
                    Vec3 start = origin(ray).plus(direction(ray).times(ray.tMin));
                    assertTrue(bounds.contains(start), c.type() + " at " + i + ", " + j);
                }
            }
        }
    }
}
