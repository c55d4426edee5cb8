package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Shape;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Surfaces that lie in one another (numerics, N22): no speckle, and the order of objects does not matter. */
class CoincidentFacesTest {
    private static final int SIDE = 96;
    private static final Shape FLOOR = TestScenes.rectangle(-9, 0.1, -9, -9, 0.1, 9, 9, 0.1, 9, 9, 0.1, -9);
    private static final Material RED = TestScenes.matte(0.9, 0.2, 0.1);
    private static final Material BLUE = TestScenes.matte(0.1, 0.2, 0.9);

    private static Material glass(double r, double g, double b) {
        return Glass.of(Texture.of(new DisplayRgb(r, g, b)), 1.5);
    }

    private static SceneObject object(Shape shape, Material material) {
        return SceneObject.of(shape, material);
    }

    private static DoublePicture picture(List<SceneObject> objects, boolean lit, int side) {
        Scene.Builder b = Scene.builder()
                .size(side, side)
                .camera(new Camera.Perspective(
                        ExactPoint.of(1.31, 2.47, -4.13), ExactPoint.of(0.3, 0.4, 0), Vec3.Y, 40))
                .shading(new Shading.Classic(lit ? 0.25 : 1, 0.25, new DisplayRgb(0.4, 0.6, 0.8), 100));
        objects.forEach(b::object);
        if (lit) {
            b.light(new Light.Point(ExactPoint.of(-3, 7, -4), DisplayRgb.WHITE));
        }
        return DoublePicture.of(b.build(), 1, 4);
    }

    /** Renders in all rotations of the order and asserts that the bits are the same. */
    private static DoublePicture inAnyOrder(boolean lit, SceneObject... objects) {
        return inAnyOrder(SIDE, lit, objects);
    }

    private static DoublePicture inAnyOrder(int side, boolean lit, SceneObject... objects) {
        List<SceneObject> list = new ArrayList<>(List.of(objects));
        DoublePicture first = picture(list, lit, side);
        assertTrue(first.isFinite() && first.least() >= 0);
        for (int i = 1; i < objects.length; i++) {
            Collections.rotate(list, 1);
            assertArrayEquals(first.toArray(), picture(list, lit, side).toArray());
        }
        if (objects.length > 2) {
            // The rotations of two are all their orders.
            Collections.reverse(list);
            assertArrayEquals(first.toArray(), picture(list, lit, side).toArray());
        }
        return first;
    }

    @Test
    void aGlassBoxThatStandsOnTheFloorLooksAsIfItStoodAHairAboveIt() {
        for (boolean lit : new boolean[] {false, true}) {
            SceneObject floor = object(FLOOR, RED);
            DoublePicture on = inAnyOrder(
                    lit,
                    object(new Box(ExactPoint.of(-0.7, 0.1, -0.9), ExactPoint.of(0.8, 1.2, 0.7)), glass(0.9, 1, 0.9)),
                    floor);
            DoublePicture above = inAnyOrder(
                    lit,
                    object(
                            new Box(ExactPoint.of(-0.7, 0.1 + 1e-9, -0.9), ExactPoint.of(0.8, 1.2, 0.7)),
                            glass(0.9, 1, 0.9)),
                    floor);
            assertTrue(on.shareBeyond(above, 1e-6) <= 0.001, "share " + on.shareBeyond(above, 1e-6));
            assertEquals(0, on.speckles(above));
        }
    }

    @Test
    void twoBoxesThatShareAFaceLookLikeOne() {
        for (boolean lit : new boolean[] {false, true}) {
            for (Material m : new Material[] {RED, TestScenes.mirror(0.9), glass(1, 1, 1)}) {
                SceneObject floor = object(FLOOR, BLUE);
                DoublePicture two = inAnyOrder(
                        lit,
                        object(new Box(ExactPoint.of(-0.7, 0.3, -0.9), ExactPoint.of(0.1, 1.2, 0.7)), m),
                        object(new Box(ExactPoint.of(0.1, 0.3, -0.9), ExactPoint.of(0.9, 1.2, 0.7)), m),
                        floor);
                DoublePicture one = inAnyOrder(
                        lit, object(new Box(ExactPoint.of(-0.7, 0.3, -0.9), ExactPoint.of(0.9, 1.2, 0.7)), m), floor);
                if (m instanceof Glass) {
                    assertTrue(two.shareBeyond(one, 1e-9) <= 0.001, "share " + two.shareBeyond(one, 1e-9));
                } else {
                    assertEquals(0, two.difference(one), 1e-12, m.type());
                }
            }
        }
    }

