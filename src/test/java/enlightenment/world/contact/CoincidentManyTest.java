package enlightenment.world.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.frame.Bounds;
import enlightenment.geometry.Box;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Torus;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.light.SceneImages;
import enlightenment.world.parts.CancellationCheck;
import enlightenment.world.parts.IntList;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

/** Many surfaces in one place: the same is found as by looking at each one, with less work. */
class CoincidentManyTest {
    private static final Material WHITE = Material.Matte.of(Texture.of(DisplayRgb.WHITE));
    private static final Material BLACK = Material.Matte.of(Texture.of(DisplayRgb.BLACK));

    /** Who cancels is asked once per so many things looked at. */
    private static final int POLLED = CancellationCheck.INTERVAL;

    private static Scene.Builder scene() {
        return Scene.builder()
                .size(4, 4)
                .camera(new Camera.Perspective(ExactPoint.of(0.3, 5, -40), ExactPoint.ORIGIN, Vec3.Y, 40));
    }

    private static CompiledScene compiled(Scene.Builder builder) {
        Scene scene = builder.build();
        return SceneCompiler.compile(scene, RenderSettings.of(scene));
    }

    /** Boxes that stand on a floor and rectangles that lie on it, over each other as it comes. */
    private static CompiledScene city(int things) {
        Scene.Builder b = scene().object(
                        new Rectangle(
                                ExactPoint.of(-10, 0.1, -10),
                                ExactPoint.of(-10, 0.1, 10),
                                ExactPoint.of(10, 0.1, 10),
                                ExactPoint.of(10, 0.1, -10)),
                        WHITE);
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < things; i++) {
            double x = 20 * random.nextDouble() - 10;
            double z = 20 * random.nextDouble() - 10;
            double size = 4 * random.nextDouble();
            if (i % 2 == 0) {
                b.object(new Box(ExactPoint.of(x, 0.1, z), ExactPoint.of(x + size, 0.1 + size, z + size)), WHITE);
            } else {
                b.object(new Disk(ExactPoint.of(x, 0.1, z), Vec3.Y, size), BLACK);
            }
        }
        return compiled(b);
    }

    @Test
    void whatCountsAtAPointIsWhatLookingAtEachPairTellsInTheSameOrder() {
        CompiledScene scene = city(300);
        SplittableRandom random = new SplittableRandom(4);
        IntList near = new IntList();
        int found = 0;
        for (int id = 0; id < scene.primitives.length; id++) {
            CoincidentFaces of = scene.coincident.of(id);
            for (int k = 0; of != null && k < 40; k++) {
                Bounds box = scene.primitives[id].bounds();
                Vec3 e = box.extent();
                // A point in the plane of the floor, and within it or just beside.
                double x = box.min().x() + e.x() * (1.1 * random.nextDouble() - 0.05);
                double y = box.min().y();
                double z = box.min().z() + e.z() * (1.1 * random.nextDouble() - 0.05);
                int face = of.face(random.nextInt(of.size()));
                scene.coincident.near(id, face, x, y, z, near);
                List<Integer> all = new ArrayList<>();
                for (int i = 0; i < near.size(); i++) {
                    all.add(near.get(i));
                }
                assertEquals(each(scene, id, face, x, y, z), all);
                found += all.size();
            }
        }
        assertTrue(found > 1000, found + " found");
    }

    /** Widened by twice the reach of the search, which itself is four tolerances. */
    private static List<Integer> each(CompiledScene scene, int id, int face, double x, double y, double z) {
        CoincidentFaces of = scene.coincident.of(id);
        List<Integer> all = new ArrayList<>();
        for (int k = 0; k < of.size(); k++) {
            Bounds own = scene.primitives[id].bounds();
            Bounds other = scene.primitives[of.other(k)].bounds();
            Bounds place = CoincidentSurfaces.widened(other, 8 * CoincidentSurfaces.tolerance(own, other));
            if (of.face(k) == face && place.contains(x, y, z)) {
                all.add(k);
            }
        }
        return all;
    }

    @Test
    void eachOfTwoFacesThatCoincideKnowsOfTheOther() {
        CompiledScene scene = city(100);
        int pairs = 0;
        for (int id = 0; id < scene.primitives.length; id++) {
            CoincidentFaces of = scene.coincident.of(id);
            for (int k = 0; of != null && k < of.size(); k++) {
                pairs++;
                assertTrue(scene.coincident.of(of.other(k)).has(of.otherFace(k), id, of.face(k)));
                assertTrue(scene.coincident.coincide(id, of.face(k), of.other(k), of.otherFace(k)));
                assertTrue(!scene.coincident.coincide(id, of.face(k), of.other(k), of.otherFace(k) + 1));
            }
        }
        assertTrue(pairs > 200, pairs + " pairs");
    }

    /** Spheres and tori on a grid whose coordinates differ by some units in the last place; some are in the same place, of other sizes. */
    private static Scene.Builder grid(int n, SplittableRandom random) {
        Scene.Builder b = scene();
        for (int i = 0; i < n; i++) {
            ExactPoint center = ExactPoint.of(
                    coordinate(random.nextInt(3), random),
                    coordinate(random.nextInt(3), random),
                    coordinate(random.nextInt(3), random));
            double size = coordinate(1 + random.nextInt(2), random);
            if (i % 3 == 0) {
                b.object(new Torus(center, random.nextBoolean() ? Vec3.X : Vec3.Y, size, 0.5), WHITE);
            } else {
                b.object(new Sphere(center, size, i), i % 2 == 0 ? WHITE : BLACK);
            }
        }
        return b;
    }

    /** The tolerance is 64 unit roundoffs of some 5: up to twice as much. */
    private static double coordinate(int at, SplittableRandom random) {
        return at + 1.1 + random.nextInt(20) * 0x1p-49;
    }

    @Test
    void wholeSurfacesThatCoincideAreFoundAsByASweepAlongX() {
        CompiledScene scene = compiled(grid(300, new SplittableRandom(8)));
        Primitive[] p = scene.primitives;
        Integer[] order = new Integer[p.length];
        Arrays.setAll(order, i -> i);
        Arrays.sort(
                order, Comparator.comparingDouble(i -> p[i].bounds().center().x()));
        List<List<Integer>> others = new ArrayList<>();
        for (int id = 0; id < p.length; id++) {
            others.add(new ArrayList<>());
        }
        int pairs = 0;
        for (int i = 0; i < order.length; i++) {
            for (int k = i + 1; k < order.length; k++) {
                int a = order[i];
                int b = order[k];
                double tolerance = CoincidentSurfaces.tolerance(p[a].bounds(), p[b].bounds());
                if (p[a].support(0).coincides(p[b].support(0), tolerance)) {
                    others.get(a).add(b);
                    others.get(b).add(a);
                    pairs++;
                }
            }
        }
        assertTrue(pairs > 100, pairs + " pairs");
        for (int id = 0; id < p.length; id++) {
            CoincidentFaces of = scene.coincident.of(id);
            List<Integer> found = new ArrayList<>();
            for (int k = 0; of != null && k < of.size(); k++) {
                found.add(of.other(k));
            }
            assertEquals(others.get(id), found);
        }
    }

    /** How often who cancels is asked while a scene is compiled. */
    private static int polls(Scene scene) {
        AtomicInteger polls = new AtomicInteger();
        SceneCompiler.compile(scene, RenderSettings.of(scene), new SceneImages(), () -> polls.incrementAndGet() < 0);
        return polls.get();
    }

    private static Scene rings(int n) {
        Scene.Builder b = scene();
        for (int i = 0; i < n; i++) {
            b.object(new Disk(ExactPoint.ORIGIN, Vec3.Z, 3.0 * (i + 1) / n), WHITE);
        }
        return b.build();
    }

    @Test
    void whoeverCancelsIsAskedOncePerThousandPairsAndHeard() {
        int n = 300;
        Scene scene = rings(n);
        // Each ring looks at all others, and then is told of all others.
        int pairs = 2 * n * (n - 1);
        int polls = polls(scene);
        assertTrue(polls >= pairs / POLLED, polls + " times");
        for (int at : new int[] {1, polls / 2, polls}) {
            AtomicInteger asked = new AtomicInteger();
            assertThrows(
                    CancellationException.class,
                    () -> SceneCompiler.compile(
                            scene, RenderSettings.of(scene), new SceneImages(), () -> asked.incrementAndGet() >= at));
            assertEquals(at, asked.get());
        }
    }

    /** Each sphere has an x in common with all, and a y with 59. */
    @Test
    void ofAWallOfSpheresNotEachPairIsLookedAt() {
        Scene.Builder b = scene();
        int side = 60;
        for (int i = 0; i < side * side; i++) {
            b.object(Sphere.of(ExactPoint.of(0.1, 0.1 * (i % side), 0.1 * (i / side)), 0.03), WHITE);
        }
        // Each is looked at once for each of four numbers at most; other parts of compiling ask less than ten times
        // more.
        int numbers = 4 * side * side;
        int pairs = side * side * (side * side - 1) / 2;
        int polls = polls(b.build());
        assertTrue(polls < 10 * numbers / POLLED && polls < pairs / POLLED / 10, polls + " times");
    }

    @Test
    void spheresAroundOneCentreAreToldApartByTheirRadii() {
        Scene.Builder b = scene();
        int n = 2000;
        for (int i = 0; i < n; i++) {
            b.object(Sphere.of(ExactPoint.of(0.1, 0.2, 0.3), 1 + 1.0 * i / n), WHITE);
        }
        int polls = polls(b.build());
        assertTrue(polls < 10 * 4 * n / POLLED && polls < n * (n - 1) / 2 / POLLED / 10, polls + " times");
    }
}
