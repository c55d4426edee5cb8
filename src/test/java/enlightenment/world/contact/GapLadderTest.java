package enlightenment.world.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Sphere;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.primitive.RectanglePrimitive;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.Tracer;
import enlightenment.world.light.LightCone;
import enlightenment.world.parts.RayCounters;
import java.math.BigDecimal;
import java.math.MathContext;
import org.junit.jupiter.api.Test;

/** Shadow rays through gaps of any width, and through none (numerics, N20, N21). */
class GapLadderTest {
    private static final MathContext DIGITS = new MathContext(80);
    private static final Material WHITE = Material.Matte.of(Texture.of(DisplayRgb.WHITE));

    /** A sphere of radius r above the floor y = 0, with a gap, in exact decimals; seen from an eye that is on no grid. */
    private record Setting(CompiledScene scene, BigDecimal radius, BigDecimal gap, ExactPoint eye) {
        static Setting of(BigDecimal r, BigDecimal gap, ExactPoint eye) {
            BigDecimal far = r.multiply(BigDecimal.TEN);
            BigDecimal near = far.negate();
            Scene scene = Scene.builder()
                    .size(4, 4)
                    .camera(new Camera.Perspective(
                            eye, new ExactPoint(eye.x(), eye.y(), eye.z().add(r)), Vec3.Y, 40))
                    .object(
                            new Sphere(
                                    new ExactPoint(BigDecimal.ZERO, r.add(gap), BigDecimal.ZERO), r.doubleValue(), 0),
                            WHITE)
                    .object(
                            new Rectangle(
                                    new ExactPoint(near, BigDecimal.ZERO, near),
                                    new ExactPoint(near, BigDecimal.ZERO, far),
                                    new ExactPoint(far, BigDecimal.ZERO, far),
                                    new ExactPoint(far, BigDecimal.ZERO, near)),
                            WHITE)
                    .light(new Light.Point(new ExactPoint(BigDecimal.ZERO, far, BigDecimal.ZERO), DisplayRgb.WHITE))
                    .build();
            return new Setting(SceneCompiler.compile(scene, RenderSettings.of(scene)), r, gap, eye);
        }

        int id(Class<?> kind) {
            for (int i = 0; i < scene.primitives.length; i++) {
                if (kind.isInstance(scene.primitives[i])) {
                    return i;
                }
            }
            throw new AssertionError();
        }

        /** A ray from the floor at (x, 0, z), at right angles to it or towards (dx, 1, dz). */
        Ray fromFloor(BigDecimal x, BigDecimal z, double dx, double dz) {
            Primitive floor = scene.primitives[id(RectanglePrimitive.class)];
            Vec3 o = scene.frame.toFrame(new ExactPoint(x, BigDecimal.ZERO, z));
            return Ray.leaving(o, new Vec3(dx, 1, dz), floor, Ray.OUTSIDE);
        }

        /** The exact distance along the ray to the sphere of the description, in the scene's units. */
        BigDecimal exact(BigDecimal x, BigDecimal z, double dx, double dz) {
            BigDecimal bx = new BigDecimal(dx);
            BigDecimal bz = new BigDecimal(dz);
            BigDecimal height = radius.add(gap);
            BigDecimal dd = bx.multiply(bx).add(bz.multiply(bz)).add(BigDecimal.ONE);
            BigDecimal b = height.subtract(x.multiply(bx)).subtract(z.multiply(bz));
            BigDecimal c = x.multiply(x)
                    .add(z.multiply(z))
                    .add(height.multiply(height))
                    .subtract(radius.multiply(radius));
            BigDecimal root = b.multiply(b).subtract(dd.multiply(c)).sqrt(DIGITS);
            return c.divide(b.add(root), DIGITS);
        }
    }

    private static boolean isBlocked(Setting s, Ray ray) {
        Tracer tracer = new Tracer(s.scene, new RayCounters(s.scene.kindNames.size()));
        LightCone cone = new LightCone();
        cone.aim(s.scene.lights[0], ray.ox, ray.oy, ray.oz);
        Tracer.Visibility seen = tracer.prepareShadows(cone, new int[] {s.id(RectanglePrimitive.class)}, 1, 1);
        return seen == Tracer.Visibility.NONE
                || seen == Tracer.Visibility.UNKNOWN && tracer.occluded(ray, 10, s.scene.lights[0]);
    }

