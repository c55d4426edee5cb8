package enlightenment.world.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.frame.Bounds;
import enlightenment.frame.SceneFrame;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.sampling.SobolSampler;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Cameras with rays from several places: lenses, and the two eyes of a stereo panorama. */
class LensTest {
    private static final ExactPoint EYE = ExactPoint.of(1, 2, -3);
    private static final ExactPoint AIM = ExactPoint.of(0.5, 1, 2);
    private static final Vec3 UP = new Vec3(0.1, 1, 0);
    private static final double RADIUS = 0.3;
    private static final double FOCUS = 4;
    private static final int SCALE = 2;
    private static final double UNIT = 0.25;

    private final Ray ray = new Ray();
    private final SobolSampler sampler = new SobolSampler();
    private final double[] pair = new double[2];

    private static Camera.Perspective perspective(int blades) {
        return new Camera.Perspective(EYE, AIM, UP, 50).withLens(new Camera.Lens(RADIUS, FOCUS, blades, 20));
    }

    private static Camera.Window window() {
        ExactPoint corner = ExactPoint.of(-2, 0, 1);
        Vec3 up = new Vec3(0.5, 3, 0.25);
        Vec3 right = new Vec3(4, 0.5, -1);
        return new Camera.Window(EYE, corner, corner.plus(up), corner.plus(up.plus(right)), corner.plus(right), RADIUS);
    }

    private static Camera stereo() {
        return new Camera.Panorama(EYE, AIM, UP, RADIUS, Camera.Handedness.LEFT);
    }

    static Stream<Camera> cameras() {
        return Stream.of(perspective(0), perspective(5), window(), stereo());
    }

    private static CompiledCamera compile(Camera c) {
        return CompiledCamera.of(c, new SceneFrame(c.origin(), SCALE), 300, 100);
    }

    private static Vec3 at(Ray ray, double t) {
        return new Vec3(ray.ox + t * ray.dx, ray.oy + t * ray.dy, ray.oz + t * ray.dz);
    }

    /** Sets the ray of a place of the picture, and the projection to where that ray starts. */
    private void aim(CompiledCamera camera, EyeProjection eye, double x, double y, int sample) {
        sampler.pixel(3, 0, 0);
        sampler.sample(sample);
        camera.ray(x, y, sampler, ray);
        sampler.pair(0, Sampler.Purpose.LENS, pair);
        if (camera.hasLens()) {
            eye.sampleStart(pair[0], pair[1]);
        } else {
            // The left eye has the upper half of the picture.
            eye.sampleStart(y < 0.5 ? 0 : 0.75, 0);
        }
    }

