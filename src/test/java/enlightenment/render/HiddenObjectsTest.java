package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * What nobody can see and what throws no shadow on anything that is seen changes no bit: a speck beyond a wall, behind the viewer
 * or in an opaque solid, of every kind of primitive, in every shipped scene of classic shading, with both methods.
 */
class HiddenObjectsTest {
    private static final Material RED = TestScenes.matte(1, 0, 0);

    /** Small enough that no ray of these small pictures meets a speck that is not hidden. */
    private static final double SIZE = 1e-7;

    static List<String> shipped() throws IOException {
        try (Stream<Path> files = Files.list(folder())) {
            return files.map(f -> f.getFileName().toString())
                    .filter(f -> f.endsWith(".json"))
                    .filter(HiddenObjectsTest::isClassic)
                    .sorted()
                    .toList();
        }
    }

    private static boolean isClassic(String name) {
        return SceneReader.read(folder().resolve(name)).shading().model() == Shading.Model.CLASSIC;
    }

    private static Path folder() {
        return Path.of(System.getProperty("project.directory"), "scenes");
    }

    private static List<Shape> specks(ExactPoint c) {
        double s = SIZE;
        ExactPoint x = c.plus(new Vec3(s, 0, 0));
        ExactPoint y = c.plus(new Vec3(0.2 * s, s, 0.3 * s));
        return List.of(
                Sphere.of(c, s),
                new Box(c, c.plus(new Vec3(s, s, s))),
                new Cube(c, s, new Vec3(10, 35, 20)),
                new Cylinder(c, y, s, true),
                new Cylinder(c, y, s, false),
                new Cone(c, y, s, 0, true),
                new Torus(c, new Vec3(0.3, 1, -0.8), s, 0.4 * s),
                new Rectangle(c, y, y.plus(x.minus(c)), x),
                new Disk(c, new Vec3(0.2, 0.4, -1), s),
                new Triangle(c, y, x));
    }

    /** Behind the viewer, beyond the middle of every rectangle on both sides, and inside of every ball and cube. */
    private static Map<String, ExactPoint> places(Scene scene) {
        Map<String, ExactPoint> places = new LinkedHashMap<>();
        ExactPoint eye = scene.camera().origin();
        places.put("behind the viewer", eye.plus(new Vec3(0.013, 0.017, -31.7)));
        for (int i = 0; i < scene.objects().size(); i++) {
            SceneObject o = scene.objects().get(i);
            boolean opaque = !(o.material() instanceof Glass);
            if (o.shape() instanceof Rectangle r) {
                Vec3 middle = r.upperRight().minus(r.lowerLeft()).times(0.5);
                Vec3 n = r.upperLeft()
                        .minus(r.lowerLeft())
                        .cross(r.lowerRight().minus(r.lowerLeft()))
                        .normalized();
                boolean towardsEye = n.dot(eye.minus(r.lowerLeft())) > 0;
                places.put(
                        "beyond rectangle " + i, r.lowerLeft().plus(middle).plus(n.times(towardsEye ? -0.31 : 0.31)));
            } else if (o.shape() instanceof Sphere s && opaque) {
                places.put("in ball " + i, s.center().plus(new Vec3(0.1, 0.3, -0.2).times(s.radius())));
            } else if (o.shape() instanceof Cube c && opaque) {
                places.put("in cube " + i, c.center());
            }
        }
        return places;
    }

    private static Scene with(Scene scene, List<Shape> more) {
        List<SceneObject> objects = new ArrayList<>(scene.objects());
        more.forEach(s -> objects.add(SceneObject.of(s, RED)));
        return ImageInvarianceTest.withObjects(scene, objects);
    }

    /** The first and the last of the places of each sort. */
    private static Map<String, ExactPoint> ends(Map<String, ExactPoint> places) {
        List<String> names = List.copyOf(places.keySet());
        Map<String, ExactPoint> ends = new LinkedHashMap<>();
        for (String sort : List.of("behind", "beyond", "in ball", "in cube")) {
            List<String> same = names.stream().filter(n -> n.startsWith(sort)).toList();
            if (!same.isEmpty()) {
                ends.put(same.get(0), places.get(same.get(0)));
                ends.put(same.get(same.size() - 1), places.get(same.get(same.size() - 1)));
            }
        }
        return ends;
    }

    @Test
    void aSpeckThatNobodySeesChangesNoBit() throws IOException {
        int number = 0;
        Set<String> sorts = new TreeSet<>();
        for (String name : shipped()) {
            Map<String, ExactPoint> places = ends(places(SceneReader.read(folder().resolve(name))));
            places.keySet().forEach(p -> sorts.add(p.replaceAll(" \\d+", "")));
            number = check(name, places, number);
        }
        assertEquals(Set.of("behind the viewer", "beyond rectangle", "in ball", "in cube"), sorts);
        assertTrue(number >= specks(ExactPoint.ORIGIN).size(), "not every kind was alone: " + number);
    }

    @ParameterizedTest
    @Tag("full")
    @MethodSource("shipped")
    void norDoesItInAnyOtherPlace(String name) {
        assertTrue(check(name, places(SceneReader.read(folder().resolve(name))), 0) > 0);
    }

    /** Returns the number plus that of places; the kind that is alone goes by it. */
    private static int check(String name, Map<String, ExactPoint> places, int first) {
        Scene scene = SceneReader.read(folder().resolve(name));
        RenderSettings settings = RenderSettings.of(scene)
                .withSize(36, 24)
                .withThreads(1)
                .withAntialias(2)
                .with(new BuiltInMethod.RayTraceSettings(3))
                .withBudget(RenderSettings.Budget.NONE);
        RenderSettings cluster =
                settings.withMethod(Method.CLUSTER).withBudget(RenderSettings.Budget.NONE.withSamples(8));
        RawPicture evenly = RawPicture.of(scene, settings);
        RawPicture clustered = RawPicture.of(scene, cluster);
        int number = first;
        for (Map.Entry<String, ExactPoint> place : places.entrySet()) {
            List<Shape> all = specks(place.getValue());
            String where = place.getKey() + ", " + name;
            evenly.assertSameBits(RawPicture.of(with(scene, all), settings), where);
            clustered.assertSameBits(RawPicture.of(with(scene, all.subList(0, 4)), cluster), where + ", cluster");
            // Fewer objects than a hierarchy needs: every kind by itself, in turn.
            Shape one = all.get(number++ % all.size());
            evenly.assertSameBits(RawPicture.of(with(scene, List.of(one)), settings), where + ", " + one.type());
        }
        return number;
    }
}
