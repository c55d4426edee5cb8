package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.frame.Rotation;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Torus;
import enlightenment.geometry.Triangle;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/**
 * Opaque surfaces that lie in one another: a point on several of them leaves them all, which of them is seen is decided once,
 * and neither depends on roundings. The truth is the same scene with one of them alone, or lifted by a hair.
 */
class TouchingSurfacesTest {
    private static final Material RED = TestScenes.matte(0.9, 0.2, 0.1);
    private static final Material BLUE = TestScenes.matte(0.1, 0.2, 0.9);
    private static final Material GREEN = TestScenes.matte(0.2, 0.8, 0.3);
    private static final Material MIRROR = TestScenes.mirror(0.9);
    private static final SceneObject FLOOR =
            SceneObject.of(TestScenes.rectangle(-9, 0.1, -9, -9, 0.1, 9, 9, 0.1, 9, 9, 0.1, -9), GREEN);

    /** Far above the tolerance of the comparison, far below a pixel. */
    private static final double HAIR = 1e-9;

    private static Scene.Builder view() {
        return Scene.builder()
                .size(64, 64)
                .camera(new Camera.Perspective(
                        ExactPoint.of(1.31, 2.47, -4.13), ExactPoint.of(0.3, 0.6, 0), Vec3.Y, 40))
                .shading(new Shading.Classic(0.25, 0.25, new DisplayRgb(0.4, 0.6, 0.8), 20))
                .light(new Light.Sphere(ExactPoint.of(-3.1, 7.3, -4.7), 0.4, DisplayRgb.WHITE))
                .light(new Light.Point(ExactPoint.of(4.3, 5.1, -3.3), new DisplayRgb(0.8, 0.7, 0.6)));
    }

    private static DoublePicture picture(SceneObject... objects) {
        Scene.Builder b = view();
        List.of(objects).forEach(b::object);
        return DoublePicture.of(b.build(), 1, 4);
    }

    private static SceneObject object(Shape shape, Material material) {
        return SceneObject.of(shape, material);
    }

    /** By name: shapes that are the same surface in two descriptions. */
    private static Map<String, Shape[]> twins() {
        Map<String, Shape[]> t = new LinkedHashMap<>();
        ExactPoint c = ExactPoint.of(0.1, 0.9, 0.2);
        ExactPoint d = ExactPoint.of(0.4, 1.8, -0.3);
        t.put("rotated sphere", new Shape[] {Sphere.of(c, 0.7), new Sphere(c, 0.7, 77)});
        t.put("sphere an ulp larger", new Shape[] {Sphere.of(c, 0.7), Sphere.of(c, Math.nextUp(0.7))});
        t.put("sphere an ulp aside", new Shape[] {
            Sphere.of(c, 0.7), Sphere.of(ExactPoint.of(Math.nextUp(0.1), 0.9, Math.nextDown(0.2)), 0.7)
        });
        t.put("quarter-turned cube", new Shape[] {new Cube(c, 0.9, Vec3.ZERO), new Cube(c, 0.9, new Vec3(0, 90, 0))});
        t.put(
                "leaning cube, turned on",
                new Shape[] {new Cube(c, 0.9, new Vec3(20, 0, 0)), new Cube(c, 0.9, new Vec3(110, 0, 0))});
        double h = 0.9 / Math.sqrt(3);
        t.put("cube and box", new Shape[] {
            new Cube(c, 0.9, Vec3.ZERO), new Box(c.plus(new Vec3(-h, -h, -h)), c.plus(new Vec3(h, h, h)))
        });
        t.put("reversed cylinder", new Shape[] {new Cylinder(c, d, 0.5, true), new Cylinder(d, c, 0.5, true)});
        t.put("reversed open cylinder", new Shape[] {new Cylinder(c, d, 0.5, false), new Cylinder(d, c, 0.5, false)});
        t.put("reversed frustum", new Shape[] {new Cone(c, d, 0.6, 0.3, true), new Cone(d, c, 0.3, 0.6, true)});
        t.put("cone an ulp wider", new Shape[] {new Cone(c, d, 0.6, 0, true), new Cone(c, d, Math.nextUp(0.6), 0, true)
        });
        Vec3 axis = new Vec3(0.3, 1, -0.4);
        t.put("torus upside down", new Shape[] {new Torus(c, axis, 0.7, 0.25), new Torus(c, axis.negated(), 0.7, 0.25)
        });
        t.put("disk from behind", new Shape[] {new Disk(c, axis, 0.7), new Disk(c, axis.negated(), 0.7)});
        ExactPoint p = ExactPoint.of(-0.7, 0.3, 0.3);
        ExactPoint q = ExactPoint.of(-0.4, 1.7, 0.6);
        ExactPoint r = ExactPoint.of(1.1, 1.6, -0.2);
        ExactPoint s = r.plus(p.minus(q));
        t.put("rectangle, other corner first", new Shape[] {new Rectangle(p, q, r, s), new Rectangle(r, s, p, q)});
        t.put("rectangle from behind", new Shape[] {new Rectangle(p, q, r, s), new Rectangle(s, r, q, p)});
        t.put("triangle, other corner first", new Shape[] {new Triangle(p, q, r), new Triangle(q, r, p)});
        return t;
    }