    @Test
    void twoLeaningCubesOfGlassThatShareAFaceHaveNoSpeckles() {
        // The face is shared up to rounding only: cubes in the same orientation, one edge apart along their own axis.
        Vec3 turn = new Vec3(20, 30, 10);
        double edge = 0.8;
        double radius = edge / 2 * Math.sqrt(3);
        Vec3 axis = enlightenment.frame.Rotation.ofDegrees(turn).axis(0);
        ExactPoint middle = ExactPoint.of(0, 1, 0);
        Material glass = glass(1, 1, 1);
        SceneObject floor = object(FLOOR, BLUE);
        DoublePicture touching = inAnyOrder(
                false,
                object(new Cube(middle, radius, turn), glass),
                object(new Cube(middle.plus(axis.times(edge)), radius, turn), glass),
                floor);
        DoublePicture overlapping = inAnyOrder(
                false,
                object(new Cube(middle, radius, turn), glass),
                object(new Cube(middle.plus(axis.times(edge * (1 - 1e-9))), radius, turn), glass),
                floor);
        double share = touching.shareBeyond(overlapping, 1e-6);
        assertTrue(share <= 0.001, "share " + share);
        assertEquals(0, touching.speckles(overlapping));
    }

    /** Bits are compared, so that every pixel counts by itself: a quarter of them is enough to see a face that wins. */
    @Test
    void identicalShapesShowOneOfTheirMaterialsEverywhere() {
        identicalShapes(SIDE / 2);
    }

    @Test
    @Tag("full")
    void identicalShapesShowOneOfTheirMaterialsInLargerPicturesToo() {
        identicalShapes(SIDE);
    }

    private static void identicalShapes(int side) {
        Material[] materials = {RED, BLUE, TestScenes.mirror(0.9), glass(0.9, 1, 0.9), glass(1, 0.8, 0.9)};
        for (Shape shape : Solids.all().values()) {
            for (boolean lit : new boolean[] {false, true}) {
                List<DoublePicture> alone = Arrays.stream(materials)
                        .map(m -> picture(List.of(object(shape, m)), lit, side))
                        .toList();
                for (int i = 0; i < materials.length; i++) {
                    for (int j = 0; j < i; j++) {
                        DoublePicture both =
                                inAnyOrder(side, lit, object(shape, materials[i]), object(shape, materials[j]));
                        double difference = Math.min(both.difference(alone.get(i)), both.difference(alone.get(j)));
                        assertEquals(0, difference, shape.type() + " " + i + " " + j);
                    }
                }
            }
        }
    }

    @Test
    void whatIsOpaqueHidesGlassOfTheSameShape() {
        whatIsOpaque(SIDE / 2);
    }

    @Test
    @Tag("full")
    void whatIsOpaqueHidesGlassOfTheSameShapeInLargerPicturesToo() {
        whatIsOpaque(SIDE);
    }

    private static void whatIsOpaque(int side) {
        for (Shape shape : Solids.all().values()) {
            DoublePicture opaque = inAnyOrder(side, true, object(shape, RED));
            DoublePicture both = inAnyOrder(side, true, object(shape, glass(0.5, 0.5, 0.5)), object(shape, RED));
            assertEquals(0, both.difference(opaque), shape.type());
        }
    }

    @Test
    void aTubeOfGlassAroundACylinderOfTheSameRadiusFiltersOnce() {
        // An open cylinder is a thin pane; it lies in the lateral surface of the solid one.
        ExactPoint base = ExactPoint.of(-0.3, 0.3, 0.1);
        ExactPoint top = ExactPoint.of(0.4, 1.7, -0.2);
        DoublePicture tube = inAnyOrder(
                false,
                object(new Cylinder(base, top, 0.6, false), glass(0.5, 1, 1)),
                object(new Cylinder(base, top, 0.6, true), glass(1, 1, 0.5)),
                object(FLOOR, BLUE));
        DoublePicture around = inAnyOrder(
                false,
                object(new Cylinder(base, top, 0.6 * (1 + 1e-9), false), glass(0.5, 1, 1)),
                object(new Cylinder(base, top, 0.6, true), glass(1, 1, 0.5)),
                object(FLOOR, BLUE));
        assertTrue(tube.shareBeyond(around, 1e-6) <= 0.001, "share " + tube.shareBeyond(around, 1e-6));
        assertEquals(0, tube.speckles(around));
    }
}
