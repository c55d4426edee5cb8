package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.classic.shading.ClassicShader;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Eyes inside things and on their surfaces (numerics, N24). */
class CameraInsideTest {
    private static final double AMBIENT = 0.25;
    private static final double ROOM = 10;
    private static final Vec3 LAMP = new Vec3(3, 5, -2);

    private static Material glass(double ior) {
        return Glass.of(Texture.of(DisplayRgb.WHITE), ior);
    }

    /** A ball-shaped room around the origin, lit from a point without shadows: what is seen depends on the direction. */
    private static Scene.Builder room(ExactPoint eye, Vec3 along, double fieldOfView) {
        return Scene.builder()
                .size(24, 24)
                .camera(new Camera.Perspective(eye, eye.plus(along), new Vec3(0.1, 1, 0.2), fieldOfView))
                .shading(new Shading.Classic(AMBIENT, 1, DisplayRgb.BLACK, 1000))
                .object(Sphere.of(ExactPoint.ORIGIN, ROOM), TestScenes.matte(1, 1, 1))
                .light(new Light.Point(ExactPoint.of(LAMP.x(), LAMP.y(), LAMP.z()), DisplayRgb.WHITE));
    }

    /** The room's colour where the ray from a point inside meets its wall. */
    private static double wall(Vec3 from, Vec3 direction) {
        Vec3 d = direction.normalized();
        double b = from.dot(d);
        Vec3 p = from.plus(d.times(-b + Math.sqrt(b * b - from.lengthSquared() + ROOM * ROOM)));
        double cosine = p.times(-1 / ROOM).dot(LAMP.minus(p).normalized());
        return AMBIENT + (1 - AMBIENT) * Math.max(cosine, 0);
    }

    @Test
    void fromTheCentreOfAGlassBallEverythingLooksAsWithoutIt() {
        ExactPoint eye = ExactPoint.of(0.3, -0.4, 0.7);
        for (double ior : new double[] {1.5, 2.4, 0.5}) {
            for (Vec3 along : new Vec3[] {Vec3.Z, new Vec3(1, -0.3, 0.2), new Vec3(-0.5, 0.4, -2)}) {
                DoublePicture without = DoublePicture.of(room(eye, along, 100).build(), 2, 1);
                Scene scene = room(eye, along, 100)
                        .object(Sphere.of(eye, 1.25), glass(ior))
                        .build();
                assertEquals(0, DoublePicture.of(scene, 2, 1).difference(without), 1e-9);
                assertTrue(without.greatest() - without.least() > 0.05);
            }
        }
    }

    @Test
    void fromElsewhereInAGlassBallTheViewIsBentBySnellsLaw() {
        Vec3 eye = new Vec3(0.3, -0.4, 0.7);
        Vec3 middle = new Vec3(0.5, 0.1, 0.4);
        double radius = 1.25;
        double ior = 1.5;
        Scene scene = room(ExactPoint.of(eye.x(), eye.y(), eye.z()), new Vec3(0.4, 0.3, 1), 120)
                .object(Sphere.of(ExactPoint.of(middle.x(), middle.y(), middle.z()), radius), glass(ior))
                .build();
        CompiledScene compiled = SceneCompiler.compile(scene, RenderSettings.of(scene));
        ClassicShader shader = new ClassicShader(compiled, 1, new RayCounters(compiled.kindNames.size()));
        shader.beginTile(0, 0, 1, 1);
        SobolSampler address = new SobolSampler();
        double[] color = new double[3];
        double bent = 0;
        for (int i = 0; i <= 40; i++) {
            for (int j = 0; j <= 40; j++) {
                Ray ray = new Ray();
                compiled.camera.ray(i / 40.0, j / 40.0, ray);
                Vec3 d = new Vec3(ray.dx, ray.dy, ray.dz).normalized();
                address.pixel(1, i, j);
                shader.shade(ray, address, color);
                double expected = leavingBall(eye, d, middle, radius, ior);
                assertEquals(expected, color[0], 1e-9);
                bent = Math.max(bent, Math.abs(expected - wall(eye, d)));
            }
        }
        assertTrue(bent > 0.005, "the ball matters: " + bent);
    }

    /** By angles: the ray turns away from the radius by the difference of the two angles of Snell's law. */
    private static double leavingBall(Vec3 eye, Vec3 d, Vec3 middle, double radius, double ior) {
        Vec3 f = eye.minus(middle);
        double b = f.dot(d);
        Vec3 exit = eye.plus(d.times(-b + Math.sqrt(b * b - f.lengthSquared() + radius * radius)));
        Vec3 normal = exit.minus(middle).normalized();
        Vec3 across = d.minus(normal.times(d.dot(normal)));
        double in = Math.atan2(across.length(), d.dot(normal));
        double out = Math.asin(ior * Math.sin(in));
        Vec3 bent = normal.times(Math.cos(out)).plus(across.normalized().times(Math.sin(out)));
        return wall(exit, bent);
    }