    @Test
    void aTwinInAnotherDescriptionChangesNoBit() {
        for (Map.Entry<String, Shape[]> e : twins().entrySet()) {
            for (Material m : List.of(RED, MIRROR)) {
                DoublePicture one = picture(object(e.getValue()[0], m), FLOOR);
                DoublePicture other = picture(object(e.getValue()[1], m), FLOOR);
                DoublePicture both = picture(object(e.getValue()[0], m), object(e.getValue()[1], m), FLOOR);
                // Each alone differs from the other by roundings, and at their outlines by a ray that just misses one.
                double share = one.shareBeyond(other, 1e-9);
                assertTrue(share <= 0.002, e.getKey() + ": " + share);
                String what = e.getKey() + ", " + m.type();
                assertTrue(both.shareBeyond(one, 1e-9) <= 0.002, what + ": " + both.shareBeyond(one, 1e-9));
                assertEquals(0, both.speckles(one), what);
            }
        }
    }

    @Test
    void ofTwinsInTwoColoursOneIsSeenEverywhereInEveryUnit() {
        for (Map.Entry<String, Shape[]> e : twins().entrySet()) {
            List<Boolean> firstIsSeen = new ArrayList<>();
            for (int k : new int[] {-9, -1, 0, 1, 7}) {
                Scene both = scene(object(e.getValue()[0], RED), object(e.getValue()[1], BLUE));
                Scene first = scene(object(e.getValue()[0], RED));
                Scene second = scene(object(e.getValue()[1], BLUE));
                DoublePicture p = scaled(both, k);
                double ofFirst = p.shareBeyond(scaled(first, k), 1e-9);
                double ofSecond = p.shareBeyond(scaled(second, k), 1e-9);
                assertTrue(Math.min(ofFirst, ofSecond) <= 0.002, e.getKey() + ": " + ofFirst + " " + ofSecond);
                firstIsSeen.add(ofFirst < ofSecond);
            }
            assertEquals(1, firstIsSeen.stream().distinct().count(), e.getKey() + " in several units: " + firstIsSeen);
        }
    }

    private static Scene scene(SceneObject... objects) {
        Scene.Builder b = view();
        List.of(objects).forEach(b::object);
        return b.build();
    }

    private static DoublePicture scaled(Scene scene, int k) {
        return DoublePicture.of(MovedScene.scaledByPowerOfTen(scene, k), 1, 4);
    }

