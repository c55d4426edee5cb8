package enlightenment.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Sphere;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Materials that look different have different texts: what is compared where surfaces touch, and between machines. */
class MaterialAppearanceTest {
    private static final Texture GREY = Texture.of(Rgb.gray(0.5));
    private static final Texture.Amount CHECKS =
            Texture.Amount.of(new Texture.Checker(List.of(Rgb.gray(0.25), Rgb.gray(0.75)), 2));

    private static String text(Material material) {
        Scene scene = Scene.builder()
                .size(4, 4)
                .camera(new Camera.Perspective(ExactPoint.of(0, 0, -5), ExactPoint.ORIGIN, Vec3.Y, 50))
                .shading(Shading.Physical.DEFAULT)
                .object(Sphere.of(ExactPoint.ORIGIN, 1), material)
                .build();
        return SceneCompiler.compile(scene, RenderSettings.of(scene))
                .material(0, 0)
                .appearance();
    }

    private static Principled varnished(Texture.Amount roughness, Texture.Amount clear) {
        return Principled.of(GREY, 0, 0).withRoughness(roughness).withClearcoat(new Principled.Clearcoat(0.5, clear));
    }

    @Test
    void aTextureOfRoughnessLooksUnlikeThatOfTheClearCoat() {
        Texture.Amount low = Texture.Amount.of(0.25);
        assertEquals(text(varnished(CHECKS, low)), text(varnished(CHECKS, low)));
        assertNotEquals(text(varnished(CHECKS, low)), text(varnished(low, CHECKS)));
        assertNotEquals(text(varnished(CHECKS, low)), text(varnished(CHECKS, CHECKS)));
    }

    @Test
    void glassOfATexturedRoughnessLooksUnlikeGlassOfANumber() {
        Glass glass = Glass.of(GREY, 1.5);
        assertNotEquals(text(glass), text(glass.withRoughness(CHECKS)));
        assertNotEquals(text(glass.withRoughness(0.25)), text(glass.withRoughness(CHECKS)));
        assertNotEquals(
                text(glass.withRoughness(CHECKS)), text(Glass.of(GREY, 1.25).withRoughness(CHECKS)));
    }
}
