package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.geometry.Shape;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonPrinter;
import enlightenment.scene.json.tree.JsonValue;
import enlightenment.world.Descriptions;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Whoever adds a kind of shape, light, material, camera or texture and forgets one of the places that must know it, fails
 * here: reader and writer (a kind of the family), the random scenes that are written and read back ({@link
 * SceneWriterTest}), and, through the family, the schema ({@link SceneSchemaTest}) and the document ({@link
 * SceneFormatDocumentTest}).
 */
class SceneKindsTest {
    @TempDir
    static Path folder;

    /** A sealed type and what the format has for it. */
    record Sealed(Class<?> type, Family<?> family, Function<Scene, Stream<?>> values, Function<Object, String> name) {
        @Override
        public String toString() {
            return family.name();
        }
    }

    private static final List<Scene> SCENES = new java.util.ArrayList<>();

    @BeforeAll
    static void makeScenes() {
        RandomScenes scenes = new RandomScenes(5, Documents.withImage(folder));
        for (int i = 0; i < 200; i++) {
            SCENES.add(scenes.next());
        }
    }

    static List<Sealed> families() {
        return List.of(
                new Sealed(Camera.class, Cameras.FAMILY, s -> Stream.of(s.camera()), v -> ((Camera) v).type()),
                new Sealed(
                        Shape.class, Shapes.FAMILY, s -> s.objects().stream().map(SceneObject::shape), v -> ((Shape) v)
                                .type()),
                new Sealed(Material.class, Materials.FAMILY, s -> s.materials().values().stream(), v -> ((Material) v)
                        .type()),
                new Sealed(Light.class, Lights.FAMILY, s -> s.lights().stream(), v -> ((Light) v).type()),
                new Sealed(Texture.class, Textures.FAMILY, s -> s.textures().values().stream(), v -> null),
                new Sealed(Shading.Background.class, Backgrounds.FAMILY, SceneKindsTest::backgrounds, v -> null));
    }

    /** Those that are not just a colour, which the format writes as one. */
    private static Stream<?> backgrounds(Scene scene) {
        return scene.shading() instanceof Shading.Physical shading
                        && !(shading.background() instanceof Shading.Background.Constant)
                ? Stream.of(shading.background())
                : Stream.empty();
    }

    private static Set<Class<?>> leaves(Class<?> type) {
        Set<Class<?>> leaves = Descriptions.kinds(type).collect(Collectors.toSet());
        leaves.remove(Shading.Background.Constant.class);
        return leaves;
    }

    @Test
    void allFamiliesOfTheFormatAreTestedHere() {
        assertEquals(
                Vocabulary.families(),
                families().stream().map(Sealed::family).sorted(byOrder()).toList());
    }

    private static java.util.Comparator<Family<?>> byOrder() {
        return java.util.Comparator.comparingInt(f -> Vocabulary.families().indexOf(f));
    }

    @ParameterizedTest
    @MethodSource("families")
    void everyPermittedClassIsOneKindOfTheFormat(Sealed sealed) {
        Map<String, Class<?>> byName = new HashMap<>();
        for (Class<?> leaf : leaves(sealed.type())) {
            String type = sealed.family().typeOf(leaf);
            assertTrue(type != null, () -> leaf + " has no kind in the family " + sealed);
            assertEquals(null, byName.put(type, leaf), () -> type + " is two classes");
        }
        assertEquals(Set.copyOf(sealed.family().types()), byName.keySet());
    }

    @ParameterizedTest
    @MethodSource("families")
    void randomScenesHoldEveryKindUnderTheNameThatItGivesItself(Sealed sealed) {
        Set<Class<?>> found = new HashSet<>();
        SCENES.stream().flatMap(sealed.values()).forEach(value -> {
            found.add(value.getClass());
            String own = sealed.name().apply(value);
            assertTrue(own == null || own.equals(sealed.family().typeOf(value.getClass())), () -> "" + value);
        });
        assertEquals(leaves(sealed.type()), found);
    }

    @ParameterizedTest
    @MethodSource("families")
    void everyKeyOfEveryKindIsWritten(Sealed sealed) throws IOException {
        Map<String, Set<String>> written = new HashMap<>();
        for (Scene scene : SCENES) {
            Names names = new Names(scene, Path::toString);
            sealed.values().apply(scene).forEach(value -> {
                JsonObjectBuilder part = new JsonObjectBuilder(JsonPointer.ROOT, names);
                write(sealed.family(), value, part);
                JsonValue.Obj json = (JsonValue.Obj) part.json();
                String type = sealed.family().typeOf(value.getClass());
                written.computeIfAbsent(type, t -> new TreeSet<>()).addAll(List.of(json.keys()));
            });
        }
        for (String type : sealed.family().types()) {
            Set<String> expected = new TreeSet<>(sealed.family().keys(type).all());
            if (sealed.family() == Shapes.FAMILY) {
                // The object's own, whatever its shape.
                expected.removeAll(Set.of("material", "faces", "name"));
                // A scene keeps the meshes that its file names under the names of their files.
                expected.remove("mesh");
            }
            if (type.equals(sealed.family().typeUnlessGiven())) {
                expected.remove("type");
            }
            assertEquals(expected, written.get(type), type);
        }
    }

    @SuppressWarnings("unchecked") // The value comes from where the family's values are.
    private static <T> void write(Family<T> family, Object value, JsonObjectBuilder part) {
        family.write((T) value, part);
    }

    @Test
    void aClassThatTheFormatDoesNotKnowIsRefused() {
        Family<Object> family = new Family<Object>(
                        "thing",
                        "a thing",
                        null,
                        Map.of(),
                        (type, f) -> f.text("text", "a text"),
                        (s, p) -> p.text("text", (String) s))
                .with("word", String.class, "text |");
        JsonObjectBuilder part = new JsonObjectBuilder(JsonPointer.ROOT, null);
        assertThrows(IllegalStateException.class, () -> family.write(1, part));
        assertTrue(part.isEmpty());
        family.write("yes", part);
        assertEquals("{ \"type\": \"word\", \"text\": \"yes\" }\n", JsonPrinter.print(part.json()));
    }
}