    @Test
    void fromInsideAGlassBlockTheSlabShiftsNothingButTheAngle() {
        // The block's face z = 1 bends by Snell's law alone.
        Vec3 eye = new Vec3(0.1, 0.2, 0.3);
        Scene scene = room(ExactPoint.of(eye.x(), eye.y(), eye.z()), Vec3.Z, 30)
                .object(new Box(ExactPoint.of(-3, -3, -1), ExactPoint.of(3, 3, 1)), glass(1.5))
                .build();
        CompiledScene compiled = SceneCompiler.compile(scene, RenderSettings.of(scene));
        ClassicShader shader = new ClassicShader(compiled, 1, new RayCounters(compiled.kindNames.size()));
        shader.beginTile(0, 0, 1, 1);
        SobolSampler address = new SobolSampler();
        double[] color = new double[3];
        for (int i = 0; i <= 20; i++) {
            for (int j = 0; j <= 20; j++) {
                Ray ray = new Ray();
                compiled.camera.ray(i / 20.0, j / 20.0, ray);
                Vec3 d = new Vec3(ray.dx, ray.dy, ray.dz).normalized();
                address.pixel(1, i, j);
                shader.shade(ray, address, color);
                Vec3 exit = eye.plus(d.times((1 - eye.z()) / d.z()));
                double sx = 1.5 * d.x();
                double sy = 1.5 * d.y();
                assertEquals(wall(exit, new Vec3(sx, sy, Math.sqrt(1 - sx * sx - sy * sy))), color[0], 1e-9);
            }
        }
    }

    @Test
    void insideAnOpaqueBoxItsWallsAreSeenAndNothingElse() {
        ExactPoint eye = ExactPoint.of(0.3, -0.4, 0.7);
        for (Shape box : new Shape[] {
            new Box(ExactPoint.of(-1, -1, -1), ExactPoint.of(1, 1, 1)),
            Sphere.of(eye, 0.001),
            Solids.solid().get("frustum")
        }) {
            ExactPoint inside = box instanceof Box || box instanceof Sphere ? eye : ExactPoint.of(0.05, 0.2, 0.05);
            for (Vec3 along : new Vec3[] {Vec3.Z, Vec3.X, new Vec3(-1, -2, -3)}) {
                Scene scene = room(inside, along, 110)
                        .shading(new Shading.Classic(AMBIENT, 0, DisplayRgb.WHITE, 10))
                        .object(box, TestScenes.matte(0.5, 0.5, 0.5))
                        .build();
                DoublePicture p = DoublePicture.of(scene, 1, 1);
                assertEquals(AMBIENT * 0.5, p.least(), 1e-15, box.type());
                assertEquals(AMBIENT * 0.5, p.greatest(), 1e-15, box.type());
            }
        }
    }

    /** A third of all cases: every two of place, material and direction meet with every shape. */
    @Test
    void anEyeExactlyOnASurfaceSeesAFinitePicture() {
        assertEquals(3 * 6 * 6 * 2, finitePicturesFromSurfaces(3));
    }

    @Test
    @Tag("full")
    void anEyeExactlyOnASurfaceSeesAFinitePictureInEveryDirection() {
        assertEquals(3 * 6 * 6 * 6, finitePicturesFromSurfaces(1));
    }

    /** Checks one of so many cases and returns how many these were. */
    private static int finitePicturesFromSurfaces(int oneOf) {
        int pictures = 0;
        Shape ball = Sphere.of(ExactPoint.ORIGIN, 1);
        Shape box = new Box(ExactPoint.of(-1, -1, -1), ExactPoint.of(1, 1, 1));
        Shape tube = new Cylinder(ExactPoint.of(0, -1, 0), ExactPoint.of(0, 1, 0), 1, true);
        ExactPoint[] eyes = {
            ExactPoint.of(0, 0, -1),
            ExactPoint.of(1, 0, 0),
            ExactPoint.of(0.6, 0.8, 0),
            ExactPoint.of(0, 1, 0),
            ExactPoint.of(1, 1, 0),
            ExactPoint.of(1, 1, -1)
        };
        Material[] materials = {
            TestScenes.matte(0.8, 0.7, 0.6),
            TestScenes.mirror(0.9),
            glass(1.5),
            glass(1),
            glass(0.7),
            new Glass(Texture.of(DisplayRgb.WHITE), 1.5, 0.5, 0, true)
        };
        Vec3[] along = {Vec3.Z, Vec3.Z.negated(), Vec3.X, Vec3.Y, new Vec3(1, 1, -1), new Vec3(-1, -1, 1)};
        for (Shape shape : new Shape[] {ball, box, tube}) {
            for (int i = 0; i < eyes.length; i++) {
                for (int j = 0; j < materials.length; j++) {
                    for (int k = (2 * oneOf - i % oneOf - j % oneOf) % oneOf; k < along.length; k += oneOf) {
                        ExactPoint eye = eyes[i];
                        Material material = materials[j];
                        Scene scene = room(eye, along[k], 90)
                                .size(9, 9)
                                .object(shape, material)
                                .build();
                        DoublePicture p = DoublePicture.of(scene, 1, 1);
                        String what = shape.type() + " of " + material.type() + " from " + eye;
                        assertTrue(p.isFinite() && p.least() >= 0 && p.greatest() <= 1 + 1e-12, what);
                        pictures++;
                    }
                }
            }
        }
        return pictures;
    }

    @Test
    void anEyeOnTheSurfaceOfGlassOfIndexOneSeesWhatItWouldSeeWithoutIt() {
        for (Vec3 direction : new Vec3[] {Vec3.Z, Vec3.Z.negated(), Vec3.X, new Vec3(1, 2, -0.1)}) {
            ExactPoint eye = ExactPoint.of(0, 0, -1);
            DoublePicture without = DoublePicture.of(room(eye, direction, 90).build(), 1, 1);
            for (Shape shape : new Shape[] {
                Sphere.of(ExactPoint.ORIGIN, 1),
                new Box(ExactPoint.of(-1, -1, -1), ExactPoint.of(1, 1, 1)),
                new Cylinder(ExactPoint.of(0, -1, 0), ExactPoint.of(0, 1, 0), 1, true)
            }) {
                Scene scene = room(eye, direction, 90).object(shape, glass(1)).build();
                assertEquals(0, DoublePicture.of(scene, 1, 1).difference(without), 1e-12, shape.type());
            }
        }
    }
}
