package enlightenment.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** The registry of methods, and what is chosen of their settings. */
class MethodTest {
    private static final Scene SCENE = scene(Shading.Classic.DEFAULT);

    private static Scene scene(Shading shading) {
        return Scene.builder()
                .camera(new Camera.Perspective(ExactPoint.ORIGIN, ExactPoint.of(0, 0, 1), new Vec3(0, 1, 0), 40))
                .shading(shading)
                .build();
    }

    @Test
    void theConstantsAreTheMethodsWhicheverIsLookedAtFirst() {
        assertSame(BuiltInMethod.RAYTRACE, Method.RAYTRACE);
        assertSame(BuiltInMethod.CLUSTER, Method.CLUSTER);
        assertSame(BuiltInMethod.METROPOLIS, Method.METROPOLIS);
        // An interface with default methods would be initialised before its constants exist.
        assertEquals(
                List.of(),
                List.of(Method.class.getMethods()).stream()
                        .filter(java.lang.reflect.Method::isDefault)
                        .toList());
    }

    @Test
    void aMethodFromOutsideIsFoundByItsWordAndListedBehindOurs() {
        Method toy = Method.named("toy");
        assertTrue(toy instanceof ToyMethod);
        assertSame(toy, Method.of("toy").orElseThrow());
        List<Method> all = Method.all();
        assertEquals(BuiltInMethod.ALL, all.subList(0, BuiltInMethod.ALL.size()));
        assertTrue(all.contains(toy));
        assertEquals(all.size(), new HashSet<>(Method.words()).size());
        assertTrue(Method.of("toys").isEmpty());
        assertThrows(InvalidValueException.class, () -> Method.named("toys"));
    }

    @Test
    void everyMethodSaysWhatItIs() {
        for (Method method : Method.all()) {
            assertTrue(method.word().matches("[a-z][a-z0-9-]*"), method.word());
            assertTrue(!method.description().isBlank() && !method.description().endsWith("."), method.word());
            assertTrue(!method.shadings().isEmpty(), method.word());
            for (Method.Setting setting : method.settings()) {
                assertEquals(setting.usual(), setting.checked(setting.usual()), setting.key());
                assertThrows(InvalidValueException.class, () -> setting.checked(null), setting.key());
                assertThrows(InvalidValueException.class, () -> setting.checked(0.5), setting.key());
            }
        }
    }

    @Test
    void optionsAreCalledAsTheirKeysAre() {
        assertEquals("--shadow-samples", BuiltInMethod.RayTraceSettings.SHADOW_SAMPLES.option());
        assertEquals("--proposal", BuiltInMethod.ClusterSettings.PROPOSAL.option());
        assertEquals("normal (default), zeta or linear", BuiltInMethod.ClusterSettings.PROPOSAL.range());
        assertEquals("1..1000000", BuiltInMethod.RayTraceSettings.SHADOW_SAMPLES.range());
    }

    @Test
    void whatIsChosenForOneMethodStaysWhenAnotherIsTaken() {
        RenderSettings s = RenderSettings.of(SCENE)
                .with(new BuiltInMethod.RayTraceSettings(3))
                .with(new BuiltInMethod.ClusterSettings("zeta"));
        for (Method method : Method.all()) {
            RenderSettings with = s.withMethod(method);
            assertEquals(3, BuiltInMethod.RayTraceSettings.of(with).shadowSamples());
            assertEquals("zeta", BuiltInMethod.ClusterSettings.of(with).proposal());
        }
        ToyMethod.Settings toy = new ToyMethod.Settings(5, "square");
        assertEquals(toy, ToyMethod.Settings.of(s.using(toy)));
        assertEquals("toy", s.using(toy).method().word());
        assertEquals(new ToyMethod.Settings(8, "round"), ToyMethod.Settings.of(s));
    }