    @ParameterizedTest
    @MethodSource("cameras")
    void whatARayMeetsIsSeenAtItsPlaceFromWhereTheRayStarts(Camera description) {
        CompiledCamera camera = compile(description);
        EyeProjection eye = EyeProjection.of(camera);
        assertTrue(eye.hasSeveralStarts());
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 1_000; i++) {
            double x = random.nextDouble();
            double y = random.nextDouble();
            aim(camera, eye, x, y, i);
            Vec3 p = at(ray, ray.tMin + 0.1 + 3 * random.nextDouble());
            assertTrue(eye.project(p.x(), p.y(), p.z()));
            assertEquals(x, eye.x, 1e-12);
            assertEquals(y, eye.y, 1e-12);
            Vec3 back = p.plus(new Vec3(eye.toEyeX, eye.toEyeY, eye.toEyeZ));
            assertEquals(0, back.minus(at(ray, ray.tMin)).maxAbs(), 1e-12);
            Vec3 d = new Vec3(ray.dx, ray.dy, ray.dz).normalized();
            assertEquals(0, d.plus(new Vec3(eye.dx, eye.dy, eye.dz)).maxAbs(), 1e-12);
            double importance = eye.importance;
            eye.startWith(ray);
            assertEquals(1, eye.importanceOf(p.x(), p.y(), p.z()) / importance, 1e-10);
        }
    }

    /** A small patch that faces the ray: its area in the picture, over its own and the probability of the start. */
    @ParameterizedTest
    @MethodSource("cameras")
    void importanceIsTheAreaInThePictureOverTheProbabilityOfTheStart(Camera description) {
        CompiledCamera camera = compile(description);
        double probability = camera.hasLens() ? 1 : 0.5;
        EyeProjection eye = EyeProjection.of(camera);
        SplittableRandom random = new SplittableRandom(2);
        double size = 1e-5;
        for (int i = 0; i < 100; i++) {
            aim(camera, eye, 0.1 + 0.8 * random.nextDouble(), 0.1 + 0.3 * random.nextDouble(), i);
            Vec3 p = at(ray, ray.tMin + 1 + random.nextDouble());
            assertTrue(eye.project(p.x(), p.y(), p.z()));
            double importance = eye.importance;
            double x = eye.x;
            double y = eye.y;
            Vec3 d = new Vec3(eye.dx, eye.dy, eye.dz);
            Vec3 a = d.cross(new Vec3(0.3, -0.5, 0.7)).normalized();
            Vec3 b = d.cross(a);
            double[] place = new double[4];
            for (int k = 0; k < 2; k++) {
                Vec3 q = p.plus((k == 0 ? a : b).times(size));
                assertTrue(eye.project(q.x(), q.y(), q.z()));
                place[2 * k] = eye.x - x;
                place[2 * k + 1] = eye.y - y;
            }
            double area = Math.abs(place[0] * place[3] - place[1] * place[2]) / (size * size);
            assertEquals(1, area / probability / importance, 1e-3);
        }
    }

    @Test
    void allRaysOfAPlaceMeetInThePlaneInFocus() {
        for (Camera description : List.of(perspective(0), perspective(7), window())) {
            CompiledCamera camera = compile(description);
            Ray middle = new Ray();
            // A perspective's directions go 1 forward, a window's to the window.
            double focus = description instanceof Camera.Window ? 1 : FOCUS * UNIT;
            for (int i = 0; i < 200; i++) {
                double x = i % 10 / 10.0;
                double y = i / 10 / 20.0;
                camera.ray(x, y, middle);
                sampler.pixel(4, 1, 1);
                sampler.sample(i);
                camera.ray(x, y, sampler, ray);
                assertEquals(0, at(ray, focus).minus(at(middle, focus)).maxAbs(), 1e-15);
                assertTrue(at(ray, 0).maxAbs() > 0);
            }
        }
    }

    /** Half of the radius holds a quarter of the area. */
    @ParameterizedTest
    @ValueSource(ints = {0, 3, 6, 100})
    void pointsOfAnApertureAreUniformInItsArea(int blades) {
        Aperture aperture = new Aperture(blades, 20);
        double inner = blades == 0 ? 1 : StrictMath.cos(Math.PI / blades);
        double[] out = new double[3];
        int samples = 1 << 16;
        int inside = 0;
        double sumX = 0;
        double sumY = 0;
        SplittableRandom random = new SplittableRandom(5);
        for (int k = 0; k < samples; k++) {
            aperture.sample(random.nextDouble(), random.nextDouble(), out);
            double from = blades == 0 ? Math.hypot(out[0], out[1]) : edge(blades, out) / inner;
            assertTrue(from <= 1 + 1e-12, "outside: " + from);
            inside += from < 0.5 ? 1 : 0;
            sumX += out[0];
            sumY += out[1];
        }
        // Six standard deviations; a coordinate's variance is at most 1/4.
        double error = 6 / Math.sqrt(samples);
        assertEquals(0.25, (double) inside / samples, error * Math.sqrt(3.0 / 16));
        assertEquals(0, sumX / samples, error / 2);
        assertEquals(0, sumY / samples, error / 2);
    }

    /** The largest distance from the centre across any edge. */
    private static double edge(int blades, double[] p) {
        double most = 0;
        for (int k = 0; k < blades; k++) {
            double across = StrictMath.toRadians(20 + 360 * (k + 0.5) / blades);
            most = Math.max(most, p[0] * StrictMath.cos(across) + p[1] * StrictMath.sin(across));
        }
        return most;
    }

    @ParameterizedTest
    @MethodSource("cameras")
    void theStartsOfAllRaysLieInTheirBounds(Camera description) {
        CompiledCamera camera = compile(description);
        Bounds bounds = camera.startBounds();
        RayStarts starts = camera.rayStarts();
        for (int i = 0; i < 1000; i++) {
            aim(camera, EyeProjection.of(camera), i % 32 / 32.0, i / 1000.0, i);
            Vec3 start = at(ray, ray.tMin);
            assertTrue(bounds.contains(start));
            assertTrue(starts.mayLieIn(Bounds.of(start)));
        }
        Vec3 far = new Vec3(1.5, 1.5, -1.5);
        assertFalse(starts.mayLieIn(Bounds.of(far)));
    }

    /** With rays from several places no plane bounds those of a tile. */
    @ParameterizedTest
    @MethodSource("cameras")
    void aTileReachesEveryBox(Camera description) {
        TileFrustum tile = new TileFrustum();
        tile.set(compile(description), 0.25, 0.25, 0.5, 0.5);
        Bounds[] boxes = {Bounds.of(new Vec3(1, 1, 1)), Bounds.of(new Vec3(-1, -1, -1), new Vec3(-0.5, 1, 0))};
        assertEquals(2, tile.gather(boxes, new int[2]));
    }

    @Test
    void aLensOfNoSizeIsAPinhole() {
        Camera.Perspective pinhole = new Camera.Perspective(EYE, AIM, UP, 50);
        CompiledCamera camera = compile(pinhole.withLens(Camera.Lens.round(0, FOCUS)));
        assertFalse(camera.hasLens());
        assertTrue(camera.isPinholeOrParallel());
        assertFalse(compile(perspective(0)).withoutLens().hasLens());
        assertEquals(List.of(EYE), pinhole.anchors());
    }
}
