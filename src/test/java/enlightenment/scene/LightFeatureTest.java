package enlightenment.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Sphere;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.render.Renderer;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;

class LightFeatureTest {
    private static final Texture GRAY = Texture.of(Rgb.gray(0.5));
    private static final Sphere BALL = Sphere.of(ExactPoint.ORIGIN, 1);
    private static final Medium MILK = Medium.Colored.of(Rgb.gray(0.5), Rgb.gray(0.25));
    private static final Material WAX = Material.Scattering.of(MILK);
    private static final Material MARKER = new Material.Fluorescent(
            GRAY, new Material.WavelengthBand(320, 450), new Material.WavelengthBand(500, 600), 0.5);
    private static final Material PRISM = Glass.of(GRAY, 1.5).withDispersion(36);

    private static Scene.Builder scene(Shading shading) {
        return Scene.builder()
                .size(4, 4)
                .camera(new Camera.Perspective(ExactPoint.of(0, 0, -5), ExactPoint.ORIGIN, Vec3.Y, 40))
                .shading(shading);
    }

    private static Scene.Builder physical() {
        return scene(Shading.Physical.DEFAULT);
    }

    private static Shading.Physical in(Shading.Background background, Optional<Medium> medium) {
        return new Shading.Physical(OptionalInt.empty(), background, medium);
    }

    @Test
    void aSceneAsksForWhatItsObjectsAndItsShadingAreMadeOfAndSaysWhere() {
        assertEquals(
                Map.of(),
                Shading.LightFeature.of(
                        physical().object(BALL, Material.Matte.of(GRAY)).build()));
        assertEquals(
                Map.of(Shading.LightFeature.SCATTERING, "/objects/1/material/type"),
                Shading.LightFeature.of(physical()
                        .object(BALL, Material.Matte.of(GRAY))
                        .object(BALL, WAX)
                        .object(BALL, WAX)
                        .build()));
        assertEquals(
                Map.of(Shading.LightFeature.FLUORESCENCE, "/materials/a~1b/type"),
                Shading.LightFeature.of(
                        physical().material("a/b", MARKER).object(BALL, MARKER).build()));
        SceneObject cube =
                new SceneObject("", new Cube(ExactPoint.ORIGIN, 1, Vec3.ZERO), WAX, Collections.nCopies(6, PRISM));
        assertEquals(
                Map.of(
                        Shading.LightFeature.SCATTERING,
                        "/objects/0/material/type",
                        Shading.LightFeature.DISPERSION,
                        "/objects/0/faces/0/dispersion"),
                Shading.LightFeature.of(physical().object(cube).build()));
        assertEquals(
                Map.of(
                        Shading.LightFeature.SCATTERING,
                        "/shading/medium",
                        Shading.LightFeature.SURROUNDINGS,
                        "/shading/background"),
                Shading.LightFeature.of(scene(in(Shading.Background.Sky.of(30, 0), Optional.of(MILK)))
                        .build()));
    }

    @Test
    void whatHasNoEffectIsNotAskedFor() {
        Scene scene = physical()
                .material("wax", WAX)
                .object(BALL, Glass.of(GRAY, 1).withDispersion(36))
                .object(BALL, new Glass(GRAY, 1.5, 0, 0, true).withDispersion(36))
                .build();
        assertEquals(Map.of(), Shading.LightFeature.of(scene));
        assertEquals(
                Map.of(),
                Shading.LightFeature.of(
                        scene(Shading.Classic.DEFAULT).object(BALL, PRISM).build()));
        assertEquals(
                Map.of(),
                Shading.LightFeature.of(scene(in(new Shading.Background.Constant(Rgb.WHITE), Optional.empty()))
                        .build()));
    }

    @Test
    void aMethodThatCannotRenderAFeatureRefusesTheSceneByNameAndPlaceBeforeTheFirstRay() {
        for (Material material : List.of(WAX, MARKER, PRISM)) {
            Scene scene = physical().object(BALL, material).build();
            Shading.LightFeature feature = Shading.LightFeature.of(material);
            for (Method method : BuiltInMethod.ALL) {
                RenderSettings settings = RenderSettings.of(scene).withMethod(method);
                assertEquals(method.canRender(feature), Method.supports(method, scene));
                if (method.canRender(feature)) {
                    Renderer.inspect(scene, settings);
                } else {
                    SceneException e = assertThrows(SceneException.class, () -> Renderer.inspect(scene, settings));
                    assertEquals(
                            Shading.LightFeature.of(scene).get(feature),
                            e.problems().get(0).pointer());
                    String said = e.problems().get(0).message();
                    assertTrue(
                            said.startsWith("the method " + method.word() + " cannot render " + feature.description()),
                            said);
                }
            }
        }
    }

    @Test
    void aMethodFromOutsideCanRenderNoneOfIt() {
        Method toy = Method.named(ToyMethod.WORD);
        for (Shading.LightFeature feature : Shading.LightFeature.values()) {
            assertFalse(toy.canRender(feature));
        }
        Scene scene = physical().object(BALL, WAX).build();
        SceneException e = assertThrows(SceneException.class, () -> Method.requireSupport(toy, scene));
        assertTrue(
                e.getMessage()
                        .startsWith(
                                "/objects/0/material/type: the method toy cannot render media that scatter light; "),
                e.getMessage());
    }

    @Test
    void classicShadingRefusesWhatItDoesNotKnowAndIgnoresWhatItKnowsInPart() {
        for (Material material : List.of(WAX, MARKER)) {
            Scene.Builder scene = scene(Shading.Classic.DEFAULT).object(BALL, material);
            assertThrows(enlightenment.math.InvalidValueException.class, scene::build);
        }
        scene(Shading.Classic.DEFAULT).object(BALL, PRISM).build();
    }

    @Test
    void everyFeatureIsSaidInOtherWords() {
        assertEquals(
                Shading.LightFeature.values().length,
                Set.copyOf(java.util.Arrays.stream(Shading.LightFeature.values())
                                .map(Shading.LightFeature::description)
                                .toList())
                        .size());
    }
}