    @Test
    void whatLiesInALargerSurfaceIsSeenAsIfItLayAHairAboveIt() {
        for (Material above : List.of(RED, MIRROR)) {
            Box table = new Box(ExactPoint.of(-0.9, 0.1, -0.8), ExactPoint.of(1.1, 0.9, 0.9));
            assertLiesOn(
                    "carpet on a box",
                    new SceneObject[] {object(table, BLUE), FLOOR},
                    above,
                    y -> TestScenes.rectangle(
                            -0.4, 0.9 + y, -0.5, -0.4, 0.9 + y, 0.6, 0.7, 0.9 + y, 0.6, 0.7, 0.9 + y, -0.5));
            assertLiesOn(
                    "disk on the floor",
                    new SceneObject[] {FLOOR},
                    above,
                    y -> new Disk(ExactPoint.of(0.2, 0.1 + y, 0.1), Vec3.Y, 0.8));
            Rectangle wall = TestScenes.rectangle(-3, -1, 1, -3, 4, 1, 3, 4, 1, 3, -1, 1);
            assertLiesOn(
                    "poster on a wall",
                    new SceneObject[] {object(wall, BLUE), FLOOR},
                    above,
                    y -> TestScenes.rectangle(-0.4, 0.3, 1 - y, -0.4, 1.4, 1 - y, 0.9, 1.4, 1 - y, 0.9, 0.3, 1 - y));
        }
    }

    @Test
    void whatLiesInALeaningSurfaceIsSeenAsIfItLayAHairAboveIt() {
        Vec3 u = Rotation.ofDegrees(new Vec3(31, 17, 7)).axis(0);
        Vec3 v = Rotation.ofDegrees(new Vec3(31, 17, 7)).axis(1);
        Vec3 n = Rotation.ofDegrees(new Vec3(31, 17, 7)).axis(2).negated();
        ExactPoint o = ExactPoint.of(0.3, 0.6, 0.4);
        assertLiesOn(
                "poster on a leaning wall",
                new SceneObject[] {object(square(o, u, v, 2.3), BLUE)},
                RED,
                y -> square(o.plus(u.times(0.31)).plus(v.times(-0.17)).plus(n.times(y)), u, v, 0.47));
        Vec3 turn = new Vec3(31, 17, 7);
        double half = 0.8;
        Cube cube = new Cube(o, half * Math.sqrt(3), turn);
        assertLiesOn(
                "disk on a leaning cube",
                new SceneObject[] {object(cube, BLUE), FLOOR},
                RED,
                y -> new Disk(o.plus(n.times(half + y)), n, 0.5));
        Cylinder post = new Cylinder(o, o.plus(u.times(1.3)), 0.4, true);
        assertLiesOn(
                "ring around a post",
                new SceneObject[] {object(post, BLUE), FLOOR},
                RED,
                y -> new Cylinder(o.plus(u.times(0.3)), o.plus(u.times(0.7)), 0.4 + y, false));
    }

    private static Rectangle square(ExactPoint middle, Vec3 u, Vec3 v, double half) {
        return new Rectangle(
                middle.plus(u.times(-half)).plus(v.times(-half)),
                middle.plus(u.times(-half)).plus(v.times(half)),
                middle.plus(u.times(half)).plus(v.times(half)),
                middle.plus(u.times(half)).plus(v.times(-half)));
    }

    private interface Lifted {
        Shape by(double y);
    }

    private static void assertLiesOn(String what, SceneObject[] below, Material material, Lifted shape) {
        DoublePicture on = inAnyOrder(with(below, object(shape.by(0), material)));
        DoublePicture above = inAnyOrder(with(below, object(shape.by(HAIR), material)));
        assertTrue(on.shareBeyond(above, 1e-6) <= 0.002, what + ": " + on.shareBeyond(above, 1e-6));
        assertEquals(0, on.speckles(above), what);
        assertTrue(on.shareBeyond(inAnyOrder(below), 1e-3) > 0.01, what + " is not seen");
    }

