package enlightenment.world.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.accel.Accelerator;
import enlightenment.accel.BvhQuery;
import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Sphere;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class OccluderSetTest {
    private static final Material WHITE = Material.Matte.of(Texture.of(DisplayRgb.WHITE));

    private static Scene.Builder room() {
        return Scene.builder()
                .camera(new Camera.Perspective(ExactPoint.of(0, 0, -9), ExactPoint.of(0, 0, 0), Vec3.Y, 60));
    }

    private static CompiledScene compile(Scene.Builder b) {
        Scene scene = b.build();
        return SceneCompiler.compile(scene, RenderSettings.of(scene), false);
    }

    private static int candidates(CompiledScene scene, LightCone cone, BvhQuery out) {
        return scene.accelerator.narrow(cone, scene.occluders.new Judge().of(cone, new int[0], 0), 2, out);
    }

    /** Distance at which a ray from p along d meets the light's ball, or NaN. */
    private static double toLight(ClassicLight light, double[] p, double[] d) {
        double[] f = {p[0] - light.x, p[1] - light.y, p[2] - light.z};
        double b = f[0] * d[0] + f[1] * d[1] + f[2] * d[2];
        double c = f[0] * f[0] + f[1] * f[1] + f[2] * f[2] - light.radius * light.radius;
        return -b - Math.sqrt(b * b - c);
    }

    @Test
    void aThingThatIsLeftOutBlocksNoShadowRayAndAHiddenLightIsBlockedOnAllOfThem() {
        Random random = new Random(42);
        int clear = 0;
        int hidden = 0;
        int rays = 0;
        for (int round = 0; round < 400; round++) {
            Scene.Builder b = room();
            for (int i = 0; i < 5; i++) {
                b.object(Sphere.of(point(random, 3), 0.2 + 1.5 * random.nextDouble()), WHITE);
            }
            b.object(rectangle(random), WHITE).object(rectangle(random), WHITE);
            b.light(new Light.Sphere(point(random, 4), Math.pow(10, -3 * random.nextDouble()), DisplayRgb.WHITE));
            CompiledScene scene = compile(b);
            ClassicLight light = scene.lights[0];
            LightCone cone = new LightCone();
            BvhQuery out = new BvhQuery(scene.kind, new long[scene.kindNames.size()]);
            for (int k = 0; k < 20; k++) {
                double[] p = array(scene, point(random, 3));
                cone.aim(light, p[0], p[1], p[2]);
                int n = candidates(scene, cone, out);
                boolean all = n == Accelerator.BLOCKED;
                hidden += all ? 1 : 0;
                int[] candidates = IntStream.range(0, all ? 0 : n).map(out::get).toArray();
                for (int j = 0; j < 12; j++) {
                    double[] d = direction(random, light, p);
                    double t = toLight(light, p, d);
                    if (!(t > 0)) {
                        continue;
                    }
                    rays++;
                    Ray ray = Ray.of(new Vec3(p[0], p[1], p[2]), new Vec3(d[0], d[1], d[2]));
                    boolean blocked = false;
                    for (int id = 0; id < scene.primitives.length; id++) {
                        boolean hit = scene.primitives[id].nearest(ray, t) <= t;
                        blocked |= hit;
                        int wanted = id;
                        if (!all && Arrays.stream(candidates).noneMatch(c -> c == wanted)) {
                            clear++;
                            assertFalse(hit, "round " + round + ", primitive " + id);
                        }
                    }
                    assertTrue(!all || blocked, "round " + round);
                }
            }
        }
        assertTrue(rays > 50_000 && clear > 100_000 && hidden > 200, rays + " " + clear + " " + hidden);
    }

    private static double[] array(CompiledScene scene, ExactPoint p) {
        Vec3 v = scene.frame.toFrame(p);
        return new double[] {v.x(), v.y(), v.z()};
    }

    /** A unit direction from p into the light's ball, often close to its rim. */
    private static double[] direction(Random random, ClassicLight light, double[] p) {
        Vec3 n = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized();
        double r = light.radius * (random.nextBoolean() ? 0.999999 : random.nextDouble());
        Vec3 q = new Vec3(light.x, light.y, light.z).plus(n.times(r)).minus(new Vec3(p[0], p[1], p[2]));
        Vec3 d = q.normalized();
        return new double[] {d.x(), d.y(), d.z()};
    }

    private static ExactPoint point(Random random, double range) {
        return ExactPoint.of(
                range * (2 * random.nextDouble() - 1),
                range * (2 * random.nextDouble() - 1),
                range * (2 * random.nextDouble() - 1));
    }

    private static Rectangle rectangle(Random random) {
        ExactPoint a = point(random, 3);
        Vec3 u = new Vec3(random.nextInt(3), random.nextInt(3) - 1, 1).times(0.5);
        Vec3 v = new Vec3(-0.5, random.nextInt(3), random.nextInt(3) - 3).times(0.5);
        return new Rectangle(a, a.plus(u), a.plus(u.plus(v)), a.plus(v));
    }

    @Test
    void aFlatThingIsNoCandidateIfPointAndLightLieOnOneSideOfItWhateverElseThereIs() {
        Rectangle floor = new Rectangle(
                ExactPoint.of(-5, -5, -10),
                ExactPoint.of(-5, -5, 5),
                ExactPoint.of(5, -5, 5),
                ExactPoint.of(5, -5, -10));
        Rectangle table = new Rectangle(
                ExactPoint.of(-1, -3, -1), ExactPoint.of(-1, -3, 1), ExactPoint.of(1, -3, 1), ExactPoint.of(1, -3, -1));
        CompiledScene scene = compile(room().object(floor, WHITE)
                .object(table, WHITE)
                .object(Sphere.of(ExactPoint.of(0, -20, 0), 1), WHITE)
                .light(new Light.Sphere(ExactPoint.of(0, 3, 0), 0.5, DisplayRgb.WHITE)));
        BvhQuery out = new BvhQuery(scene.kind, new long[scene.kindNames.size()]);
        LightCone cone = new LightCone();
        double[] onFloor = array(scene, ExactPoint.of(0.25, -5, 0.25));
        cone.aim(scene.lights[0], onFloor[0], onFloor[1], onFloor[2]);
        assertEquals(1, candidates(scene, cone, out), "the table, not the floor nor what is below");
        double[] onTable = array(scene, ExactPoint.of(0.25, -3, 0.25));
        cone.aim(scene.lights[0], onTable[0], onTable[1], onTable[2]);
        assertEquals(0, candidates(scene, cone, out));
    }
}
