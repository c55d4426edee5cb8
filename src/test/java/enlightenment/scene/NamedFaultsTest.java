package enlightenment.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayCurve;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Sphere;
import enlightenment.image.ImageFiles;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import enlightenment.net.RenderWorker;
import java.math.BigDecimal;
import java.util.Collections;
import java.util.LinkedList;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;

/** Who makes a scene in a program sees from the message alone which value is meant. */
class NamedFaultsTest {
    private static final ExactPoint O = ExactPoint.ORIGIN;
    private static final Texture WHITE = Texture.of(DisplayRgb.WHITE);

    private static void fails(String message, Executable maker) {
        InvalidValueException e = assertThrows(InvalidValueException.class, maker);
        assertEquals(message, e.getMessage());
        assertEquals(message, e.key().isEmpty() ? e.problem() : e.key() + ": " + e.problem());
    }

    @Test
    void theMessageBeginsWithTheKey() {
        fails("radius: must be a number greater than 0, not -1.0", () -> Sphere.of(O, -1));
        fails("rotation: must be a finite number, not NaN", () -> new Sphere(O, 1, Double.NaN));
        fails("top: must differ from \"base\"", () -> new Cylinder(O, O, 1, true));
        fails("max/1: must be greater than the same coordinate of \"min\"", () -> new Box(O, ExactPoint.of(1, 0, 1)));
        fails("transparency: must lie in 0.0..1.0, not 2.0", () -> new Glass(WHITE, 1, 2, 0, true));
        fails("opaque: must be matte, glossy, coated or principled, not mirror", () -> new Glass(WHITE, 1, 0.5, 0, true)
                .withOpaque(Material.Mirror.of(WHITE)));
        fails("opaque: must stand with a \"transparency\" below 1", () -> Glass.of(WHITE, 1.5)
                .withOpaque(Material.Matte.of(WHITE)));
        fails(
                "smoothRefraction: must stand without \"roughness\": rough glass refracts by the normals of its triangles",
                () -> Glass.of(WHITE, 1.5).withRoughness(0.5).withSmoothRefraction(true));
        fails("roughness: must lie in 0.0..1.0, not 2.0", () -> Glass.of(WHITE, 1.5)
                .withRoughness(2));
        fails("clearcoat: must lie in 0.0..1.0, not 2.0", () -> Principled.of(WHITE, 0, 0)
                .withClearcoat(2, 0));
        fails("clearcoatRoughness: must lie in 0.0..1.0, not 2.0", () -> Principled.of(WHITE, 0, 0)
                .withClearcoat(1, 2));
        fails("radius: must be a number greater than 0, not 0.0", () -> new Light.Sphere(O, 0, DisplayRgb.WHITE));
        fails(
                "intensity: belongs to point lights; a sphere light has \"radiance\" or \"power\"",
                () -> new Light.Sphere(O, 1, DisplayRgb.WHITE, Emission.INTENSITY_1));
        fails(
                "radiance: belongs to lights with a surface; a point light has \"intensity\" or \"power\"",
                () -> new Light.Point(O, DisplayRgb.WHITE, Emission.RADIANCE_1));
        fails(
                "power: times the light's colour is beyond the range of doubles",
                () -> new Light.Point(O, Rgb.gray(1e200), Emission.power(Rgb.gray(1e200))));
        fails(
                "radiance: times the light's colour must be at most 1e100",
                () -> new Light.Sphere(O, 1, Rgb.gray(2), Emission.radiance(Rgb.gray(1e100))));
        fails("radiance: must be at most 1e100", () -> new Shading.Background.Constant(new Rgb(0, 1.5e100, 0)));
        fails("ultraviolet: must be at most 1e100", () -> Emission.RADIANCE_1.withUltraviolet(2e100));
        fails(
                "color: reflects more than it receives: no component of a surface's colour may be above 1, as 1.25 is",
                () -> Glossy.of(Texture.of(new Rgb(0, 1.25, 0)), 0.5));
        fails(
                "color: reflects more than it receives: no component of a surface's colour may be above 1, as 2.0 is",
                () -> Material.Matte.of(new Texture.Checker(List.of(DisplayRgb.WHITE, Rgb.gray(2)), 4)));
        fails("roughness: must lie in 0.0..1.0, not 2.0", () -> Material.Matte.of(WHITE)
                .withRoughness(2));
        fails("eta: must be a number greater than 0, not 0.0", () -> new Glossy.Conductor(Rgb.BLACK, Rgb.WHITE));
        fails(
                "exposure: must lie in -1000.0..1000.0, not NaN",
                () -> new Scene.Display(Double.NaN, DisplayCurve.Tone.CLIP));
        fails("ambient: must lie in 0.0..1.0, not 3.0", () -> new Shading.Classic(3, 0, DisplayRgb.BLACK, 1));
        fails("g: must lie in 0.0..1.0, not 255.0", () -> DisplayRgb.of(0, 255, 0));
        fails("y: must be a finite number, not Infinity", () -> ExactPoint.of(0, 1 / 0.0, 0));
        fails("depth: must be 8 or 16 bits per component, not 24", () -> new ImageFiles.PngOptions(24, Map.of()));
        fails("pin: must have 64 hexadecimal digits, not \"x\"", () -> RenderWorker.Options.builder()
                .pin("x"));
    }

