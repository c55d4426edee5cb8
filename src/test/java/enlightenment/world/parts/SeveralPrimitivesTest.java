package enlightenment.world.parts;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.bsdf.SpecularReflection;
import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.film.FilmTile;
import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Triangle;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.method.RayTraceMethod;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Primitives;
import enlightenment.primitive.Ray;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.Tracer;
import enlightenment.world.light.SceneImages;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** An object may be several primitives: here each rectangle is placed as two triangles. */
class SeveralPrimitivesTest {
    private static final int WIDTH = 40;
    private static final int HEIGHT = 30;

    private static final Material RED = Material.Matte.of(Texture.of(new DisplayRgb(0.9, 0.2, 0.1)));
    private static final Material BLUE = Material.Mirror.of(Texture.of(new DisplayRgb(0.1, 0.2, 0.9)));

    private static List<Shape> halves(Rectangle r) {
        return List.of(
                new Triangle(r.lowerLeft(), r.upperLeft(), r.upperRight()),
                new Triangle(r.lowerLeft(), r.upperRight(), r.lowerRight()));
    }

    private static List<Primitive> inHalves(Shape shape, SceneFrame frame) {
        return shape instanceof Rectangle r
                ? halves(r).stream().map(s -> Primitives.place(s, frame)).toList()
                : Primitives.placeAll(shape, frame);
    }

    private static Rectangle rectangle(double x, double y, double z, double size) {
        ExactPoint corner = ExactPoint.of(x, y, z);
        Vec3 u = new Vec3(size, 0, size / 2);
        Vec3 v = new Vec3(0, size, -size / 4);
        return new Rectangle(corner, corner.plus(v), corner.plus(v).plus(u), corner.plus(u));
    }

    private static List<SceneObject> objects() {
        Random random = new Random(4);
        List<SceneObject> objects = new ArrayList<>();
        for (int i = 0; i < 20; i++) {
            // Some with the same first coordinate.
            double x = i % 3 == 0 ? -1 : 4 * random.nextDouble() - 3;
            Shape shape = i % 4 == 3
                    ? Sphere.of(ExactPoint.of(x, random.nextDouble(), 3), 0.25)
                    : rectangle(x, 4 * random.nextDouble() - 2, 3 + 4 * random.nextDouble(), 1);
            objects.add(SceneObject.of(shape, i % 5 == 0 ? BLUE : RED));
        }
        return objects;
    }

    private static Scene scene(List<SceneObject> objects) {
        Scene.Builder b = Scene.builder()
                .size(WIDTH, HEIGHT)
                .camera(new Camera.Perspective(ExactPoint.ORIGIN, ExactPoint.of(0, 0, 5), Vec3.Y, 60))
                .light(new Light.Sphere(ExactPoint.of(3, 5, -4), 0.5, DisplayRgb.WHITE));
        objects.forEach(b::object);
        return b.build();
    }

    private static CompiledScene compile(Scene scene, int loopLimit) {
        return SceneCompiler.compile(
                scene,
                RenderSettings.of(scene),
                loopLimit,
                new SceneImages(),
                SeveralPrimitivesTest::inHalves,
                () -> {});
    }

    private static double[] render(CompiledScene compiled, Scene scene) {
        RenderSettings settings = RenderSettings.of(scene).withAntialias(2).with(new BuiltInMethod.RayTraceSettings(3));
        FilmTile tile = new FilmTile(0, 0, WIDTH, HEIGHT);
        RayTraceMethod.of(compiled, settings, new RayCounters(compiled.kindNames.size()), 0)
                .render(tile);
        double[] means = new double[3 * WIDTH * HEIGHT];
        for (int i = 0; i < means.length; i++) {
            means[i] = tile.mean(i / 3 % WIDTH, i / 3 / WIDTH, i % 3);
        }
        return means;
    }

    @Test
    void thePictureIsThatOfTheParts() {
        List<SceneObject> parts = new ArrayList<>();
        for (SceneObject o : objects()) {
            List<Shape> shapes = o.shape() instanceof Rectangle r ? halves(r) : List.of(o.shape());
            shapes.forEach(s -> parts.add(SceneObject.of(s, o.material())));
        }
        Scene scene = scene(objects());
        Scene inParts = scene(parts);
        double[] expected = render(SceneCompiler.compile(inParts, RenderSettings.of(inParts), false), inParts);
        assertTrue(Arrays.stream(expected).distinct().count() > 100);
        assertArrayEquals(expected, render(compile(scene, Integer.MAX_VALUE), scene));
        assertArrayEquals(expected, render(compile(scene, -1), scene));
    }

    @Test
    void eachPrimitiveKnowsItsObject() {
        List<SceneObject> objects = objects();
        CompiledScene compiled = compile(scene(objects), -1);
        assertEquals(20, compiled.objects);
        assertEquals(35, compiled.primitives.length);
        assertEquals(List.of("rectangle", "sphere"), compiled.kindNames);
        int[] parts = new int[objects.size()];
        for (int id = 0; id < compiled.primitives.length; id++) {
            SceneObject o = objects.get(compiled.object[id]);
            parts[compiled.object[id]]++;
            assertEquals(o.shape().type(), compiled.kindNames.get(compiled.kind[id]));
            assertEquals(
                    o.material().type().equals("mirror"), compiled.material(id, 0).bsdf instanceof SpecularReflection);
        }
        for (int i = 0; i < parts.length; i++) {
            assertEquals(objects.get(i).shape() instanceof Rectangle ? 2 : 1, parts[i]);
        }
    }

    @Test
    void aRayThroughEitherHalfMeetsTheObject() {
        Scene scene = scene(List.of(SceneObject.of(rectangle(-1, -1, 3, 2), RED)));
        for (int loopLimit : new int[] {-1, Integer.MAX_VALUE}) {
            CompiledScene compiled = compile(scene, loopLimit);
            Tracer tracer = new Tracer(compiled, new RayCounters(1));
            int[] met = new int[2];
            for (double x : new double[] {-0.2, 0.2}) {
                assertTrue(tracer.trace(Ray.of(Vec3.ZERO, new Vec3(x, -x, 3)), new Hit()));
                met[tracer.id]++;
                assertEquals(0, compiled.object[tracer.id]);
            }
            assertArrayEquals(new int[] {1, 1}, met);
        }
    }

    @Test
    void theOrderInTheFileHasNoInfluenceEvenWhereNumbersAndPlacesAreTheSame() {
        List<SceneObject> objects = new ArrayList<>(objects());
        // Twice the same surface, of one material and of two.
        objects.add(objects.get(0));
        objects.add(SceneObject.of(objects.get(1).shape(), BLUE));
        objects.add(SceneObject.of(objects.get(3).shape(), BLUE));
        Scene scene = scene(objects);
        CompiledScene expected = compile(scene, -1);
        assertEquals(35, expected.primitives.length);
        double[] picture = render(expected, scene);
        Random random = new Random(6);
        for (int i = 0; i < 4; i++) {
            Collections.shuffle(objects, random);
            Scene shuffled = scene(objects);
            CompiledScene compiled = compile(shuffled, -1);
            for (int id = 0; id < expected.primitives.length; id++) {
                assertArrayEquals(expected.primitives[id].parameters(), compiled.primitives[id].parameters());
                assertEquals(
                        expected.material(id, 0).appearance(),
                        compiled.material(id, 0).appearance());
            }
            assertArrayEquals(picture, render(compiled, shuffled));
        }
    }
}