    @Test
    void aGapOfAnyWidthIsCrossedExactlyOnce() {
        double worst = 0;
        for (String scale : new String[] {"1e-6", "1", "1e6"}) {
            BigDecimal r = new BigDecimal(scale).multiply(new BigDecimal("0.7"));
            for (int k = 1; k <= 13; k++) {
                BigDecimal gap = r.scaleByPowerOfTen(-k);
                ExactPoint eye = new ExactPoint(
                        r.multiply(new BigDecimal("0.317")),
                        r.multiply(new BigDecimal("1.093")),
                        r.multiply(new BigDecimal("-4.71")));
                Setting s = Setting.of(r, gap, eye);
                // Beside the contact the gap grows by x²/2r: as far away as the gap doubles, and nearer.
                BigDecimal x = gap.multiply(r).sqrt(DIGITS).multiply(new BigDecimal("0.9"));
                worst = Math.max(worst, error(s, BigDecimal.ZERO, 0, 0));
                worst = Math.max(worst, error(s, x, 0, 0));
                worst = Math.max(worst, error(s, x, 0.25, -0.5));
            }
        }
        assertTrue(worst > 0 && worst <= 1e-3, "relative error " + worst);
    }

    /** The relative error of t where the ray from (x, 0, x) meets the sphere; also asserts that it blocks. */
    private static double error(Setting s, BigDecimal x, double dx, double dz) {
        Ray ray = s.fromFloor(x, x.negate(), dx, dz);
        Tracer tracer = new Tracer(s.scene, new RayCounters(s.scene.kindNames.size()));
        Hit hit = new Hit();
        assertTrue(tracer.trace(ray, hit));
        assertEquals(s.id(SpherePrimitive.class), tracer.id);
        assertEquals(Ray.OUTSIDE, hit.side);
        assertTrue(isBlocked(s, ray), "gap " + s.gap);
        BigDecimal exact = s.exact(x, x.negate(), dx, dz);
        BigDecimal t = new BigDecimal(Scale.scalb(hit.t, s.scene.frame.exponent()));
        return t.subtract(exact).abs().divide(exact, DIGITS).doubleValue();
    }

    @Test
    void aSphereOnTheFloorBlocksEveryRayFromBelow() {
        BigDecimal r = BigDecimal.ONE;
        Setting s = Setting.of(r, BigDecimal.ZERO, ExactPoint.of(0.25, 1.5, -4));
        for (int k = 0; k <= 15; k++) {
            for (int quarter = 0; quarter < 4; quarter++) {
                BigDecimal x = BigDecimal.ONE.scaleByPowerOfTen(-k);
                BigDecimal along = quarter % 2 == 0 ? x : x.negate();
                Ray ray = quarter < 2
                        ? s.fromFloor(along, BigDecimal.ZERO, 0, 0)
                        : s.fromFloor(BigDecimal.ZERO, along, 0, 0);
                assertTrue(isBlocked(s, ray), "x = 1e-" + k);
            }
        }
        assertTrue(isBlocked(s, s.fromFloor(BigDecimal.ZERO, BigDecimal.ZERO, 0, 0)));
    }

    @Test
    void theShadowRayOfAPointThatTheCameraSeesIsBlockedWhereverTheEyeIs() {
        // The eye on no grid: the points under the sphere are hits, with their own rounding.
        Setting s = Setting.of(new BigDecimal("0.3"), BigDecimal.ZERO, ExactPoint.of("0.1234567", "0.0456789", "-1.7"));
        Vec3 contact = s.scene.frame.toFrame(ExactPoint.ORIGIN);
        Primitive floor = s.scene.primitives[s.id(RectanglePrimitive.class)];
        Hit hit = new Hit();
        for (int k = 1; k <= 15; k++) {
            for (int turn = 0; turn < 64; turn++) {
                double across = Scale.scalb(0.3, -s.scene.frame.exponent()) * Math.pow(10, -k);
                Vec3 target = contact.plus(new Vec3(across * Math.cos(turn), 0, across * Math.sin(turn)));
                assertTrue(floor.intersect(Ray.of(Vec3.ZERO, target), hit));
                assertSame(floor, hit.primitive);
                assertTrue(isBlocked(s, Ray.leaving(hit.point(), Vec3.Y, floor, hit.side)), "x = 1e-" + k);
            }
        }
    }
}
