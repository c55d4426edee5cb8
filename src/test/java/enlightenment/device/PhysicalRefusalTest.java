package enlightenment.device;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.world.SceneCompiler;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** What of physical shading devices refuse, by name, each in a scene that they take without it. */
class PhysicalRefusalTest {
    private static final Texture GREY = Texture.of(new Rgb(0.5, 0.5, 0.5));
    private static final Texture CHECKER =
            new Texture.Checker(List.of(new DisplayRgb(1, 1, 1), new DisplayRgb(0, 0, 0)), 4);
    private static final Shape BALL = new Sphere(at(0, 0, 4), 1, 0);

    private static ExactPoint at(double x, double y, double z) {
        return ExactPoint.of(x, y, z);
    }

    private static Optional<String> refusal(Consumer<Scene.Builder> also) {
        Scene.Builder builder = Scene.builder()
                .size(8, 8)
                .camera(new Camera.Perspective(at(0, 0, -4), at(0, 0, 4), Vec3.Y, 40))
                .shading(Shading.Physical.DEFAULT)
                .object(floor(-2), Material.Matte.of(GREY))
                .light(new Light.Point(at(0, 3, 2), DisplayRgb.WHITE));
        also.accept(builder);
        Scene scene = builder.build();
        return DeviceScene.refusal(SceneCompiler.compile(scene, RenderSettings.of(scene)));
    }

    private static Rectangle floor(double y) {
        return new Rectangle(at(-4, y, 0), at(-4, y, 8), at(4, y, 8), at(4, y, 0));
    }

    private static void assertRefused(String why, Consumer<Scene.Builder> also) {
        assertEquals(Optional.of(why), refusal(also));
    }

    private static void assertRefused(String why, Shape shape, Material material) {
        assertRefused(why, b -> b.object(shape, material));
    }

    @Test
    void theRestOfTheseScenesIsTaken() {
        assertEquals(Optional.empty(), refusal(b -> b.object(BALL, new Glass(GREY, 1.5, 1, 0, true))));
        assertEquals(Optional.empty(), refusal(b -> b.object(BALL, glowing())));
    }

    private static Material.Matte glowing() {
        return Material.Matte.of(GREY).withRadiance(Rgb.WHITE);
    }

    @Test
    void glassThatIsOpaqueInPartIsRefused() {
        assertRefused("glass that is opaque in part", BALL, new Glass(GREY, 1.5, 0.5, 0, true));
    }

    @Test
    void panesAreRefused() {
        assertRefused("glass that does not turn rays, such as panes", floor(1), new Glass(GREY, 1.5, 1, 0, true));
    }

    @Test
    void aMaterialThatIsNotKnownIsRefused() {
        assertRefused("a material that devices do not know in physical shading", BALL, Principled.of(GREY, 0.5, 0.5));
    }

    @Test
    void aRoughnessByATextureIsRefused() {
        Glossy metal = Glossy.of(GREY, 0.5).withRoughness(Texture.Amount.of(CHECKER));
        assertRefused("a material that differs from place to place", BALL, metal);
    }

    @Test
    void aLightWithATextureIsRefused() {
        assertRefused("a light with a texture", floor(1), glowing().withRadianceMap(CHECKER));
    }

    @Test
    void aLightOfAnotherShapeIsRefused() {
        assertRefused("a light that is no point, ball or rectangle", new Disk(at(0, 1, 4), Vec3.Y, 1), glowing());
    }

    @Test
    void aLightThatLiesOnASurfaceIsRefused() {
        assertRefused("a light that lies on a surface", b -> b.object(floor(1), Material.Matte.of(GREY))
                .light(new Light.Rectangle(at(-1, 1, 3), at(-1, 1, 5), at(1, 1, 5), at(1, 1, 3), DisplayRgb.WHITE)));
    }

    @Test
    void aSpotlightIsRefused() {
        assertRefused(
                "a light that shines differently in each direction",
                b -> b.light(new Light.Spot(
                        at(0, 3, 4), new Vec3(0, -1, 0), 30, 10, DisplayRgb.WHITE, Emission.INTENSITY_1)));
    }
}