    private static SceneObject[] with(SceneObject[] some, SceneObject more) {
        List<SceneObject> all = new ArrayList<>(List.of(some));
        all.add(more);
        return all.toArray(SceneObject[]::new);
    }

    private static DoublePicture inAnyOrder(SceneObject... objects) {
        DoublePicture first = picture(objects);
        List<SceneObject> list = new ArrayList<>(List.of(objects));
        Collections.reverse(list);
        assertArrayEquals(
                first.toArray(), picture(list.toArray(SceneObject[]::new)).toArray());
        return first;
    }

    @Test
    void aHouseOfTwoOverlappingBoxesHasNoDarkPlaces() {
        Box hall = new Box(ExactPoint.of(-0.9, 0.1, -0.6), ExactPoint.of(0.9, 1.1, 0.3));
        Box wing = new Box(ExactPoint.of(-0.2, 0.1, -0.6), ExactPoint.of(0.6, 1.1, 1.5));
        for (Material m : List.of(RED, MIRROR)) {
            DoublePicture house = inAnyOrder(object(hall, m), object(wing, m), FLOOR);
            Box lowered = new Box(ExactPoint.of(-0.2, 0.1, -0.6 + HAIR), ExactPoint.of(0.6, 1.1 - HAIR, 1.5));
            DoublePicture truth = inAnyOrder(object(hall, m), object(lowered, m), FLOOR);
            assertTrue(house.shareBeyond(truth, 1e-6) <= 0.002, m.type() + house.shareBeyond(truth, 1e-6));
            assertEquals(0, house.speckles(truth), m.type());
        }
    }

    @Test
    void aLadderOfGapsHasOneRungWhereThePictureChangesAndNoNoise() {
        // A poster before (+) or behind (−) a wall in another colour: behind it nothing of it is seen.
        for (int unit : new int[] {-6, 0, 9}) {
            boolean seen = false;
            List<Double> gaps = new ArrayList<>();
            for (int k = 9; k <= 17; k++) {
                gaps.add(0, -Math.pow(10, -k) * 3);
                gaps.add(0, -Math.pow(10, -k));
            }
            Collections.sort(gaps);
            gaps.add(0.0);
            for (int k = 17; k >= 9; k--) {
                gaps.add(Math.pow(10, -k));
                gaps.add(3 * Math.pow(10, -k));
            }
            DoublePicture without = scaled(poster(Double.NaN), unit);
            DoublePicture before = scaled(poster(1e-3), unit);
            for (double gap : gaps) {
                DoublePicture p = scaled(poster(gap), unit);
                boolean none = p.speckles(without) == 0 && p.shareBeyond(without, 1e-3) == 0;
                boolean all = p.speckles(before) == 0 && p.shareBeyond(before, 1e-2) <= 0.005;
                assertTrue(none != all, "either the wall or the poster at a gap of " + gap + " in 10^" + unit);
                assertTrue(all || !seen, "the poster goes again at a gap of " + gap + " in 10^" + unit);
                seen |= all;
                // Roundings of coordinates below 8 cannot be told from a gap; 1e-12 is a hundred times as wide.
                assertTrue(gap < 0 || all, "gap " + gap + " in 10^" + unit);
                assertTrue(gap > -1e-12 || none, "gap " + gap + " in 10^" + unit);
            }
        }
    }

    private static Scene poster(double gap) {
        Vec3 u = Rotation.ofDegrees(new Vec3(31, 17, 7)).axis(0);
        Vec3 v = Rotation.ofDegrees(new Vec3(31, 17, 7)).axis(1);
        Vec3 n = Rotation.ofDegrees(new Vec3(31, 17, 7)).axis(2).negated();
        ExactPoint o = ExactPoint.of(0.3, 0.6, 0.4);
        SceneObject wall = object(square(o, u, v, 2.3), BLUE);
        return Double.isNaN(gap) ? scene(wall) : scene(wall, object(square(o.plus(n.times(gap)), u, v, 0.47), RED));
    }
}