    @Test
    void toChooseTheDefaultIsToChooseNothing() {
        ChosenSettings three = ChosenSettings.of(new BuiltInMethod.RayTraceSettings(3));
        assertEquals(Map.of("shadowSamples", 3L), three.values());
        assertNotEquals(ChosenSettings.NONE, three);
        assertEquals(ChosenSettings.NONE, three.with(new BuiltInMethod.RayTraceSettings(10)));
        assertEquals(
                ChosenSettings.NONE.hashCode(),
                three.with(new BuiltInMethod.RayTraceSettings(10)).hashCode());
        assertEquals(
                RenderSettings.of(SCENE), RenderSettings.of(SCENE).with(new BuiltInMethod.ClusterSettings("normal")));
    }

    @Test
    void wrongValuesAreRefusedByTheirKeys() {
        InvalidValueException e =
                assertThrows(InvalidValueException.class, () -> new BuiltInMethod.RayTraceSettings(0));
        assertEquals("shadowSamples", e.key());
        assertThrows(InvalidValueException.class, () -> new BuiltInMethod.RayTraceSettings(1_000_001));
        e = assertThrows(InvalidValueException.class, () -> new BuiltInMethod.ClusterSettings("gauss"));
        assertEquals("proposal", e.key());
        RenderSettings s = RenderSettings.of(SCENE);
        assertThrows(InvalidValueException.class, () -> s.with(BuiltInMethod.RayTraceSettings.SHADOW_SAMPLES, "ten"));
    }

    @Test
    void aStandInsSettingsHaveAnInfluenceToo() {
        assertEquals(
                List.of(BuiltInMethod.ClusterSettings.PROPOSAL, BuiltInMethod.RayTraceSettings.SHADOW_SAMPLES),
                Method.influences(Method.CLUSTER));
        assertEquals(List.of(BuiltInMethod.RayTraceSettings.SHADOW_SAMPLES), Method.influences(Method.RAYTRACE));
        assertEquals(List.of(ToyMethod.RAYS, ToyMethod.SHAPE), Method.influences(Method.named("toy")));
    }

    @Test
    void aShadingThatAMethodCannotRenderIsRefusedWithPlaceMethodAndWhatItCan() {
        Scene physical = scene(Shading.Physical.DEFAULT);
        for (Method method : Method.all()) {
            if (method.shadings().contains(Shading.Model.PHYSICAL)) {
                Method.requireSupport(method, physical);
                continue;
            }
            SceneException e = assertThrows(SceneException.class, () -> Method.requireSupport(method, physical));
            assertEquals("/shading/model", e.problems().get(0).pointer());
            String said = e.problems().get(0).message();
            assertTrue(
                    said.contains("the method " + method.word() + " cannot render physical shading, only classic"),
                    said);
            assertTrue(said.matches(".*; what can: .*\\btoy\\b.*"), said);
        }
        Method.requireSupport(Method.RAYTRACE, SCENE);
    }

    /** A method that is like another in some way. */
    private static Method like(String word, Method.Setting setting) {
        return new MethodExtension(
                word, "a double", Method.Kind.TILES, Set.of(Shading.Model.CLASSIC), List.of(setting)) {};
    }

    @Test
    void methodsThatCannotBeToldApartAreRefused() {
        Method.Setting.Whole own = BuiltInMethod.RayTraceSettings.SHADOW_SAMPLES;
        Extensions.requireDistinct(like("other", own), Method.RAYTRACE);
        assertThrows(
                IllegalStateException.class,
                () -> Extensions.requireDistinct(like(Method.RAYTRACE.word(), own), Method.RAYTRACE));
        Method.Setting.Whole wider =
                new Method.Setting.Whole(own.key(), own.min(), own.max() + 1, own.usualValue(), own.description());
        assertThrows(
                IllegalStateException.class, () -> Extensions.requireDistinct(like("other", wider), Method.RAYTRACE));
        assertThrows(IllegalArgumentException.class, () -> like("Other Method", own));
        assertThrows(IllegalArgumentException.class, () -> new Method.Setting.Whole("antialias", 0, 1, 0, "reserved"));
        for (Method.Setting common : ChosenSettings.Common.ALL) {
            assertThrows(IllegalArgumentException.class, () -> like("other", common), common.key());
            Method.Setting namesake = new Method.Setting.Whole(common.key(), 0, 1, 0, "reserved");
            assertThrows(IllegalArgumentException.class, () -> like("other", namesake), common.key());
        }
    }
}