    @Test
    void corners() {
        ExactPoint p = ExactPoint.of(0, 1, 0);
        ExactPoint far = ExactPoint.of(9, 9, 9);
        ExactPoint q = ExactPoint.of(1, 0, 0);
        InvalidValueException e = assertThrows(InvalidValueException.class, () -> new Rectangle(O, p, far, q));
        assertEquals("corners/2", e.key());
        e = assertThrows(
                InvalidValueException.class, () -> new Camera.Window(ExactPoint.of(0, 0, -1), O, p, far, q, 0));
        assertEquals("upperRight", e.key());
        assertEquals("upperRight: " + e.problem(), e.getMessage());
    }

    @Test
    void settings() {
        Camera camera = new Camera.Perspective(ExactPoint.of(0, 0, -5), O, Vec3.Y, 40);
        Scene scene = Scene.builder().size(8, 8).camera(camera).build();
        RenderSettings s = RenderSettings.of(scene);
        fails("threads: must lie in 1..4096, not 0", () -> s.withThreads(0));
        fails("antialias: must lie in 1..256, not 0", () -> s.withAntialias(0));
        fails(
                "samples: must lie in 1..16777216, not 0.5",
                () -> s.withBudget(RenderSettings.Budget.NONE.withSamples(0.5)));
        fails(
                "method: must be one of " + Method.words(Method.selectable()) + ", not \"magic\"",
                () -> Method.named("magic"));
    }

    @Test
    void theSceneNamesItsObjects() {
        Camera camera = new Camera.Perspective(ExactPoint.of(0, 0, -5), O, Vec3.Y, 40);
        SceneObject ball = new SceneObject("ball", Sphere.of(O, 1), Material.Matte.of(WHITE), java.util.List.of());
        Scene.Builder twice =
                Scene.builder().size(8, 8).camera(camera).object(ball).object(ball);
        fails("objects/1/name: \"ball\" is used twice", twice::build);
    }

    @Test
    void whatIsMissingIsNamedToo() {
        assertEquals(
                "center",
                assertThrows(NullPointerException.class, () -> Sphere.of(null, 1))
                        .getMessage());
        assertEquals(
                "top",
                assertThrows(NullPointerException.class, () -> new Cylinder(O, null, 1, true))
                        .getMessage());
    }

    @Test
    void namedThingsOfASceneAreThereAndHaveNames() {
        Material matte = Material.Matte.of(WHITE);
        nullFails("the name of a material", () -> scene().material(null, matte).build());
        nullFails("the material \"x\"", () -> scene().material("x", null).build());
        nullFails("the name of a texture", () -> scene().texture(null, WHITE).build());
        nullFails("the texture \"x\"", () -> scene().texture("x", null).build());
    }

    @Test
    void listsAndMapsOfASceneAreThereAndSoIsAllThatTheyHold() {
        nullFails("the light 1", () -> scene().light(new Light.Point(O, DisplayRgb.WHITE))
                .light(null)
                .build());
        nullFails("the object 0", () -> scene().object((SceneObject) null).build());
        Scene s = scene().build();
        nullFails("textures", () -> with(s, null, s.materials(), s.lights(), s.objects(), s.instants()));
        nullFails("materials", () -> with(s, s.textures(), null, s.lights(), s.objects(), s.instants()));
        nullFails("lights", () -> with(s, s.textures(), s.materials(), null, s.objects(), s.instants()));
        nullFails("objects", () -> with(s, s.textures(), s.materials(), s.lights(), null, s.instants()));
        nullFails("instants", () -> with(s, s.textures(), s.materials(), s.lights(), s.objects(), null));
        nullFails(
                "the instant 0",
                () -> with(s, s.textures(), s.materials(), s.lights(), s.objects(), Collections.singletonList(null)));
    }

    /** A linked list walks to each place that it is asked for: lists are gone through once. */
    @Test
    void listsAreNotAskedForTheirThingsByPlace() {
        LinkedList<Light> lights = new LinkedList<>() {
            private static final long serialVersionUID = 1;

            @Override
            public Light get(int index) {
                throw new AssertionError("asked for " + index);
            }
        };
        lights.add(new Light.Point(O, DisplayRgb.WHITE));
        Scene s = scene().build();
        assertEquals(
                lights,
                with(s, s.textures(), s.materials(), lights, s.objects(), s.instants())
                        .lights());
    }

    private static Scene with(
            Scene s,
            Map<String, Texture> textures,
            Map<String, Material> materials,
            List<Light> lights,
            List<SceneObject> objects,
            List<Scene> instants) {
        return new Scene(
                s.name(),
                s.width(),
                s.height(),
                s.camera(),
                s.shading(),
                s.display(),
                textures,
                materials,
                lights,
                objects,
                s.render(),
                s.animation(),
                instants);
    }

    @Test
    void anAnimationHasTracksAndItsTracksHaveKeys() {
        nullFails("tracks", () -> new Animation(10, 25, null));
        nullFails("the track 0", () -> new Animation(10, 25, Collections.singletonList(null)));
        nullFails("keys", () -> new Animation.Track("/seed", null));
    }

    private static Scene.Builder scene() {
        return Scene.builder().camera(new Camera.Orthographic(ExactPoint.of(0, 0, -5), O, new Vec3(0, 1, 0), 4));
    }

    private static void nullFails(String message, Executable maker) {
        assertEquals(message, assertThrows(NullPointerException.class, maker).getMessage());
    }

    @Test
    void aTrackHasATargetAndValuesAtFrames() {
        NavigableMap<Integer, BigDecimal> keys = new TreeMap<>(Map.of(0, BigDecimal.ONE, 5, BigDecimal.TEN));
        nullFails("target", () -> new Animation.Track(null, keys));
        NavigableMap<Integer, BigDecimal> without = new TreeMap<>(keys);
        without.put(3, null);
        nullFails("the value at frame 3", () -> new Animation.Track("/seed", without));
        NavigableMap<Integer, BigDecimal> before = new TreeMap<>(Map.of(-2, BigDecimal.ONE));
        fails("keys/-2: must be the number of a frame, at least 0", () -> new Animation.Track("/seed", before));
    }

    @Test
    void coordinatesHaveExponentsThatCanBeReckonedWith() {
        String problem = "must be 0 or between 1e-10000 and 1e10000 in size";
        fails("y: " + problem + ", not about 1e2147483000", () -> ExactPoint.of("0", "1e2147483000", "0"));
        fails("z: " + problem + ", not about 1e-2147483000", () -> ExactPoint.of("0", "0", "-1e-2147483000"));
        fails(
                "x: " + problem + ", not about 1e10000",
                () -> new ExactPoint(new BigDecimal("12345678901234567890e9981"), BigDecimal.ONE, BigDecimal.ZERO));
        assertEquals(
                new BigDecimal("1e-9999"), ExactPoint.of("1e-9999", "0", "0").x());
        assertEquals(
                new BigDecimal("0"), ExactPoint.of("0e2147483000", "0", "0").x());
        fails("x: " + problem + ", not about 1e2147483647", () -> ExactPoint.of("123e2147483645", "0", "0"));
    }
}
